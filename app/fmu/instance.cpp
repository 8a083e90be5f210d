#include "app/fmu/instance.h"

#include <stdexcept>

namespace fmu {

void Messages::note(const std::string& message) {
  if (on_) give(fmi3Warning, kWarnings, message);
}

void Messages::switch_on(bool on, const std::set<std::string>& categories) {
  for (const std::string& category : categories)
    if (category != kErrors && category != kWarnings)
      throw std::invalid_argument("there is no category '" + category + "'");
  if (categories.empty() || categories.contains(kWarnings)) on_ = on;
}

void Messages::give(fmi3Status status, const char* category, const std::string& message) const {
  if (callback_ != nullptr) callback_(environment_, status, category, message.c_str());
}

}  // namespace fmu

#include "app/base/reporter.h"

namespace app {

void Reporter::working_on(const std::string&) {}
void Reporter::done(const std::string&) {}
void Reporter::note(const std::string&) {}
void Reporter::warning(const std::string&) {}

Reporter& quiet() {
  static Reporter reporter;
  return reporter;
}

}  // namespace app

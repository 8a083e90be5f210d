#include "engine/for_each.h"

#include <exception>
#include <vector>

namespace engine {

void call_all(const ForEach& for_each, std::size_t count,
              const std::function<void(std::size_t)>& f) {
  std::vector<std::exception_ptr> faults(count);
  for_each(count, [&](std::size_t i) {
    try {
      f(i);
    } catch (...) {
      faults[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& fault : faults)
    if (fault) std::rethrow_exception(fault);
}

}  // namespace engine

#include "engine/base/parallel_for.h"

#include <exception>
#include <vector>

namespace engine {

void parallel_for_rethrow(const ParallelFor& parallel_for, std::size_t count,
                          const std::function<void(std::size_t)>& f) {
  std::vector<std::exception_ptr> faults(count);
  parallel_for(count, [&](std::size_t i) {
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

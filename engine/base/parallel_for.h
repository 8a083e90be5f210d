#pragma once

#include <cstddef>
#include <functional>

namespace engine {

/// Calls f(0) … f(count − 1), in any order, possibly at once.
using ParallelFor =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& f)>;

/// The same. All calls are made; then the exception of the first one that failed is thrown again,
/// so that a fault does not depend on the number of threads.
void parallel_for_rethrow(const ParallelFor& parallel_for, std::size_t count,
                          const std::function<void(std::size_t)>& f);

}  // namespace engine

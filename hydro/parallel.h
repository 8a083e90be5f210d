#pragma once

#include <tbb/parallel_for.h>

#include <cstddef>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

/// @file
/// Loops over several threads: the one place that knows the threading library.

namespace hydro {

/// Calls f(0) … f(count − 1), on as many threads as the caller's arena has, in no order. Results
/// must not depend on it: let each call write to a place of its own, and add up afterwards.
///
/// The thread sanitizer does not see how the library, which is not built with it, hands work from
/// thread to thread; it is told here that calls come after what stands before the loop and before
/// what stands behind it. Races between calls it finds.
template <class Function>
void parallel_for(std::size_t count, Function&& f) {
#if defined(__SANITIZE_THREAD__)
  char start = 0;
  char end = 0;
  __tsan_release(&start);
  const auto call = [&start, &end, &f ](std::size_t i) __attribute__((no_sanitize_thread)) {
    __tsan_acquire(&start);
    f(i);
    __tsan_release(&end);
  };
  tbb::parallel_for(std::size_t{0}, count, call);
  __tsan_acquire(&end);
#else
  tbb::parallel_for(std::size_t{0}, count, f);
#endif
}

}  // namespace hydro

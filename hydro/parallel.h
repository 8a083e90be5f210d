#pragma once

#include <tbb/parallel_for.h>

#include <cstddef>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

/// @file
/// Loops over several threads: the one place that knows the threading library.

namespace hydro {

/// Calls f(0) … f(count − 1) in any order, on as many threads as the caller's arena has. Results
/// must not depend on the order: each call writes to a place of its own, and sums are taken
/// afterwards.
///
/// The threading library is not built with the thread sanitizer, which therefore does not see how
/// work moves between threads. The annotations state that the calls run after the code before the
/// loop and before the code after it. Races between calls are still found.
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

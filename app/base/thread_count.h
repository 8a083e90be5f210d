#pragma once

#include <algorithm>
#include <thread>

namespace app {

/// Returns the number of threads of a command.
/// @param wanted   Number asked for; 0 stands for all hardware threads.
inline int thread_count(int wanted) {
  if (wanted > 0) return wanted;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace app

#pragma once

#include <algorithm>
#include <thread>

namespace app {

/// Threads of a command. @param wanted   0: as many as the machine has.
inline int thread_count(int wanted) {
  if (wanted > 0) return wanted;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace app

#pragma once

#include <algorithm>

namespace support {

/// Returns the number of random cases that a test tries, or of steps or seconds that it simulates:
/// `count`, but a quarter of it and at least one with a sanitizer, which makes every operation
/// several times slower. The cases are then the first of all.
constexpr int repeats(int count) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return std::max(1, count / 4);
#else
  return count;
#endif
}

}  // namespace support

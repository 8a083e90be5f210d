#pragma once

#include <algorithm>

namespace support {

/// How often a test repeats itself on random cases, or how many seconds it simulates: a quarter of
/// `count`, at least one, where a sanitizer makes every operation several times slower. The cases
/// taken are the same ones.
constexpr int repeats(int count) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return std::max(1, count / 4);
#else
  return count;
#endif
}

}  // namespace support

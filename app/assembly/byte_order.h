#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>
#include <string_view>

namespace assembly {

/// Returns the number that a file stores at a position, which must lie wholly in the bytes.
template <class T>
T value_at(std::string_view bytes, std::size_t position, std::endian order) {
  assert(position + sizeof(T) <= bytes.size());
  std::array<char, sizeof(T)> stored;
  std::memcpy(stored.data(), bytes.data() + position, sizeof(T));
  if (order != std::endian::native) std::reverse(stored.begin(), stored.end());
  return std::bit_cast<T>(stored);
}

}  // namespace assembly

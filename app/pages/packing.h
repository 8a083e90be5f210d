#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Numbers and bytes as they lie in a page: base64 of little-endian arrays.

namespace app {

std::string base64(std::string_view bytes);

/// The bytes of an array of plain numbers, as the machine has them: little-endian on those that
/// the program is built for.
template <class T>
std::string packed(std::span<const T> values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

/// A column of numbers: the number itself if it is always the same, else `{base, data}` with the
/// first number and the differences from it in single precision, so that no digit is lost where a
/// number is large and changes little.
nlohmann::ordered_json packed_column(const std::vector<double>& values);

}  // namespace app

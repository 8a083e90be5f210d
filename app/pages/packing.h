#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Numbers and bytes as a page stores them: base64 of little-endian arrays.

namespace app {

std::string base64(std::string_view bytes);

/// Returns the base64 of an array's bytes in the machine's order, which is little-endian on all
/// supported machines.
template <class T>
std::string packed(std::span<const T> values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

/// Packs a column of numbers. A constant column becomes its number, another one `{base, data}` with
/// the first number and the single-precision differences from it, so that small changes of large
/// numbers keep their digits.
nlohmann::ordered_json packed_column(const std::vector<double>& values);

}  // namespace app

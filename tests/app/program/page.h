#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/program/program.h"

/// @file
/// What the program puts into its pages: data around which a test's own page lies, so that nothing
/// hangs on npm.

namespace support {

/// Copies the program to `bin/plimsoll`, where it finds a page of that name beside it.
void lay_out_page(const Workplace& here, const std::string& name);

/// The data in such a page, once they are in their place and nothing in them ends it.
nlohmann::json data_in_page(const std::string& page);

/// The numbers of a base64 text (app/report/packing.h).
template <class T>
std::vector<T> packed_numbers(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned word = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    word = word << 6 | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<char>(word >> bits & 0xffU));
  }
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

}  // namespace support

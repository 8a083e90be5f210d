#pragma once

#include <stdexcept>
#include <string>

/// @file
/// Refusal of arguments from outside.

namespace hydro {

/// Throws std::invalid_argument, "NAME is VALUE, expected EXPECTED", if a condition is not met.
inline void require(bool met, const char* name, double value, const char* expected) {
  if (met) return;
  throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) + ", expected " +
                              expected);
}

}  // namespace hydro

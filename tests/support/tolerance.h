#pragma once

#include <cstdlib>

namespace support {

/// Factor on every tolerance: PLIMSOLL_TOL_SCALE=0 in the environment makes all comparisons fail
/// and print their true error.
inline double tolerance_scale() {
  static const double scale = [] {
    const char* text = std::getenv("PLIMSOLL_TOL_SCALE");
    return text ? std::atof(text) : 1.0;
  }();
  return scale;
}

/// Returns a tolerance of a test, scaled.
inline double tolerance(double value) { return value * tolerance_scale(); }

}  // namespace support

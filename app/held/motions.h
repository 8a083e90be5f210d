#pragma once

#include <cstddef>
#include <vector>

#include "hydro/spatial.h"

/// @file
/// The motion of the bodies of simulations as arrays, row by row, for NumPy.

namespace app {

/// The rows of one simulation; a row is a body.
struct MotionRows {
  double* time = nullptr;              ///< One number [s].
  double* position = nullptr;          ///< 3 a row: the centre of mass, in W [m].
  double* orientation = nullptr;       ///< 4 a row: R_WB as a quaternion w, x, y, z.
  double* velocity = nullptr;          ///< 3 a row: of the centre of mass, in W [m/s].
  double* angular_velocity = nullptr;  ///< 3 a row, in W [rad/s].
};

/// The motions of `simulations` simulations of `bodies` bodies each. The arrays stay in their
/// places.
class MotionArrays {
 public:
  MotionArrays(std::size_t simulations, std::size_t bodies);

  MotionRows rows(std::size_t simulation);
  /// The arrays of all simulations, one after the other.
  MotionRows all() { return rows(0); }

 private:
  std::size_t bodies_;
  std::vector<double> time_, position_, orientation_, velocity_, angular_velocity_;
};

void write(double time, const std::vector<hydro::BodyState>& states, const MotionRows& rows);

}  // namespace app

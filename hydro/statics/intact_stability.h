#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hydro/statics/equilibrium.h"

/// @file
/// Measures of the curve of righting arms of a whole, undamaged body, and the criteria that the
/// International Maritime Organization sets for them [IS08].
///
/// The curve is taken from 0° to 60° in steps of 1°, with height and trim in equilibrium. Areas are
/// by the trapezoidal rule, whose error for a smooth curve is (1°)²/12 times the change of its
/// slope: below 1e-4 m rad for levers up to a metre.
///
/// [IS08] International Code on Intact Stability, 2008. Resolution MSC.267(85), part A, 2.2.

namespace hydro {

/// A ship at sea: its outside, what floats it, and where water may come in.
struct IntactBody {
  const ImmersedMesh& mesh;
  double volume = 0;               ///< Displacement [m^3].
  const std::vector<Tank>& tanks;  ///< The water in it.
  /// Points through which water comes in when they are under water, in B.
  const std::vector<Eigen::Vector3d>& flooding_points_B;
};

/// Height of the lowest flooding point over the water at a heel [m]; none without such points.
std::optional<double> flooding_freeboard(const IntactBody& body, const RightingArm& arm);

/// A criterion of [IS08], 2.2.
struct Criterion {
  std::string name;
  double value = 0;
  double least = 0;  ///< The least value that is required.
  std::string unit;
  bool met() const { return value >= least; }
};

struct IntactStability {
  /// Heel at which water comes in [rad], to 1e-6; none up to 60°.
  std::optional<double> downflooding;
  std::vector<Criterion> criteria;
};

/// @param gm   Initial metacentric height of roll [m].
IntactStability intact_stability(const IntactBody& body, double gm);

}  // namespace hydro

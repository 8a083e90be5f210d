#pragma once

#include <vector>

#include "hydro/spatial.h"

/// @file
/// The resistance of a hull along its motion, beside the drag of its panels: that of the waves
/// which it makes as it goes, and of its form.
///
/// With the point P, the centre of the volume that the body displaces at rest, its horizontal
/// velocity w through the water, and the volume V displaced now and V_0 at rest,
///
///     F = −s R(|w|) w/|w|  in P,        s = min(1, 2 V/V_0),                                 (1)
///
/// so that its power −s R |w| is never positive. It is whole from half of the volume at rest on: a
/// hull that heaves and pitches keeps all of it, and one that leaves the water none.
///
/// The flow along a hull draws it down as well. In a point Q, with its velocity (w, w_z),
///
///     F = s k (w_z w − |w|² ẑ)  in Q,                                                        (2)
///
/// which is normal to the velocity of Q, so that it gives no power in any motion.

namespace hydro {

/// A resistance R over the speed: through the origin with the slope 0, monotone between its points
/// as they are, once continuously differentiable, and beyond the last one as the square of the
/// speed. Between points a cubic, whose slopes are those of parabolas through three points as far
/// as they leave it monotone [H83].
///
/// [H83] Hyman. Accurate monotonicity preserving cubic interpolation. SIAM J. Sci. Stat. Comput.
///       4 (1983) 645-654.
class ResistanceCurve {
 public:
  /// Makes a curve through the origin and these points.
  /// @param speeds   [m/s], > 0, ascending; at least one.
  /// @param forces   [N], >= 0; one a speed.
  ResistanceCurve(const std::vector<double>& speeds, const std::vector<double>& forces);

  double at(double speed) const;     ///< R [N]; the speed is >= 0.
  double slope(double speed) const;  ///< dR/dU [N s/m].

  /// Speeds of the points, with the origin [m/s].
  const std::vector<double>& speeds() const { return speeds_; }
  /// Forces of the points, with the origin [N].
  const std::vector<double>& forces() const { return forces_; }

 private:
  struct Cubic;
  Cubic cubic_at(double speed) const;

  std::vector<double> speeds_;
  std::vector<double> forces_;
  std::vector<double> slopes_;  ///< At the points.
};

/// The resistance of one body.
struct Resistance {
  ResistanceCurve curve;                                   ///< R over U.
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();          ///< P [m].
  double volume = 0;                                       ///< V_0 [m^3], > 0.
  double suction = 0;                                      ///< k [kg/m]
  Eigen::Vector3d suction_at_B = Eigen::Vector3d::Zero();  ///< Q [m].
};

/// The loads (1) and (2) about the centre of mass, in W.
/// @param water    Velocity of the water about the body [m/s].
/// @param volume   V [m^3].
Wrench resistance_load(const Resistance& resistance, const BodyState& state,
                       const Eigen::Vector3d& water, double volume);

/// Derivative of (1) with respect to the velocity about the centre of mass, in W: symmetric and
/// negative semi-definite, without the part by which R falls beyond a hump [N s/m, N s, N m s].
Matrix6d resistance_jacobian(const Resistance& resistance, const BodyState& state,
                             const Eigen::Vector3d& water, double volume);

}  // namespace hydro

#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "engine/base/spec.h"

/// @file
/// A force along one direction between two bodies that the constraint solver finds: that of a stiff
/// spring or rope, or of the drive of a joint.
///
/// A spring k with a damper c acts on the distance s, whose rate is J u, with the force
/// λ = k (e + h (a d⁺ − b d⁻)) + c ((1 − w) d⁻ + w d⁺). Here e is the distance to the rest halfway
/// through a substep of length h, d = r − J u its rate before and after the update, and r the rate
/// at which the rest itself moves. In the form of the solver,
///
///     J u⁺ + λ/g = r + (k e + (c (1 − w) − h k b) (r − J u⁻)) / g,    g = h k a + c w,      (E22)
///
/// a = b = ¼ and w = ½ are the implicit midpoint rule, of second order and without loss. With H the
/// step, a = H/h, w = 1 and b = 0 take what is missing away at the rate e/H, without overshoot. The
/// weights go from the first to the second as the step leaves the oscillation unresolved, so no
/// stiffness and no ratio of masses makes a line gain energy. The rate depends on the step and not
/// on the substep: a line that long substeps have stretched gives back no more in short ones. With
/// a = 1 a rope that is slack by −e lets its ends part by no more than that in a substep, so it is
/// not overstretched when it comes taut.

namespace engine {

struct ForceRow {
  BodyId first = kWorld;   ///< The force acts on it against `direction_W`.
  BodyId second = kWorld;  ///< The force acts on it along `direction_W`.
  bool turns = false;      ///< It is a torque, and J u a difference of angular velocities.
  Eigen::Vector3d point_W = Eigen::Vector3d::Zero();       ///< On its line of action [m].
  Eigen::Vector3d direction_W = Eigen::Vector3d::UnitX();  ///< Unit.
  double target = 0;       ///< Right-hand side of (E22) [m/s, rad/s].
  double compliance = 0;   ///< 1/g [m/(N s), rad/(N m s)]
  bool one_sided = false;  ///< λ >= 0.
  double largest_force = std::numeric_limits<double>::infinity();  ///< Else |λ| is at most this.
  bool of_line = true;       ///< It is that of a line, or of a joint's drive.
  bool of_motor = false;     ///< It is that of the motor of a drive.
  std::size_t owner = 0;     ///< Index of the line or joint.
  double tension_bound = 0;  ///< Tension that (E25) holds the ends of a line sideways for [N].
  double sideways = 0;       ///< (hω)² of that motion per tension, for the lighter end [1/N].
  double sign = 1;           ///< For the drive of a joint: the sign of λ along q.
  double force = 0;          ///< λ, found by the solver [N, N m].
};

/// The spring and damper of a row.
struct RowLaw {
  double stiffness = 0;  ///< k
  double damping = 0;    ///< c
  double missing = 0;    ///< e
  double rest_rate = 0;  ///< r
  double rate = 0;       ///< J u⁻
  double mobility = 1;   ///< J S⁻¹ Jᵀ [1/kg, 1/(kg m^2)]
  bool one_sided = false;
};

/// Target and compliance of (E22) for a substep of length h of a step [s].
struct RowTerms {
  double target = 0;
  double compliance = 0;
};
RowTerms row_terms(const RowLaw& law, double h, double step);

/// 0 for an oscillation that is resolved where it goes through `phase` [rad], 1 where it is not.
double unresolved(double phase);

/// Weights a and b of (E22).
struct SpringWeights {
  double after = 0.25;   ///< a
  double before = 0.25;  ///< b
};
/// @param damped    Result of unresolved() for a step.
/// @param h         Length of the substep of the step [s].
SpringWeights spring_weights(double damped, double h, double step);

/// Terms of a rigid stop or motor: J u⁺ = `rate`, with the compliance that round-off needs.
RowTerms rigid_terms(double rate, double mobility, double h);

}  // namespace engine

#pragma once

#include <Eigen/Core>
#include <limits>

#include "hydro/sea.h"

/// @file
/// Lines with inertia: masses on springs in the water.
///
/// A line of the unstretched length L is N segments of the length l = L/N. Its nodes x_0 … x_N
/// carry the mass, the weight and the water's loads of half a segment on each side. A segment along
/// the vector d, of the direction n, pulls its nodes together with
///
///     T = EA max(0, |d|/l − 1) + c n·d',                                                     (1)
///
/// c for a taut segment alone. With t the direction of the line at a node, P = I − t tᵀ, and u and
/// u' the velocity and acceleration of the water there, the loads per length are [HQ15]
///
///     weight     −w z in water, −m g z in air
///     inertia    −m x'' − ρ S C_a P x'' + ρ S (1 + C_a) P u',     S = π d²/4
///     drag       ½ρ d (C_d |P r| P r + π C_t |t·r| t t·r),        r = u − x'
///
/// A flat bottom carries a node by a spring and a critical damper; the line's weight presses the
/// spring in by a tenth of a diameter. Coulomb's friction holds the node up to a speed of 1 cm/s.
///
/// A step finds the nodes at its end from the backward differences of second order,
///
///     x' = (3 x − 4 x₁ + x₂)/2h,     x'' = (3 x' − 4 x₁' + x₂')/2h,                            (2)
///
/// x₁ and x₂ one and two steps before. The shape 2 x₁ − x₂ gives t and the water, the sizes of r in
/// the drag and what is on the bottom: all is linear then but for the springs, whose energy is
/// convex. So each step has one solution for any length of the step and any stiffness, and Newton's
/// method finds it. Stiff springs come to rest within a step. The error is of second order in h and
/// in l.
///
/// [HQ15] M. Hall, A. Goupee, Validation of a lumped-mass mooring line model with DeepCwind
///        semisubmersible model test data, Ocean Engineering 104 (2015).

namespace hydro {

/// The constant properties of a line.
struct LumpedLine {
  int segments = 20;       ///< N, at least 1.
  double stiffness = 0;    ///< EA [N], > 0.
  double damping = 0;      ///< c N [N s/m]: that of the whole line is c/N.
  double mass = 0;         ///< m, per length in air [kg/m], > 0.
  double weight = 0;       ///< w, per length in water [N/m]; negative for one that floats.
  double diameter = 0;     ///< d [m]; 0: the water does not act on its motion.
  double drag_across = 0;  ///< C_d [-]
  double drag_along = 0;   ///< C_t [-]
  double added_mass = 0;   ///< C_a [-]
  double friction = 0;     ///< Coulomb's coefficient on the bottom [-].
  double gravity = 0;      ///< g [m/s^2]
  /// Height of the bottom [m].
  double bottom = -std::numeric_limits<double>::infinity();
};

/// The motion of a line, from its first end to its second, at the end of a step.
struct LumpedState {
  Eigen::Matrix3Xd places, places_before;          ///< x₁, x₂ [m].
  Eigen::Matrix3Xd velocities, velocities_before;  ///< x₁', x₂' [m/s].
  /// Forces of the line on what holds its ends, first and second [N].
  Eigen::Matrix<double, 3, 2> forces = Eigen::Matrix<double, 3, 2>::Zero();
};

/// The places of the ends of a line, first and second [m].
using LineEnds = Eigen::Matrix<double, 3, 2>;

/// A line at rest in still water, its ends held.
/// @param length   L [m], > 0.
/// @param sea      The water; null: none.
LumpedState line_at_rest(const LumpedLine& line, double length, const LineEnds& ends,
                         const Sea* sea);

/// Length of a line that lies on its bottom [m].
double resting_length(const LumpedLine& line, double length, const LumpedState& state);

}  // namespace hydro

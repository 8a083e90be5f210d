#pragma once

#include "engine/motion/body.h"

/// @file
/// Limits of a substep by the motion of a body at its start, and signs that a substep was too long.

namespace engine {

/// Length of the first of the equal substeps in which a body takes the rest of a step [s].
///
/// A wet body turns by at most kLargestWetTurn in a substep and crosses the water surface by at
/// most kLargestCrossing of its height. A free one goes through at most kLargestSwing of a resolved
/// oscillation; a constrained one turns by at most kLargestConstrainedTurn by its own inertia,
/// which the constraint solver does not see, and one that a row acts on by that much in all. A step
/// has at most kMostSubsteps.
///
/// @param rest          Rest of the step [s].
/// @param step          The step [s].
/// @param constrained   Joints or contacts act on the body.
double substep_limit(const Body& body, const Motion& motion, double rest, double step,
                     bool constrained);

/// True if a body turns by less than kFollowedTurn in a time h [s], so that halves of a substep
/// find its energy better than the whole.
bool can_be_followed(const Body& body, const Motion& motion, double h);

/// True if the last accelerations are resolved and a substep of length h [s] goes through less than
/// kSmoothSwing of their oscillation.
bool is_smooth(const AccelerationHistory& history, double h);

/// The rise of a body relative to the range of heights of the water surface.
struct SurfaceCrossing {
  bool meets;     ///< The body may have touched the surface.
  bool reaches;   ///< It may have reached or left the surface.
  double rise;    ///< [m]
  double height;  ///< The body's own [m].

  bool abrupt() const;  ///< As crosses_surface().
};

SurfaceCrossing surface_crossing(const Body& body, const hydro::BodyState& before,
                                 const hydro::BodyState& after);

/// True if the body moves through the surface by much of its height, or reaches or leaves it.
bool crosses_surface(const Body& body, const hydro::BodyState& before,
                     const hydro::BodyState& after);

/// True if the added mass of a body changes by more than kLargestAddedChange of its inertia in a
/// substep, as at the entry of a bottom. Bodies in contact are left out: each half of a substep
/// solves their contacts anew.
bool added_mass_jumps(const Body& body, const Motion& before, const Motion& after);

/// True if loads have moved a body through or along the water surface by more than
/// kLargestOvershoot of its height in a time h [s], so that they were not the loads on its path.
bool overshoots_surface(const Body& body, const hydro::BodyState& before,
                        const hydro::BodyState& after, double h);

}  // namespace engine

#pragma once

#include "engine/motion/work_record.h"
#include "hydro/loads/loads.h"

/// @file
/// The forces on a body, and the work they have done.
///
/// In W, with v the velocity of the centre of mass and u the velocity relative to the water,
///
///     K = ½ (v, ω)·M (v, ω)        E_A = ½ u·A u        P = m g (z − level)
///     K − K(0) = the sum of all works, the limiter's included                              (E16)
///     P − P(0) = −(the work of the weight)
///
/// A work is the sum over the substeps of a load's impulse times the mean of the velocities before
/// and after its update. So the first equation holds to round-off, but for the correction (E9),
/// which comes and goes with the loads; the second, where impulses meet displacements, to the order
/// of the integration. The difference between the load of an implicit update and the last one
/// found, ¼h K Δu, is buoyancy.
///
/// The water that moves with a body takes from it −ΔE_A, and more where A changes (E4): what the
/// body loses as it enters or leaves.

namespace engine {

struct MovingBody;

/// The loads on a body at an instant: moments about the centre of mass, in W.
struct BodyForces {
  hydro::Loads water;       ///< Loads of water and air by kind.
  hydro::Wrench applied;    ///< Loads of the scene and of the program.
  hydro::Wrench weight;     ///< Load of gravity.
  hydro::Wrench radiation;  ///< Load of the waves that the body has made.
  /// Load of simulated water, in place of `radiation` and `water.diffraction`.
  hydro::Wrench simulated_water;
  /// Load of springs, ropes, moorings and drives of joints; the part that the constraint solver
  /// finds is the mean over the last step.
  hydro::Wrench lines;
  hydro::Wrench machines;  ///< Load of propellers and foils.
  /// Load of the inertia of the water. This and `constraint` are means over the last step, zero
  /// before the first one, since impacts change the velocity at once. The limiter's impulse is in
  /// neither.
  hydro::Wrench added_mass;
  /// Load of contacts, joints and locks together; on a body that is held it balances the others.
  hydro::Wrench constraint;

  double kinetic_energy = 0;        ///< K [J]
  double added_kinetic_energy = 0;  ///< E_A [J]
  double potential_energy = 0;      ///< P [J]; the level is 0 without water.
  Works works;                      ///< Works since the start.
};

/// The forces on a body that has a record. @param step   Length of the last step [s].
/// @param lines   Load of lines and drives in the present state, without rows.
BodyForces forces_on(const MovingBody& moving, const hydro::Wrench& lines, double time,
                     double step);

}  // namespace engine

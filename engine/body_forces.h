#pragma once

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

/// Work done on a body since the start [J].
struct Works {
  double buoyancy = 0;
  double pressure_drag = 0;
  double viscous_drag = 0;
  double lift = 0;
  double wave_inertia = 0;
  double diffraction = 0;
  double radiation = 0;  ///< By the memory of the waves that the body has made.
  double wind = 0;
  double interior = 0;  ///< By the water in its pockets.
  double lines = 0;     ///< By springs, ropes, moorings and drives of joints.
  double machines = 0;  ///< By propellers and foils.
  double added_mass = 0;
  double applied = 0;     ///< By the forces of the scene and of the program.
  double weight = 0;      ///< Of the body's own mass.
  double constraint = 0;  ///< By contacts, joints and locks.
  double brake = 0;       ///< By the energy limiter.

  double sum() const {
    return buoyancy + pressure_drag + viscous_drag + lift + wave_inertia + diffraction + radiation +
           wind + interior + lines + machines + added_mass + applied + weight + constraint + brake;
  }
  /// Part of the works, summed up in size, that the energy limiter has done [-].
  double clamped_share() const;
};

/// The loads on a body at an instant: moments about the centre of mass, in W.
struct BodyForces {
  hydro::Loads water;
  hydro::Wrench applied;
  hydro::Wrench weight;
  hydro::Wrench radiation;  ///< Of the memory of the waves that the body has made.
  /// Of springs, ropes, moorings and drives of joints; the part of those that the constraint solver
  /// finds is the mean over the last step.
  hydro::Wrench lines;
  hydro::Wrench machines;  ///< Of propellers and foils.
  // These two are means over the last step, zero before the first one, since impacts change the
  // velocity at once; the limiter's impulse is in neither. The constraint of a body that is held
  // balances the other forces.
  hydro::Wrench added_mass;
  hydro::Wrench constraint;  ///< Contacts, joints and locks together.

  double kinetic_energy = 0;        ///< K [J]
  double added_kinetic_energy = 0;  ///< E_A [J]
  double potential_energy = 0;      ///< P [J]; the level is 0 without water.
  Works works;
};

}  // namespace engine

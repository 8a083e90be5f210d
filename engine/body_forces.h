#pragma once

#include "hydro/loads/loads.h"

/// @file
/// What acts on a body, and the work it has done.
///
/// In W, with v the velocity of the centre of mass and u that relative to the water,
///
///     K = ½ (v, ω)·M (v, ω)        E_A = ½ u·A u        P = m g (z − level)
///     K − K(0) = the sum of all works, the brake's included                                 (E16)
///     P − P(0) = −(the work of the weight)
///
/// A work is the sum over the accelerations (update.h) of a load's impulse times the mean of the
/// velocities before and after: what the load has done to the motion that was found, so that the
/// first holds to round-off but for the correction (E9), which comes and goes with the loads. In
/// the second equation the impulses meet the displacements: it holds to the order of the
/// integration. The load that an implicit update takes beyond the one found last, h/4 K Δu, is
/// buoyancy.
///
/// The water that moves with a body takes from it −ΔE_A, and more where A changes
/// (added_inertia.h): what the body loses as it enters or leaves.

namespace engine {

/// Work done on a body since the start [J].
struct Works {
  double buoyancy = 0;
  double pressure_drag = 0;
  double viscous_drag = 0;
  double lift = 0;
  double added_mass = 0;
  double applied = 0;     ///< By the forces of the scene.
  double weight = 0;      ///< Of the body's own mass.
  double constraint = 0;  ///< By contacts, joints and locks.
  double brake = 0;  ///< Motion taken so that still water gives no energy (free_step.h), or to put
                     ///< the body to sleep (sleep.h).

  double sum() const {
    return buoyancy + pressure_drag + viscous_drag + lift + added_mass + applied + weight +
           constraint + brake;
  }
};

/// The loads on a body at an instant: moments about the centre of mass, in W.
struct BodyForces {
  hydro::Loads water;
  hydro::Wrench applied;
  hydro::Wrench weight;
  // These two change the velocity at once as bodies meet: they are means over the last step, zero
  // before the first one. Of a body that cannot move, or sleeps, the constraint is what balances
  // the others.
  hydro::Wrench added_mass;  ///< Of a body that brakes, the brake's impulse is in none.
  hydro::Wrench constraint;  ///< Contacts, joints and locks together.

  double kinetic_energy = 0;        ///< K [J]
  double added_kinetic_energy = 0;  ///< E_A [J]
  double potential_energy = 0;      ///< P; without water from z = 0 [J].
  Works works;
};

}  // namespace engine

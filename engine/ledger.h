#pragma once

#include "engine/force_log.h"
#include "engine/six.h"

/// @file
/// The books that a motion keeps of impulses and works (force_log.h). They belong to the motion:
/// one that is not accepted takes its entries with it.

namespace engine {

struct Body;
struct Middle;
struct Motion;
struct Surroundings;

struct Ledger {
  /// That of the added mass is without −ΔE_A.
  Works works;
  double added_energy_at_start = 0;                ///< E_A [J]
  Vector6d added_impulse = Vector6d::Zero();       ///< In this step, W [N s, N m s].
  Vector6d constraint_impulse = Vector6d::Zero();  ///< In this step, W [N s, N m s].
};

/// How the velocity changed in a kick.
struct Kicked {
  Vector6d change;                     ///< Δu, in W.
  double step = 0;                     ///< [s]
  bool implicit = false;               ///< By (2) of kick.h.
  const Vector6d* reaction = nullptr;  ///< Of joints and contacts, in W; null: there are none.
};

// Each enters what happened into the ledger of the motion after it, which has one.

/// A kick by the loads that the body has.
void book_kick(const Body& body, const Surroundings& around, const Middle& middle,
               const Kicked& kicked, Motion& after);
/// Motion by inertia over `time` [s].
void book_drift(const Body& body, const Surroundings& around, const Motion& before, double time,
                Motion& after);
/// A change of the added mass at once.
void book_added_mass(const Body& body, const Surroundings& around, const Motion& before,
                     Motion& after);
/// A change of velocity that no load made.
void book_brake(const Body& body, const Surroundings& around, const Motion& before, Motion& after);
/// A step of ODE's own by the loads that the body has. @param held   Constraints took part.
void book_ode_step(const Body& body, const Motion& before, double step, bool held, Motion& after);

/// What acts on a body that keeps a ledger. `step` [s] is the length of the last step.
/// @param asleep   It is held where it is (sleep.h).
BodyForces forces_on(const Body& body, const Surroundings& around, double time, double step,
                     bool asleep);

/// E_A [J]
double added_kinetic_energy(const Body& body, const Surroundings& around, const Motion& motion);

}  // namespace engine

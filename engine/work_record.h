#pragma once

#include "engine/body_forces.h"
#include "engine/spatial_vector.h"

/// @file
/// The record that a motion keeps of impulses and works (body_forces.h). It belongs to the motion:
/// a motion that is not accepted takes its entries with it.

namespace engine {

struct Body;
struct Environment;
struct MidpointState;
struct Motion;
struct MovingBody;

struct WorkRecord {
  Works works;                                     ///< That of the added mass lacks −ΔE_A.
  double added_energy_at_start = 0;                ///< E_A [J]
  Vector6d added_impulse = Vector6d::Zero();       ///< In this step, in W [N s, N m s].
  Vector6d constraint_impulse = Vector6d::Zero();  ///< In this step, in W [N s, N m s].

  void start_step() { added_impulse = constraint_impulse = Vector6d::Zero(); }
};

/// How an update changed the velocity.
struct UpdateRecord {
  Vector6d change;                     ///< Δu, in W.
  double h = 0;                        ///< Length of the substep [s].
  bool implicit = false;               ///< By (E6).
  const Vector6d* reaction = nullptr;  ///< Of joints and contacts, in W; null: there are none.
};

// Each of these enters what happened into the record of the motion `after` it, which has one.

/// An update by the loads of the body's last evaluation.
void record_update(const MovingBody& moving, const Environment& environment,
                   const MidpointState& midpoint, const UpdateRecord& update, Motion& after);
/// Motion by inertia over `time` [s].
void record_drift(const Body& body, const Environment& environment, const Motion& before,
                  double time, Motion& after);
/// A sudden change of the added mass (E4).
void record_added_mass(const Body& body, const Environment& environment, const Motion& before,
                       Motion& after);
/// A change of velocity by the energy limiter.
void record_clamp(const Body& body, const Environment& environment, const Motion& before,
                  Motion& after);
/// A step of ODE's own by the loads of the last evaluation. @param constrained   Constraints acted.
void record_ode_step(const MovingBody& moving, const Motion& before, double step, bool constrained,
                     Motion& after);

/// What acts on a body that keeps a record. @param step   Length of the last step [s].
BodyForces forces_on(const MovingBody& moving, const Environment& environment, double time,
                     double step);

/// E_A [J]
double added_kinetic_energy(const Body& body, const Environment& environment, const Motion& motion);

}  // namespace engine

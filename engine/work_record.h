#pragma once

#include "engine/body_forces.h"
#include "engine/spatial_vector.h"

/// @file
/// A motion's record of impulses and works (body_forces.h). It is part of the motion, so that one
/// which is not accepted leaves no entry.

namespace engine {

struct Body;
struct MidpointState;
struct Motion;
struct MovingBody;

struct WorkRecord {
  Works works;                                     ///< The work of the added mass lacks −ΔE_A.
  double added_energy_at_start = 0;                ///< E_A [J]
  Vector6d added_impulse = Vector6d::Zero();       ///< In this step, in W [N s, N m s].
  Vector6d constraint_impulse = Vector6d::Zero();  ///< In this step, in W [N s, N m s].
  Vector6d row_impulse = Vector6d::Zero();         ///< Of rows, in this step, in W [N s, N m s].

  void start_step() { added_impulse = constraint_impulse = row_impulse = Vector6d::Zero(); }
};

/// How an update changed the velocity.
struct UpdateRecord {
  Vector6d change;        ///< Δu, in W.
  double h = 0;           ///< Length of the substep [s].
  bool implicit = false;  ///< By (E6).
  /// Of joints, contacts and rows, in W; null: there are none.
  const Vector6d* reaction = nullptr;
  const Vector6d* rows = nullptr;  ///< Part of it that is of rows; null: there are none.
};

// Each of these adds an event to the record of the motion `after` it, which must have one.

/// An update by the last loads of the body.
void record_update(const MovingBody& moving, const MidpointState& midpoint,
                   const UpdateRecord& update, Motion& after);
/// Motion by inertia over `time` [s].
void record_drift(const Body& body, const Motion& before, double time, Motion& after);
/// A change of the added mass at a held pose (E4).
void record_added_mass(const Body& body, const Motion& before, Motion& after);
/// A change of velocity by the energy limiter.
void record_clamp(const Body& body, const Motion& before, Motion& after);
/// A step of ODE's own by the last loads. @param constrained   Constraints acted.
void record_ode_step(const MovingBody& moving, const Motion& before, double step, bool constrained,
                     Motion& after);

/// The works on a body that has a record.
Works works_of(const Body& body, const Motion& motion);

/// The forces on a body that has a record. @param step   Length of the last step [s].
/// @param lines   Load of lines and drives in the present state, without rows.
BodyForces forces_on(const MovingBody& moving, const hydro::Wrench& lines, double time,
                     double step);

/// E_A [J]
double added_kinetic_energy(const Body& body, const Motion& motion);

}  // namespace engine

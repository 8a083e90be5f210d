#pragma once

#include <array>

#include "engine/base/spatial_vector.h"

/// @file
/// A motion's record of impulses and works (record/body_forces.h). It is part of the motion, so
/// that one which is not accepted leaves no entry.

namespace engine {

struct Body;
struct MidpointState;
struct Motion;
struct MovingBody;

/// Work done on a body since the start [J].
struct Works {
  double buoyancy = 0;       ///< By the pressure of the water, as hydro::Loads::buoyancy.
  double pressure_drag = 0;  ///< By pressure drag.
  double viscous_drag = 0;   ///< By friction.
  double lift = 0;           ///< By the lift of panels.
  double wave_inertia = 0;   ///< By the acceleration of waves.
  double diffraction = 0;    ///< By the waves that the body scatters.
  double radiation = 0;      ///< By the memory of the waves that the body has made.
  double water = 0;          ///< By simulated water, in place of diffraction and radiation.
  double wind = 0;           ///< By the air.
  double interior = 0;       ///< By the water in its pockets.
  double lines = 0;          ///< By springs, ropes, moorings and drives of joints.
  double machines = 0;       ///< By propellers and foils.
  double hull_lift = 0;      ///< By the lift of the hull.
  double added_mass = 0;     ///< By the inertia of the water.
  double applied = 0;        ///< By the forces of the scene and of the program.
  double weight = 0;         ///< Work of the body's own weight.
  double constraint = 0;     ///< By contacts, joints and locks.
  double brake = 0;          ///< By the energy limiter.
  double resistance = 0;     ///< By the resistance along the motion.

  /// Each of them once.
  std::array<double, 19> all() const {
    return {buoyancy,    pressure_drag, viscous_drag, lift,       wave_inertia,
            diffraction, radiation,     water,        wind,       interior,
            lines,       machines,      hull_lift,    resistance, added_mass,
            applied,     weight,        constraint,   brake};
  }
  /// The sum of all works [J].
  double sum() const;
  /// Part of the works, summed up in size, that the energy limiter has done [-].
  double clamped_share() const;
};

/// The works and the impulses of the present step.
struct WorkRecord {
  Works works;                                     ///< The work of the added mass lacks −ΔE_A.
  double added_energy_at_start = 0;                ///< E_A [J]
  Vector6d added_impulse = Vector6d::Zero();       ///< In this step, in W [N s, N m s].
  Vector6d constraint_impulse = Vector6d::Zero();  ///< In this step, in W [N s, N m s].
  Vector6d row_impulse = Vector6d::Zero();  ///< Impulse of rows in this step, in W [N s, N m s].

  /// Sets the impulses of the step to zero.
  void start_step() { added_impulse = constraint_impulse = row_impulse = Vector6d::Zero(); }
};

/// How an update changed the velocity.
struct UpdateRecord {
  Vector6d change;        ///< Δu, in W.
  double h = 0;           ///< Length of the substep [s].
  bool implicit = false;  ///< By (E6).
  /// Reaction of joints, contacts and rows, in W; null: there are none.
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
/// A projection of pose or velocity on joints.
void record_joints(const Body& body, const Motion& before, Motion& after);
/// A step of ODE's own by the last loads. @param constrained   Constraints acted.
void record_ode_step(const MovingBody& moving, const Motion& before, double step, bool constrained,
                     Motion& after);

/// The works on a body that has a record.
Works works_of(const Body& body, const Motion& motion);

/// Kinetic energy of the body itself, K [J].
double own_kinetic_energy(const Body& body, const Motion& motion);

/// E_A [J]
double added_kinetic_energy(const Body& body, const Motion& motion);

}  // namespace engine

#pragma once

#include "engine/motion/moving_body.h"
#include "engine/motion/wave_memory.h"
#include "hydro/loads/load_jacobian.h"

/// @file
/// The change of a body's velocity by loads over a substep of length h, at its pose halfway.
///
/// Between two half drifts (free_motion.h) the velocity u changes at a held pose by S u' = F(u),
/// with S = M + A and F all loads. Its change Δu has an explicit and an implicit form:
///
///     S Δu = h F(x + (h/12) Δu₀, u + ½Δu₀)                                                (E5)
///     (S − ¼h²K) Δu = h F(x, u + θ Δu)                                                    (E6)
///
/// In (E5), Δu₀ is extrapolated from the last substeps (acceleration_history.h) or, without those,
/// found from F(x, u): it takes one evaluation of the loads per substep. The shift of the pose x is
/// Takahashi and Imada's [TI84]: loads that depend on the pose alone become accurate to fourth
/// order but for a correction of the state (processing_correction.h). (E6) is solved by Newton's
/// method with the Jacobian J = ∂F/∂u of the drag; K is the waterplane's stiffness
/// (load_jacobian.h).
///
/// Stability. With ζ the largest eigenvalue of −h J in the metric of S, θ = max(½, 1/(1−e^−ζ) −
/// 1/ζ), which tends to 1 as the drag becomes stiff. J is negative semi-definite and pressure drag
/// is the gradient of a convex function, so (E6) takes energy for any h: u tends to the velocity at
/// which the loads balance, without oscillation. θ − ½ is of first order in h, so the scheme stays
/// of second order. With K and θ = ½ the whole substep is the implicit midpoint rule for a floating
/// body: stable and without loss for any h ω. (E5) is taken where ζ < kStiffDrag and (h ω)² <
/// kStiffWaterplane.
///
/// Lines that are stiff add a h² K + w h C to S in all forms (E24, rig.h).
///
/// The memory of waves (wave_memory.h) takes part in both forms, and under constraints: it adds
/// ¼h² C to S and f to F, so that it is implicit whatever the loads are.
///
/// [TI84] Takahashi and Imada. Monte Carlo calculation of quantum systems. II. J. Phys. Soc. Japan
/// 53 (1984).

namespace engine {

/// A body halfway through a substep, before its loads have acted.
struct MidpointState {
  const Motion* motion = nullptr;      ///< After half a drift, with the added mass of the start.
  Eigen::Matrix3d R_WB;                ///< Orientation of that motion.
  std::optional<Matrix6d> inertia;     ///< S of (E4) in W; none: M.
  Vector6d before;                     ///< u in W, relative to the water.
  Vector6d after;                      ///< u⁺ of (E4) without loads, in W, relative to the water.
  std::optional<MemoryEffect> memory;  ///< (E19)
  std::optional<Matrix6d> rig_inertia;  ///< Term that (E24) adds to S, in W.

  Vector6d mean() const { return (before + after) / 2; }
};

/// @param added_B    The added mass at the end of the substep.
/// @param mobility   Velocities that are not free take no part in its change.
MidpointState make_midpoint(const Body& body, const Motion& motion, const Matrix6d& added_B,
                            const Mobility& mobility);

/// S in W, without what the memory of waves adds to it.
Matrix6d inertia_W(const Body& body, const MidpointState& midpoint);

struct VelocityUpdate {
  Vector6d change = Vector6d::Zero();  ///< Δu, in W.
  Vector6d load = Vector6d::Zero();    ///< F of (E5), without f of (E19), in W.
  Vector6d slope = Vector6d::Zero();   ///< d(Δu/h)/dt, where a first update shows it, in W.
  Vector6d at = Vector6d::Zero();      ///< The velocity that F was found with, in W.
  bool unpredicted = false;            ///< Extrapolation missed the change.
  bool implicit = false;               ///< By (E6).
  bool unsolved = false;               ///< Its constraints missed their tolerance.
};

/// Δu of a body that nothing but its locks and its reduced joint constrains.
/// @param time   Halfway through the substep [s].
VelocityUpdate free_update(MovingBody& moving, const MidpointState& midpoint, double time,
                           double h);

/// The same after a small change of S: an explicit update keeps its loads.
VelocityUpdate resolve_with_inertia(MovingBody& moving, const MidpointState& midpoint,
                                    const VelocityUpdate& last, double time, double h);

/// The loads as a constraint solver takes them: with the reactions R,
///
///     inertia Δu = h (load + R).
struct EffectiveLoad {
  Matrix6d inertia;  ///< In W, symmetric and positive definite: S, or that of (E6) linearised.
  Vector6d load;     ///< In W.
  bool implicit = false;
};

/// (E5) or, where the loads are stiff, (E6) linearised about u + θ·expected.
/// @param pieces   Pieces over which the Jacobian is summed.
EffectiveLoad effective_load(MovingBody& moving, const MidpointState& midpoint,
                             const Vector6d& expected, double time, double h, hydro::Pieces pieces);

}  // namespace engine

#pragma once

#include "engine/body.h"

/// @file
/// What the loads do to a body's velocity within a step h, in its pose halfway.
///
/// Between two halves of motion by inertia (free_motion.h) the velocity u changes at a held pose by
/// S u' = F(u), with S = M + A and F all loads. The change Δu is found by one of two forms:
///
///     S Δu = h F(x + (h/12) Δu_0, u + ½Δu_0)                                              (1)
///     (S − ¼h²K) Δu = h F(x, u + θ Δu)                                                    (2)
///
/// (1) is explicit, with Δu_0 the change that the last kicks foretell (kick_history.h; where there
/// are none, one found from F(x, u)): one evaluation of the loads a step. The pose x is taken as
/// much further as makes loads that hang on it alone accurate to the fourth order but for an offset
/// of the state (free_step.h), by Takahashi and Imada's force [TI84]. (2) is implicit, solved by
/// Newton's method with the Jacobian J = ∂F/∂u of the drag (load_jacobian.h); K is the waterplane's
/// stiffness.
///
/// Stability. With ζ the largest eigenvalue of −h J in the metric of S, θ = max(½, 1/(1−e^−ζ) −
/// 1/ζ): the mean of ½ and the exponential method's, which tends to 1 as the drag becomes stiff. J
/// is negative semi-definite and pressure drag is the gradient of a convex function, so (2) takes
/// energy for any h: u goes to the velocity at which the loads balance, and does not swing about
/// it. θ − ½ is of first order in h, which keeps the scheme's order at two. With K and θ = ½ the
/// whole step is the implicit midpoint rule for the oscillation of a floating body: stable, and
/// without loss, for any h ω. The drift does not need either. (1) is taken where ζ is below
/// kStiffDrag and (h ω)² below kStiffWaterplane: it is stable for real ζ < ½ and (h ω)² < 4.
///
/// [TI84] Takahashi and Imada. Monte Carlo calculation of quantum systems. II. J. Phys. Soc. Japan
/// 53 (1984).

namespace engine {

inline constexpr double kStiffDrag = 0.3;
inline constexpr double kStiffWaterplane = 0.5;

/// A body halfway through a step, before the loads have acted.
struct Middle {
  const Motion* motion = nullptr;   ///< As it drifted there, with the added mass of the start.
  Eigen::Matrix3d R_WB;             ///< Of its pose.
  std::optional<Matrix6d> inertia;  ///< S in W, of (1) in added_inertia.h; none: M.
  Vector6d before;                  ///< u in W, relative to the water.
  Vector6d after;                   ///< u⁺ without loads.

  Vector6d mean() const { return (before + after) / 2; }
};

/// @param added_B   The added mass at the end of the step.
/// @param freedom   What is not free takes no part in its change.
Middle make_middle(const Body& body, const Surroundings& around, const Motion& motion,
                   const Matrix6d& added_B, const Freedom& freedom);

/// S in W.
Matrix6d inertia_W(const Body& body, const Middle& middle);

struct Kick {
  Vector6d change = Vector6d::Zero();  ///< Δu in W.
  Vector6d load = Vector6d::Zero();    ///< F of (1).
  Vector6d slope = Vector6d::Zero();   ///< Of Δu/h a second, where a first kick shows it.
  Vector6d at = Vector6d::Zero();      ///< The velocity that it was found with.
  bool sudden = false;                 ///< Not foretold by the last ones.
  bool implicit = false;               ///< By (2).
};

/// Δu of a body without constraints; its locked degrees of freedom take no part.
/// @param time   Halfway through the step [s].
Kick free_kick(Body& body, const Surroundings& around, const Middle& middle, double time,
               double step);

/// The same after a small change of S: an explicit kick takes over the loads.
Kick free_kick_again(Body& body, const Surroundings& around, const Middle& middle, const Kick& last,
                     double time, double step);

/// The loads as a constraint solver can take them: with the reactions R,
///
///     inertia Δu = h (load + R).
struct EffectiveLoad {
  Matrix6d inertia;  ///< In W, symmetric and positive definite: S, or that of (2) linearised.
  Vector6d load;
  bool implicit = false;
  double theta = 0.5;
};

/// (1) or, if `expected` is far from balance, (2) linearised about u + θ·expected.
EffectiveLoad effective_load(Body& body, const Surroundings& around, const Middle& middle,
                             const Vector6d& expected, double time, double step);

}  // namespace engine

#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/base/spatial_vector.h"
#include "hydro/radiation/wave_frame.h"

/// @file
/// The waves that a floating body has made and that still act on it, as the damped oscillators q of
/// hydro/radiation/radiation_memory.h: a load that is linear in the body's velocity u relative to
/// the current, with a state of its own. With p = q' and the port B turned to W,
///
///     p' + D p + Ω² q = B u,      F = −Bᵀ p,      D and Ω diagonal.
///
/// A substep of length h takes it by the implicit midpoint rule. With G = 1 + ½h D + ¼h² Ω², C = Bᵀ
/// G⁻¹ B and the means ū and p̄ of its two ends,
///
///     p̄ = G⁻¹ (p + ½h (B ū − Ω² q)),      q₁ = q + h p̄,      p₁ = 2p̄ − p                   (E18)
///     F̄ = −Bᵀ p̄ = f − ¼h C Δu,      f = −BᵀG⁻¹ (p − ½h Ω² q) − ½h C ū₀                      (E19)
///
/// where ū₀ is ū without Δu. So S Δu = h (F + F̄) is (S + ¼h² C) Δu = h (F + f): the memory adds
/// inertia to an update, and a load that is known before it.
///
/// Stability. The energy ½ (p² + q·Ω² q) of the memory grows by h (p̄·B ū − p̄·D p̄), exactly and for
/// any h, of which the first term is what F̄ takes from the body.
///
/// F is the rate, in the axes of H, at which the waves that the body makes lose their momentum
/// Bᵀ q, and its diffraction is that of the waves that it scatters (diffraction_load.h). As these
/// axes move with the velocity u = (v, ω) relative to the water about the body, that
/// momentum exerts besides, as that of A by (E1),
///
///     (P × ω, L × ω + P × v),      (P, L) = Bᵀ q + p_D + A∞ (w − c),                      (E19a)
///
/// with the velocity w of that water, the current c and the momentum p_D of the scattered waves. It
/// takes no power from u. With the A∞ u of (E1), P is the momentum of all waves that the body makes
/// and scatters, which is small for one that follows a long wave: with a part of it alone, waves
/// would exert mean forces. (E1) and (E19a) are strip theory's terms of forward speed [STF]: for a
/// ship with the speed U that heaves at w₃, the moment U (A₃₃ + B₃₃/iω) w₃, and U F_D₃/iω of the
/// diffraction. The load is found for the velocity expected halfway. A body that may turn
/// without moving water has none: its waves would turn it.
///
/// B is that of the frame H, which follows the body's wetted shape (hydro/radiation/wave_frame.h).
/// As the body leaves the water B is multiplied by the root of its presence (floating_body.h
/// there), and the oscillators move on without it.
///
/// Simulated water (hydro/water/simulated_water.h) keeps the waves itself. During a step of its own
/// it acts on the body as a load f and a spring,
///
///     ξ' = B u,      F = Bᵀ (f − g C ξ), (E18a)
///
/// with B the turn to H times the same strength, and ξ the body's displacement since the water's
/// step began. The energy ½g ξ·Cξ is what the water takes over at the step's end. The midpoint rule
/// gives an update the inertia ¼h² BᵀgCB and the load of the displacement that u₀ leads to; (E19a)
/// has the momentum of the simulated waves in the place of Bᵀ q.
///
/// [STF] Salvesen, Tuck and Faltinsen. Ship motions and sea loads. Trans. SNAME 78 (1970).

namespace engine {

struct Body;
struct MidpointState;
struct Motion;
struct MovingBody;

/// The oscillators' state.
struct WaveMemory {
  Eigen::VectorXd q;  ///< [√J s]
  Eigen::VectorXd p;  ///< [√J]
};

/// The load and momentum of simulated water at the start of its step, and the displacement since,
/// in H and for water of density 1 times the root of the density.
struct WaterMemory {
  Vector6d displacement = Vector6d::Zero();  ///< ξ
  Vector6d load = Vector6d::Zero();          ///< f
  Vector6d momentum = Vector6d::Zero();      ///< Momentum in (E19a).
};

/// The terms that depend on the body and h alone.
struct WaveMemoryRule {
  double h = 0;                          ///< [s]
  Eigen::VectorXd inverse;               ///< The diagonal of G⁻¹.
  Matrix6d coupling = Matrix6d::Zero();  ///< C in H for water of density 1.
};

/// The effect of a body's memory on an update, in W.
struct MemoryEffect {
  double strength = 0;     ///< Factor of the port, by density and presence.
  hydro::WaveFrame frame;  ///< H
  Matrix6d inertia;        ///< ¼h² C
  Vector6d load;           ///< f
  Vector6d current;        ///< Velocity relative to the current less that of the update.
  Vector6d turning = Vector6d::Zero();  ///< (E19a)

  /// h F̄ for the change Δu of the velocity.
  Vector6d impulse(const Vector6d& change, double h) const { return h * load - inertia * change; }
};

/// The memory of a body at rest; none for a body without one.
std::optional<WaveMemory> still_memory(const Body& body);
std::optional<WaterMemory> still_water(const Body& body);

/// Lets the water begin a step at a time [s]. Where nothing but locks holds the body, the change
/// of its load is known beforehand, and the accelerations that are extrapolated change by it.
void begin_water_step(MovingBody& moving, double time, const WaterMemory& water);

/// True if the motion's memory is one of this body.
bool fits_memory(const Body& body, const Motion& motion);

/// The effect of the memory; none for a body without one.
/// @param time   Halfway through the substep [s].
/// @param rule   Is made that of h.
std::optional<MemoryEffect> memory_effect(const Body& body, const MidpointState& midpoint,
                                          double time, double h, WaveMemoryRule& rule);

/// (E19a) in W; the memory's effect is known. @param time   Halfway through the substep [s].
Vector6d turning_load(const Body& body, const MidpointState& midpoint, double time,
                      const WaveMemoryRule& rule);

/// Takes the memory of the motion `end` through the substep, with the change Δu of the velocity.
void advance_memory(const Body& body, const MidpointState& midpoint, const Vector6d& change,
                    const WaveMemoryRule& rule, Motion& end);

/// ½ (p² + q·Ω² q), or ½g ξ·Cξ [J]; 0 without a memory.
double memory_energy(const Body& body, const Motion& motion);

/// F = −Bᵀ p, or (E18a), and (E19a) at an instant [s], in W; zero without a memory.
Vector6d memory_load(const Body& body, const Motion& motion, double time);

}  // namespace engine

#pragma once

#include "engine/substep.h"

/// @file
/// The change of velocity of bodies under joints, locks and contacts.
///
/// With S the effective inertia of a body and F its loads (velocity_update.h), R the reactions,
///
///     S Δu = h (F + R),                                                                    (E7)
///
/// where u + Δu obeys the constraints. The constraint solver, ODE's, knows a mass and a 3×3 inertia
/// only: with M_o of that form it solves M_o Δu = h (F_o + R). Given a guess r of the reactions,
/// the load
///
///     F_o = M_o S⁻¹ (F + r) − r                                                            (E8)
///
/// makes it answer with R(r), and where R = r its Δu is that of (E7). The reactions follow from its
/// answer as R = M_o Δu/h − F_o.
///
/// Convergence. The solver's R is the projection of −F_o in the metric of M_o, so r ← R is a
/// gradient step of length one for the dual of (E7), preconditioned by M_o: it contracts where M_o
/// <= 2S. M_o is therefore taken near S, its translational part the geometric mean of those of S,
/// and the iteration is accelerated (anderson.h): without inequalities it then ends after at most
/// as many steps as there are reactions, whatever the ratio of S to M_o. It starts from the
/// reactions of the last substep. Where it makes no progress, as when contacts open and close from
/// one answer to the next, M_o is made small enough for plain contraction, which then replaces
/// every acceleration that fails. Bodies with S of ODE's form need one solve.
///
/// The step does not depend on a lagged acceleration: at the fixed point it is that of the exact
/// mass, and every answer meets the constraints.

namespace engine {

/// Solves (E7) for a constrained island whose midpoints are made; sets the update and the reactions
/// of each body. Several islands may be solved at once.
/// @param time   Halfway through the substep [s].
void constrained_update(const StepContext& context, Island& island, double time, double h);

}  // namespace engine

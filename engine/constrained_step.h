#pragma once

#include <vector>

#include "engine/for_each.h"
#include "engine/kick.h"
#include "engine/world.h"

/// @file
/// The kick of bodies under joints, locks and contacts.
///
/// With S the effective inertia of a body and F its loads (kick.h), R the reactions,
///
///     S Δu = h (F + R),                                                                    (1)
///
/// where u + Δu obeys the constraints. The constraint solver, ODE's, knows a mass and a 3×3 inertia
/// only: with M_o of that form it solves M_o Δu = h (F_o + R). Given a guess r of the reactions,
/// the load
///
///     F_o = M_o S⁻¹ (F + r) − r                                                            (2)
///
/// makes it answer with R(r), and where R = r its Δu is that of (1). The reactions follow from its
/// answer as R = M_o Δu/h − F_o.
///
/// Convergence. The solver's R is the projection of −F_o in the metric of M_o, so r ← R is a
/// gradient step of length one for the dual of (1), preconditioned by M_o: it contracts where M_o
/// <= 2S. M_o is therefore taken near S, its translational part the geometric mean of those of S,
/// and the iteration is accelerated (anderson.h): without inequalities it then ends after at most
/// as many steps as there are reactions, whatever the ratio of S to M_o. Reactions of the step
/// before are where it starts. Should it come no nearer, as when contacts open and close from one
/// answer to the next, M_o is made small enough for plain contraction, which then takes the place
/// of every acceleration that fails.
/// Bodies with S of ODE's form need one solution; only islands with another body iterate.
///
/// Nothing here depends on a lagged acceleration: at the fixed point the step is that of the exact
/// mass, and before it the constraints are met in any case, as the last answer's Δu is what counts.

namespace engine {

/// A body under constraints, and what they and its loads change of its velocity.
struct ConstrainedBody {
  Body* body = nullptr;
  BodyId id = 0;
  Middle middle;
  /// Change of velocity by loads and reactions to linearise about, in W.
  Vector6d expected = Vector6d::Zero();
  Vector6d change = Vector6d::Zero();  ///< By loads and reactions: the result, in W.
  bool implicit = false;               ///< Its loads were taken implicitly.
};

/// Solves (1) for one island, whose bodies ascend. Several islands may be solved for at once.
/// @param time   Halfway through the step [s].
void constrained_kick(World& world, const Surroundings& around, const ForEach& for_each,
                      std::vector<ConstrainedBody>& island, const std::vector<Contact>& contacts,
                      double time, double step);

}  // namespace engine

#pragma once

#include <vector>

#include "engine/base/spatial_vector.h"
#include "engine/constraints/joint_reaction.h"
#include "engine/contacts/contacts.h"

/// @file
/// Keeps restitution from giving energy.
///
/// One frictionless impact at a time loses (1 − e²) of what its normal motion has. Several at once
/// with different e, or one with friction, whose impulses turn the body into each other's way, may
/// gain under Newton's law.
///
/// Let 0 and 1 denote the results of an island's update with e = 0 and with restitution. Every
/// R = (1 − s) R₀ + s R₁ pushes, is within its limit of friction, lets nothing approach, and moves
/// joints as they allow; s = 1 is the whole. The work of the reactions over the substep,
///
///     W(s) = ½ h R·(u⁻ + u⁺),                                                            (E33)
///
/// u⁻ and u⁺ the velocities before and after the update, is the change of energy by them, and
/// convex in s. s is the largest up to 1 for which W(s) <= max(0, W(0)).
///
/// A result whose constraints are not solved, as of joints that contradict each other or a needle
/// under a hundred times its mass, may throw its bodies. So that is bounded, too: the result
/// without any R takes the place of 0, and W may be up to kUnsolvedWork of the motion's energy and
/// what the overlap of the bodies holds; in a substep shorter than the time τ of a contact, h/τ of
/// that, as the thousands of substeps in which a light body spins would else give it each.

namespace engine {

/// A solution of (E7): changes of velocity and reactions R of the bodies of an island, in W.
struct ConstraintResult {
  std::vector<Vector6d> changes;
  std::vector<Vector6d> reactions;
  std::vector<double> row_forces;     ///< λ of the rows, a part of the reactions.
  double row_work = 0;                ///< Work of the rows in (E33) [J].
  std::vector<JointReaction> joints;  ///< The same of joints.
  bool solved = true;                 ///< Its constraints are.
};

/// True if contacts leave an approaching body with a speed of its own.
bool has_restitution(const std::vector<Contact>& contacts);

/// The contacts with e = 0 in (E30).
std::vector<Contact> without_restitution(std::vector<Contact> contacts);

/// (E33) over a substep of length h [J].
/// @param before   Velocities of the bodies before the update, in W.
double work(const ConstraintResult& result, const std::vector<Vector6d>& before, double h);

/// True if W of a result, less the work of lines and drives, exceeds `allowed_gain` and round-off.
bool adds_energy(const ConstraintResult& result, const std::vector<Vector6d>& before, double h,
                 double allowed_gain);

/// The result at the largest s for which W(s) <= max(0, W(0)) + allowed_gain.
ConstraintResult limit_energy(const ConstraintResult& plain, const ConstraintResult& restored,
                              const std::vector<Vector6d>& before, double h, double allowed_gain);

}  // namespace engine

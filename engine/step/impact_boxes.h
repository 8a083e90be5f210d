#pragma once

#include <utility>
#include <vector>

#include "engine/step/step_context.h"

/// @file
/// Where bodies may be in a step in which a fast impact turns them round.
///
/// A step's pairs are found once, from boxes about the ways that bodies go without contacts
/// (swept_box). One that an impact throws back, aside or ahead leaves its box. This matters where
/// it goes farther in a step than bodies are thick: it would pass through bodies that it was not
/// known to be near. So the bodies of a near pair that may come together by more than kFarImpact of
/// the thinner one's thickness in the step get boxes about all places that they can reach,
///
///     |v'| <= |v| + 2 m₂ / (m₁ + m₂) |v₁ − v₂|,
///
/// the speed after an elastic impact, or |v'| <= |v| at what cannot move. Pairs of these boxes are
/// found anew, and so on for kImpactRounds, as a body that was hit hits others.

namespace engine {

/// A pair of indices of boxes.
using BoxPair = std::pair<std::size_t, std::size_t>;

/// The pairs of a step's boxes, with those that impacts lead to.
/// @param boxes   Boxes of all bodies, and of the ground.
/// @param pairs   Pairs of these boxes that overlap, ascending.
std::vector<BoxPair> with_impacts(const StepContext& context, double step,
                                  std::vector<Eigen::AlignedBox3d> boxes,
                                  std::vector<BoxPair> pairs);

}  // namespace engine

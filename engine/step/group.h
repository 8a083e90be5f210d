#pragma once

#include <vector>

#include "engine/contacts/broad_phase.h"
#include "engine/motion/moving_body.h"

/// @file
/// Bodies that are moved together in a step.

namespace engine {

/// Bodies that joints or lines connect or that may touch each other.
struct Group {
  std::vector<BodyId> bodies;  ///< Ascending; all can move.
  /// Joints and couplings by lines of these bodies, with each other or with what cannot move.
  std::vector<Pair> joints;
  std::vector<Pair> near;  ///< Pairs that may touch; ascending.
};

/// The groups that pairs connect. A body of no pair is in none.
/// @param movable       Ascending.
/// @param connections   Pairs of these bodies, or of one of them with what cannot move.
/// @param joints, near  Pairs of these bodies. Each group gets its own; pairs between two groups
///                      are left out.
std::vector<Group> make_groups(const std::vector<MovingBody>& bodies,
                               const std::vector<BodyId>& movable,
                               const std::vector<Pair>& connections,
                               const std::vector<Pair>& joints, const std::vector<Pair>& near);

}  // namespace engine

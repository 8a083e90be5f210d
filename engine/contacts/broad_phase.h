#pragma once

#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "engine/base/spec.h"

/// @file
/// Pairs of bodies that may touch in a step, and the groups that pairs connect.

namespace engine {

using Pair = std::pair<BodyId, BodyId>;  ///< Ascending: kWorld, the ground, is first.

/// Groups of bodies that pairs connect, each ascending, in the order of their first bodies. A body
/// of no pair is in no group. A pair with a partner that is not in `bodies`, such as the ground,
/// puts a body in a group but connects none. @param bodies   Ascending.
std::vector<std::vector<BodyId>> connected_components(const std::vector<BodyId>& bodies,
                                                      const std::vector<Pair>& pairs);

/// Box around the places of a body's shape in the next `step` [s], if nothing accelerates the body
/// by more than twice gravity [m/s^2]. It is empty for an empty shape.
/// @param shape_B   Box around the shape in the body's frame.
Eigen::AlignedBox3d swept_box(const Eigen::AlignedBox3d& shape_B, const hydro::BodyState& state,
                              double gravity, double step);

/// Pairs of indices of boxes that overlap, ascending. Empty boxes overlap nothing.
std::vector<std::pair<std::size_t, std::size_t>> overlapping(
    const std::vector<Eigen::AlignedBox3d>& boxes);

/// The same for boxes that move little from one call to the next: each has a wider box, and pairs
/// of those are searched again only when a box has left its own.
class BroadPhase {
 public:
  std::vector<std::pair<std::size_t, std::size_t>> find(
      const std::vector<Eigen::AlignedBox3d>& boxes);

 private:
  std::vector<Eigen::AlignedBox3d> wide_;                   ///< The wider boxes.
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  ///< Pairs of those, ascending.
};

}  // namespace engine

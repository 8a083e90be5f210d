#pragma once

#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "engine/spec.h"

/// @file
/// Which bodies can meet in a step, and which of them connections make one group.

namespace engine {

using Pair = std::pair<BodyId, BodyId>;  ///< Ascending; kWorld, the ground or the world, is first.

/// Groups of bodies that pairs connect, each ascending, in the order of their first body. A body of
/// no pair is in no group. A partner that is not in `bodies`, such as the ground, puts a body in a
/// group but connects none.
/// @param bodies   Ascending.
std::vector<std::vector<BodyId>> connected_components(const std::vector<BodyId>& bodies,
                                                      const std::vector<Pair>& pairs);

/// Box around a body's shape wherever it is in the next `step` [s] by its own motion, if nothing
/// speeds it up by more than twice gravity [m/s^2]. Empty for an empty shape.
/// @param shape_B   Box around the shape in the body's frame.
Eigen::AlignedBox3d swept_box(const Eigen::AlignedBox3d& shape_B, const hydro::BodyState& state,
                              double gravity, double step);

/// Pairs of boxes that overlap, as indices of them, ascending. Empty boxes overlap nothing.
std::vector<std::pair<std::size_t, std::size_t>> overlapping(
    const std::vector<Eigen::AlignedBox3d>& boxes);

/// The same for boxes that move little from one call to the next: each is kept in a wider box, and
/// pairs of those are searched again only when a box has left its own.
class BroadPhase {
 public:
  std::vector<std::pair<std::size_t, std::size_t>> find(
      const std::vector<Eigen::AlignedBox3d>& boxes);

 private:
  bool hold(const std::vector<Eigen::AlignedBox3d>& boxes) const;

  std::vector<Eigen::AlignedBox3d> wide_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  ///< Of those, ascending.
};

}  // namespace engine

#include "engine/contacts/broad_phase.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "engine/base/constants.h"

namespace engine {
namespace {

/// The smallest index that is connected to i, with paths halved on the way.
std::size_t root(std::vector<std::size_t>& leader, std::size_t i) {
  while (leader[i] != i) i = leader[i] = leader[leader[i]];
  return i;
}

/// The box with a margin; the infinite box of the ground needs none.
Eigen::AlignedBox3d widened(const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d sizes = box.sizes();
  if (box.isEmpty() || !sizes.allFinite()) return box;
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kBroadPhaseMargin * sizes.maxCoeff());
  return {box.min() - margin, box.max() + margin};
}

}  // namespace

std::vector<std::vector<BodyId>> connected_components(const std::vector<BodyId>& bodies,
                                                      const std::vector<Pair>& pairs) {
  std::vector<std::size_t> leader(bodies.size());
  std::iota(leader.begin(), leader.end(), std::size_t{0});
  std::vector<bool> connected(bodies.size(), false);
  const auto place_of = [&](BodyId id) -> std::optional<std::size_t> {
    const auto place = std::lower_bound(bodies.begin(), bodies.end(), id);
    if (place == bodies.end() || *place != id) return std::nullopt;
    return static_cast<std::size_t>(place - bodies.begin());
  };
  for (const auto& [first, second] : pairs) {
    const auto a = place_of(first), b = place_of(second);
    if (a) connected[*a] = true;
    if (b) connected[*b] = true;
    if (!a || !b) continue;
    const std::size_t i = root(leader, *a), j = root(leader, *b);
    leader[std::max(i, j)] = std::min(i, j);
  }
  std::vector<std::vector<BodyId>> members(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (connected[i]) members[root(leader, i)].push_back(bodies[i]);
  std::erase_if(members, [](const std::vector<BodyId>& group) { return group.empty(); });
  return members;
}

Eigen::AlignedBox3d swept_box(const Eigen::AlignedBox3d& shape_B, const hydro::BodyState& state,
                              double gravity, double step) {
  if (shape_B.isEmpty()) return shape_B;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Eigen::Vector3d half = shape_B.sizes() / 2;
  const double radius = shape_B.center().norm() + half.norm();
  // A chord is no longer than its arc, nor than the diameter.
  const double turned = radius * std::min(2.0, state.angular_velocity.norm() * step);
  const Eigen::Vector3d moved = step * state.linear_velocity;
  const Eigen::Vector3d extent =
      R_WB.cwiseAbs() * half + Eigen::Vector3d::Constant(turned + gravity * step * step);
  const Eigen::Vector3d center = state.position + R_WB * shape_B.center();
  return {center + moved.cwiseMin(0) - extent, center + moved.cwiseMax(0) + extent};
}

std::vector<std::pair<std::size_t, std::size_t>> overlapping(
    const std::vector<Eigen::AlignedBox3d>& boxes) {
  std::vector<std::pair<double, std::size_t>> order;  // by their lower ends in x
  order.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].isEmpty()) order.emplace_back(boxes[i].min().x(), i);
  std::sort(order.begin(), order.end());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (auto a = order.begin(); a != order.end(); ++a) {
    const Eigen::AlignedBox3d& box = boxes[a->second];
    for (auto b = a + 1; b != order.end() && b->first <= box.max().x(); ++b)
      if (box.intersects(boxes[b->second])) pairs.emplace_back(std::minmax(a->second, b->second));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<std::pair<std::size_t, std::size_t>> BroadPhase::find(
    const std::vector<Eigen::AlignedBox3d>& boxes) {
  const bool contained =
      std::equal(boxes.begin(), boxes.end(), wide_.begin(), wide_.end(),
                 [](const auto& box, const auto& wide) { return wide.contains(box); });
  if (!contained) {
    wide_.clear();
    for (const Eigen::AlignedBox3d& box : boxes) wide_.push_back(widened(box));
    pairs_ = overlapping(wide_);
  }
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (const auto& pair : pairs_)
    if (boxes[pair.first].intersects(boxes[pair.second])) found.push_back(pair);
  return found;
}

}  // namespace engine

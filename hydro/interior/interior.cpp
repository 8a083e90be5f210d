#include "hydro/interior/interior.h"

#include <algorithm>
#include <cmath>

#include "hydro/loads/kernel/walk.h"
#include "hydro/statics/buoyancy_energy.h"

namespace hydro {
namespace {

/// Error of a volume, over itself.
constexpr double kVolumeError = 1e-13;
/// Error of a volume, over it, beyond which no level has that volume [-].
constexpr double kLargestVolumeError = 1e-6;

/// Fall of a volume, over the one that is looked for, that is no round-off [-].
constexpr double kLeastFall = 0.01;

/// Limit of the trials for a level; as a rule two to four suffice.
constexpr int kMostTrials = 200;

/// The faces of a mesh as a hull of their own, with the vertices that they name.
Hull open_hull(const TriMesh& mesh, const std::vector<int>& faces) {
  TriMesh part;
  std::vector<int> place(mesh.vertex_count(), -1);
  std::vector<int> used;
  part.faces.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t k = 0; k < faces.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      const int v = mesh.faces(i, faces[k]);
      if (place[v] < 0) {
        place[v] = static_cast<int>(used.size());
        used.push_back(v);
      }
      part.faces(i, static_cast<Eigen::Index>(k)) = place[v];
    }
  part.vertices.resize(3, static_cast<Eigen::Index>(used.size()));
  for (std::size_t k = 0; k < used.size(); ++k)
    part.vertices.col(static_cast<Eigen::Index>(k)) = mesh.vertices.col(used[k]);
  return make_hull(std::move(part), Hull::Boundary::open);
}

/// −∫ h n dS with its moment over the faces below a level, in W.
Wrench push_below(const Hull& pocket, const Eigen::Matrix3d& R_WB, double level) {
  kernel::LoadInputs in;
  in.below = level;
  for (int axis = 0; axis < 3; ++axis) in.up[axis] = R_WB(2, axis);
  const kernel::Sums sums = kernel::sum_hull(pocket.panels, pocket.tree, in);
  const auto vector = [&](int from) {
    return Eigen::Vector3d(sums.total(from), sums.total(from + 1), sums.total(from + 2));
  };
  return {R_WB * vector(kernel::kBuoyancy), R_WB * vector(kernel::kBuoyancy + 3)};
}

/// Heights that bound a pocket.
struct Span {
  double lowest, highest;
};

Span span_of(const Hull& pocket, const Eigen::Matrix3d& R_WB) {
  const kernel::Node& root = pocket.tree.nodes[0];
  const Eigen::Map<const Eigen::Vector3d> centre(root.centre), half(root.half);
  const double middle = R_WB.row(2).dot(centre);
  const double reach = R_WB.row(2).cwiseAbs().dot(half);
  return {middle - reach, middle + reach};
}

}  // namespace

std::shared_ptr<const Interior> make_interior(const TriMesh& mesh_B, const Eigen::Vector3d& up_B) {
  Pockets division = find_pockets(mesh_B, up_B);
  if (division.pockets.empty()) return nullptr;
  auto interior = std::make_shared<Interior>();
  interior->up_B = up_B;
  std::vector<int> outside;
  for (int f = 0; f < mesh_B.face_count(); ++f)
    if (division.pocket_of_face[f] == kSea) outside.push_back(f);
  interior->outside = open_hull(mesh_B, outside);
  for (const Pocket& pocket : division.pockets)
    interior->pockets.push_back(open_hull(mesh_B, pocket.faces));
  interior->division = std::move(division);
  return interior;
}

WaterInside water_up_to(const Hull& pocket, const Eigen::Matrix3d& R_WB, double level) {
  WaterInside water{.level = level, .push = push_below(pocket, R_WB, level)};
  water.volume = -water.push.force.z();
  return water;
}

WaterInside water_of(const Hull& pocket, const Eigen::Matrix3d& R_WB, double volume,
                     const LevelGuess& guess) {
  const Span span = span_of(pocket, R_WB);
  if (!(volume > 0)) return {.level = span.lowest};
  const double ceiling = 2 * span.highest - span.lowest;
  double low = span.lowest, low_volume = 0, high = HUGE_VAL, area = guess.area;
  // Towards the tip of a corner secants creep, and below the pocket there is none. In a pocket that
  // has been turned over the volume falls again above the level up to which it holds water.
  bool creeps = false, falls = false;
  WaterInside at = water_up_to(pocket, R_WB, std::clamp(guess.level, low, span.highest));
  for (int i = 0; i < kMostTrials && std::abs(at.volume - volume) > kVolumeError * volume; ++i) {
    const bool past = at.volume < low_volume - kLeastFall * volume;
    falls = falls || past;
    if (at.volume > volume || past) {
      high = at.level;
    } else {
      low = at.level;
      low_volume = at.volume;
    }
    double next = at.level + (volume - at.volume) / area;
    if (creeps || !(next > low && next < high))
      next = high < HUGE_VAL ? (low + high) / 2 : at.level + span.highest - span.lowest;
    next = std::min(next, ceiling);
    if (next == low || next == high) break;  // No number lies between.
    const WaterInside there = water_up_to(pocket, R_WB, next);
    const double gain = there.volume - at.volume;
    // A void that is full holds no more.
    if (next > at.level && at.level >= span.highest && gain <= kVolumeError * volume) break;
    if (gain != 0) area = gain / (next - at.level);
    creeps = std::abs(there.volume - volume) > std::abs(at.volume - volume) / 2;
    at = there;
  }
  // Water that a pocket cannot hold runs out and presses on nothing.
  const bool missed = std::abs(at.volume - volume) > kLargestVolumeError * volume;
  if (at.level >= ceiling || (missed && falls)) return {.level = span.lowest};
  if (missed) at.push = {};
  at.area = area;
  return at;
}

Eigen::Vector3d centroid_of(const Hull& pocket, const Eigen::Matrix3d& R_WB,
                            const WaterInside& water) {
  if (!(water.volume > 0)) return Eigen::Vector3d::Zero();
  const double depth = depth_moment(pocket, R_WB, water.level) / water.volume;
  const Eigen::Vector3d& moment = water.push.moment;
  return {moment.y() / water.volume, -moment.x() / water.volume, water.level - depth};
}

}  // namespace hydro

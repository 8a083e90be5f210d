#include "hydro/added_mass/surface_added_mass.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "hydro/added_mass/water_entry.h"
#include "hydro/airy_waves.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Number of steps in the 90° from axis to axis. Interpolation errors fall with its square; the
/// number of nodes grows with it.
constexpr int kAttitudes = 12;

/// Numbers of steps of the draught from dry to just submerged, and from there to unbounded fluid.
constexpr int kPiercing = 12;
constexpr int kSubmerged = 6;
constexpr int kUnbounded = kPiercing + kSubmerged;

/// Where a curved bottom meets the surface at less than about 20°, equation (1) of surface_solve.h
/// is badly conditioned: it is 0 = 0 where body and image touch. Up to this draught (18 % of the
/// volume) a solution is checked for two exact properties: it is symmetric, and added mass grows
/// with draught. A solution that violates them by more than the discretisation error is replaced by
/// its neighbour's, in proportion to that of a plate.
constexpr int kShallow = 3;

/// Draught up to which the ratio to a plate is interpolated; over the next step it goes over into
/// the matrix itself.
constexpr double kOfPlates = 2;

constexpr double kMostAsymmetry = 0.05;
constexpr double kMostExcess = 1.02;

/// Wetted fraction of a body's volume at a surface-piercing node [-].
double wetted_part(int draught) {
  const double x = static_cast<double>(draught) / kPiercing;
  return 1 - std::pow(1 - x * x, 3);
}

}  // namespace

SurfaceAddedMass::SurfaceAddedMass(TriMesh mesh_B, const std::vector<SurfaceNode>& known,
                                   int patches)
    : mesh_B_(std::move(mesh_B)),
      middle_(bounding_box(mesh_B_).center()),
      volume_(wetted_volume(mesh_B_, WaterPlane{})),
      radius_((mesh_B_.vertices.colwise() - middle_).colwise().norm().maxCoeff()),
      patches_(patches),
      attitudes_(kAttitudes) {
  for (const SurfaceNode& one : known) nodes_[{one.attitude, one.draught}] = one.matrix;
}

Matrix6d SurfaceAddedMass::at(const BodyState& state, const Sea& sea, double time) const {
  assert(is_unit(state.orientation));
  const Vector3d& p = state.position;
  const WaterPlane plane{state.orientation.conjugate() * Vector3d::UnitZ(),
                         surface_height(sea, p.x(), p.y(), time) - p.z()};
  return sea.density * under(plane);
}

Wrench SurfaceAddedMass::wave_load(const BodyState& state, const Sea& sea, double time) const {
  if (!has_airy_waves(sea)) return {};
  return waves_.at(at(state, sea, time), mesh_B_, state, sea, time);
}

Matrix6d SurfaceAddedMass::under(const WaterPlane& plane) const {
  assert(is_unit(plane.up));
  const double draught = draught_of(plane);
  if (draught <= 0) return Matrix6d::Zero();
  const int lower = std::min(static_cast<int>(draught), kUnbounded - 1);
  const double upper_part = draught - lower;
  const double plain = std::clamp(draught - kOfPlates, 0.0, 1.0);
  const double plate_here = plain < 1 ? surface_cut(mesh_B_, risen(plane)).plate : 0;
  Matrix6d sum = Matrix6d::Zero();
  for (const AttitudeGrid::Corner& corner : attitudes_.around(plane.up)) {
    const auto add = [&](int at, double weight) {
      if (!(weight > 0)) return;
      if (plain > 0) sum += plain * weight * node(corner.node, at);
      if (plain == 1) return;
      const int ratio = std::max(1, at);
      sum +=
          (1 - plain) * weight * plate_here / plate(corner.node, ratio) * node(corner.node, ratio);
    };
    add(lower, corner.weight * (1 - upper_part));
    add(lower + 1, corner.weight * upper_part);
  }
  return sum;
}

SurfaceAddedMass::Reach SurfaceAddedMass::reach(const Vector3d& up) const {
  const Eigen::RowVectorXd heights = up.transpose() * mesh_B_.vertices;
  return {heights.minCoeff(), heights.maxCoeff()};
}

/// The draught as a coordinate in the grid: from 0, dry, to kUnbounded.
double SurfaceAddedMass::draught_of(const WaterPlane& plane) const {
  const double above = plane.height - plane.up.dot(middle_);
  if (above <= -radius_) return 0;
  const Reach body = reach(plane.up);
  if (plane.height <= body.low) return 0;
  if (plane.height < body.high) {
    const double wet = std::clamp(wetted_volume(mesh_B_, plane) / volume_, 0.0, 1.0);
    return kPiercing * std::sqrt(1 - std::cbrt(1 - wet));
  }
  const double near = radius_ / (radius_ + (plane.height - body.high));
  return kPiercing + kSubmerged * std::sqrt(1 - near * near * near);
}

WaterPlane SurfaceAddedMass::plane_of(int attitude, int draught) const {
  const Vector3d up = attitudes_.direction(attitude);
  const Reach body = reach(up);
  if (draught <= kPiercing) {
    const double wet = wetted_part(draught);
    double low = body.low, high = body.high;
    for (int step = 0; step < 50 && draught < kPiercing; ++step) {
      const double middle = 0.5 * (low + high);
      (wetted_volume(mesh_B_, {up, middle}) < wet * volume_ ? low : high) = middle;
    }
    return {up, high};
  }
  const double x = static_cast<double>(draught - kPiercing) / kSubmerged;
  return {up, body.high + radius_ * (1 / std::cbrt(1 - x * x) - 1)};
}

WaterPlane SurfaceAddedMass::risen(const WaterPlane& plane) const {
  const SurfaceCut cut = surface_cut(mesh_B_, plane);
  const double fresh = std::max(0.0, 1 - 2 * cut.volume / volume_);
  return {plane.up, plane.height + rise_at_entry(cut) * cut.draught * fresh * fresh};
}

double SurfaceAddedMass::plate(int attitude, int draught) const {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = plates_.find({attitude, draught}); found != plates_.end())
      return found->second;
  }
  const double plate = surface_cut(mesh_B_, risen(plane_of(attitude, draught))).plate;
  const std::lock_guard lock(mutex_);
  return plates_.emplace(std::pair(attitude, draught), plate).first->second;
}

Matrix6d SurfaceAddedMass::solved(int attitude, int draught) const {
  if (draught == kUnbounded) return solve_under(mesh_B_, WaterPlane{}, patches_).matrix;
  const SurfaceSolution own = solve_under(mesh_B_, risen(plane_of(attitude, draught)), patches_);
  if (draught > kShallow) return own.matrix;
  const auto weight = [](const Matrix6d& A) { return A.diagonal().head<3>().sum(); };
  const Matrix6d& deeper = node(attitude, draught + 1);
  if (own.symmetry_error < kMostAsymmetry && weight(own.matrix) <= kMostExcess * weight(deeper))
    return own.matrix;
  return std::min(1.0, plate(attitude, draught) / plate(attitude, draught + 1)) * deeper;
}

/// Two threads that miss the same node both solve it and find the same matrix, so neither waits in
/// the other's loop.
const Matrix6d& SurfaceAddedMass::node(int attitude, int draught) const {
  static const Matrix6d kDry = Matrix6d::Zero();
  if (draught == 0) return kDry;
  const std::pair<int, int> place(draught == kUnbounded ? 0 : attitude, draught);
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = nodes_.find(place); found != nodes_.end()) return found->second;
  }
  const Matrix6d matrix = solved(attitude, draught);
  const std::lock_guard lock(mutex_);
  const auto [entry, fresh] = nodes_.emplace(place, matrix);
  solves_ += fresh ? 1 : 0;
  return entry->second;
}

std::vector<SurfaceNode> SurfaceAddedMass::nodes() const {
  const std::lock_guard lock(mutex_);
  std::vector<SurfaceNode> all;
  for (const auto& [place, matrix] : nodes_) all.push_back({place.first, place.second, matrix});
  return all;
}

int SurfaceAddedMass::solves() const {
  const std::lock_guard lock(mutex_);
  return solves_;
}

}  // namespace hydro

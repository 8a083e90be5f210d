#include "hydro/added_mass/deep_added_mass.h"

#include <algorithm>

#include "hydro/added_mass/surface_cut.h"
#include "hydro/airy_waves.h"

namespace hydro {

using Eigen::Vector3d;

DeepAddedMass::DeepAddedMass(const TriMesh& mesh_B, const AddedMassSolution& solution,
                             const Sea* sea)
    : share_(mesh_B, solution, sea),
      box_B_(bounding_box(mesh_B)),
      volume_(wetted_volume(mesh_B, WaterPlane{})) {}

double DeepAddedMass::factor(const Matrix6d& share_B, const SurfaceCut* known,
                             const BodyState& state, const Sea& sea, double time) const {
  const WaterPlane plane = plane_about(state, sea, time);
  const double middle = plane.depth(box_B_.center());
  const double half = plane.up.cwiseAbs().dot(box_B_.sizes()) / 2;
  if (middle >= half) return 1;
  const SurfaceCut cut = known ? *known : cut_by(plane);
  const double dry = 1 - 2 * cut.volume / volume_;
  if (!(dry > 0)) return 1;
  const double fresh = dry * dry;
  const double rise = rise_at_entry(cut) * cut.draught * fresh;
  const double heave = heave_at_entry(rise > 0 ? cut_by({plane.up, plane.height + rise}) : cut);
  const double share = plane.up.dot(share_B.topLeftCorner<3, 3>() * plane.up);
  return heave < share ? std::lerp(1, heave / share, fresh) : 1;
}

SurfaceCut DeepAddedMass::cut_by(const WaterPlane& plane) const {
  return kernel::surface_cut(share_.panels(), share_.tree(), plane);
}

WaterPlane DeepAddedMass::plane_about(const BodyState& state, const Sea& sea, double time) const {
  const Eigen::Quaterniond to_B = state.orientation.conjugate();
  if (is_flat(sea)) return {to_B * Vector3d::UnitZ(), sea.level - state.position.z()};
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Vector3d middle = R_WB * box_B_.center();
  const Vector3d half = R_WB.cwiseAbs() * box_B_.sizes() / 2;
  const auto height = [&](double x, double y) {
    return surface_elevation(sea, state.position.x() + middle.x() + x,
                             state.position.y() + middle.y() + y, time);
  };
  const double west = height(-half.x(), 0), east = height(half.x(), 0);
  const double south = height(0, -half.y()), north = height(0, half.y());
  const Vector3d slope((east - west) / (2 * half.x()), (north - south) / (2 * half.y()), 0);
  const Vector3d up = (Vector3d::UnitZ() - slope).normalized();
  const double over_origin = (west + east + south + north) / 4 - slope.dot(middle);
  return {to_B * up, (sea.level - state.position.z() + over_origin) * up.z()};
}

Matrix6d DeepAddedMass::at(const BodyState& state, const Sea& sea, double time) const {
  const kernel::WettedShare part = share_.share(state, sea, time);
  if (part.share.isZero(0)) return part.share;
  const SurfaceCut* known = is_flat(sea) ? &part.cut : nullptr;
  return sea.density * factor(part.share, known, state, sea, time) * part.share;
}

Wrench DeepAddedMass::wave_load(const BodyState& state, const Sea& sea, double time) const {
  if (!has_airy_waves(sea)) return {};
  const WettedAddedMass::WaveLoad part = share_.load_of_waves(state, sea, time);
  if (part.matrix.isZero(0)) return {};
  return factor(part.matrix, nullptr, state, sea, time) * part.load;
}

}  // namespace hydro

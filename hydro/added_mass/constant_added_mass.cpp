#include "hydro/added_mass/constant_added_mass.h"

#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "hydro/loads/refine.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// True if the surface rises above a panel somewhere between its corners. Heights above the centre
/// of mass.
bool is_wet_between(const Panel& panel, double level, const SurfaceSampler& surface) {
  Vector3d elevation;
  for (int i = 0; i < 3; ++i) elevation[i] = surface.elevation(panel[i]);
  bool wet = false;
  for_each_linear_piece(panel, elevation, surface,
                        [&](const Panel& piece, const Vector3d& heights) {
                          for (int i = 0; i < 3; ++i) wet |= level + heights[i] > piece[i].z();
                        });
  return wet;
}

}  // namespace

bool is_wet(const Hull& hull, const BodyState& state, const Sea& sea, double time) {
  const SurfaceBounds bounds = surface_bounds(sea);
  if (state.position.z() - hull.radius >= bounds.highest) return false;
  const Eigen::Matrix3Xd r = state.orientation.toRotationMatrix() * hull.mesh_B.vertices;
  const double bottom = r.row(2).minCoeff() + state.position.z();
  if (bottom >= bounds.highest) return false;
  if (bottom < bounds.lowest) return true;
  const SurfaceSampler surface(sea, state.position, time, kSmallestPanel * hull.radius);
  const double level = sea.level - state.position.z();
  for (Eigen::Index i = 0; i < r.cols(); ++i)
    if (level + surface.elevation(r.col(i)) > r(2, i)) return true;
  for (Eigen::Index f = 0; f < hull.mesh_B.face_count(); ++f) {
    const auto vertex = hull.mesh_B.faces.col(f);
    if (is_wet_between({r.col(vertex[0]), r.col(vertex[1]), r.col(vertex[2])}, level, surface))
      return true;
  }
  return false;
}

ConstantAddedMass::ConstantAddedMass(TriMesh mesh_B, const Matrix6d& matrix)
    : hull_(make_hull(std::move(mesh_B))), matrix_(semi_definite_part(matrix)) {}

Wrench ConstantAddedMass::wave_load(const BodyState& state, const Sea& sea, double time) const {
  if (!has_airy_waves(sea)) return {};
  return waves_.at(at(state, sea, time), hull_.mesh_B, state, sea, time);
}

Matrix6d ConstantAddedMass::at(const BodyState& state, const Sea& sea, double time) const {
  return is_wet(hull_, state, sea, time) ? matrix_ : Matrix6d::Zero();
}

}  // namespace hydro

#include "hydro/added_mass/plain_wetted_added_mass.h"

#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/loads/refine.h"

namespace hydro {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The barycentric coordinates in `panel` of the corners of a piece of it, a column a corner.
Matrix3d weights_in(const Panel& panel, const Panel& piece) {
  const Vector3d a = panel[1] - panel[0];
  const Vector3d b = panel[2] - panel[0];
  const Vector3d normal = a.cross(b);
  const Vector3d along = normal / normal.squaredNorm();
  Matrix3d weights;
  for (int i = 0; i < 3; ++i) {
    const Vector3d p = piece[static_cast<std::size_t>(i)] - panel[0];
    const double second = p.cross(b).dot(along);
    const double third = a.cross(p).dot(along);
    weights.col(i) << 1 - second - third, second, third;
  }
  return weights;
}

/// The share of the part of a face that has the given barycentric coordinates.
Matrix6d share_of_part(const Panel& face_B, const CornerPotentials& psi, const Matrix3d& weights) {
  Panel part_B;
  for (int i = 0; i < 3; ++i)
    part_B[static_cast<std::size_t>(i)] =
        weights(0, i) * face_B[0] + weights(1, i) * face_B[1] + weights(2, i) * face_B[2];
  return triangle_share(part_B, psi * weights);
}

}  // namespace

Matrix6d plain_wetted_added_mass(const TriMesh& mesh_B, const AddedMassSolution& solution,
                                 const BodyState& state, const Sea& sea, double time) {
  const double radius = mesh_B.vertices.colwise().norm().maxCoeff();
  const SurfaceSampler surface(sea, state.position, time, kSmallestPanel * radius);
  const Matrix3d R_WB = state.orientation.toRotationMatrix();
  const double level = sea.level - state.position.z();
  Matrix6d sum = Matrix6d::Zero();
  for (Eigen::Index f = 0; f < mesh_B.face_count(); ++f) {
    Panel face_B, panel;
    Vector3d elevation;
    for (std::size_t i = 0; i < 3; ++i) {
      face_B[i] = mesh_B.vertices.col(mesh_B.faces(static_cast<Eigen::Index>(i), f));
      panel[i] = R_WB * face_B[i];
      elevation[static_cast<Eigen::Index>(i)] = surface.elevation(panel[i]);
    }
    if (area_vector(panel).isZero(0)) continue;
    const CornerPotentials& psi = solution.potentials[static_cast<std::size_t>(f)];
    for_each_linear_piece(panel, elevation, surface, [&](const Panel& piece, const Vector3d& at) {
      const Vector3d depth(level + at[0] - piece[0].z(), level + at[1] - piece[1].z(),
                           level + at[2] - piece[2].z());
      for (const PanelPart& wet : positive_part(piece, depth))
        sum += share_of_part(face_B, psi, weights_in(panel, wet.panel));
    });
  }
  return sea.density * semi_definite_part(sum);
}

}  // namespace hydro

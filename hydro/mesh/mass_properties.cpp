#include "hydro/mesh/mass_properties.h"

namespace hydro {
namespace {

/// Integrals of 1, r and r·rᵀ over the solid, with r relative to a reference point.
struct VolumeMoments {
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
};

/// Adds the tetrahedron spanned by the origin and a face. The second moment of a tetrahedron of
/// volume V with a vertex at the origin is V/20 (Σ_i r_i r_iᵀ + s sᵀ), s = Σ_i r_i, because the
/// integral of two barycentric coordinates over it is V (1 + δ_ij)/20.
void add_tetrahedron(VolumeMoments& m, const Eigen::Matrix3d& r) {
  const double volume = r.col(0).dot(r.col(1).cross(r.col(2))) / 6;
  const Eigen::Vector3d sum = r.rowwise().sum();
  m.volume += volume;
  m.first += volume / 4 * sum;
  m.second += volume / 20 * (r * r.transpose() + sum * sum.transpose());
}

}  // namespace

SolidProperties solid_properties(const TriMesh& mesh) {
  if (mesh.face_count() == 0) return {};
  const Eigen::Vector3d origin = bounding_box(mesh).center();
  VolumeMoments m;
  for (const auto& face : mesh.faces.colwise()) {
    Eigen::Matrix3d r;
    for (int i = 0; i < 3; ++i) r.col(i) = mesh.vertices.col(face[i]) - origin;
    add_tetrahedron(m, r);
  }
  if (m.volume == 0) return {.volume = 0, .centroid = origin};
  const Eigen::Vector3d arm = m.first / m.volume;
  const Eigen::Matrix3d about_centroid = m.second - m.volume * (arm * arm.transpose());
  // The mean with the transpose is exactly symmetric, whatever the order of summation in products.
  const Eigen::Matrix3d second = (about_centroid + about_centroid.transpose()) / 2;
  return {.volume = m.volume,
          .centroid = origin + arm,
          .inertia = second.trace() * Eigen::Matrix3d::Identity() - second};
}

}  // namespace hydro

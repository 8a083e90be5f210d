#include "hydro/loads/bluntness.h"

#include <cmath>

#include "hydro/decompositions.h"

namespace hydro {
namespace {

/// Part of its trace that is added to ∫ n nᵀ dS so that the axes of a cube or a sphere are those of
/// its frame: it is above the roundings of the sum and far below what a shape makes of it.
constexpr double kTieBreak = 1e-9;

}  // namespace

Bluntness bluntness(const TriMesh& mesh) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (Eigen::Index face = 0; face < mesh.face_count(); ++face) {
    const Eigen::Vector3d a = area_vector(mesh, face);
    if (a.norm() > 0) spread += a * a.transpose() / a.norm();
  }
  if (!(spread.trace() > 0)) return {};
  spread.diagonal() += kTieBreak * spread.trace() * Eigen::Vector3d(0, 1, 2);
  Bluntness result{.axes = eigen_decomposition(spread).vectors};
  Eigen::Array3d projected = Eigen::Array3d::Zero(), weighted = Eigen::Array3d::Zero();
  for (Eigen::Index face = 0; face < mesh.face_count(); ++face) {
    const Eigen::Vector3d a = area_vector(mesh, face);
    const double area = a.norm();
    if (area == 0) continue;
    const Eigen::Array3d along = (result.axes.transpose() * a).array().abs();
    projected += along;
    weighted += along.cube() / (area * area);
  }
  for (int i = 0; i < 3; ++i)
    if (projected[i] > 0) result.along[i] = weighted[i] / projected[i];
  return result;
}

Eigen::Matrix3d drag_shape(const Bluntness& bluntness, double blunt) {
  if (bluntness.along.minCoeff() >= blunt) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d share = (bluntness.along / blunt).cwiseMin(1);
  return bluntness.axes * share.asDiagonal() * bluntness.axes.transpose();
}

}  // namespace hydro

#include "hydro/loads/bluntness.h"

#include <array>
#include <cmath>

#include "hydro/decompositions.h"

namespace hydro {
namespace {

/// Part of its trace that is added to ∫ n nᵀ dS so that the axes of a cube or a sphere are those of
/// its frame: it is above the roundings of the sum and far below what a shape makes of it.
constexpr double kTieBreak = 1e-9;

/// Square of the cosine of the angle to an axis from which on a face counts as flat [-].
constexpr double kFlat = 0.95;

/// Sums over the faces that look along an axis, and over those that look against it.
struct Ends {
  Eigen::Array2d projected = Eigen::Array2d::Zero();  ///< Projected area.
  Eigen::Array2d weighted = Eigen::Array2d::Zero();   ///< The same, weighted by cos².
  Eigen::Array2d flat = Eigen::Array2d::Zero();       ///< Projected area of flat faces.

  /// @param along   The face's area vector along the axis. @param area   Its length.
  void add(double along, double area) {
    const int end = along < 0;
    const double square = std::pow(along / area, 2);
    projected[end] += std::abs(along);
    weighted[end] += std::abs(along) * square;
    if (square > kFlat) flat[end] += std::abs(along);
  }
};

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
  std::array<Ends, 3> ends;
  for (Eigen::Index face = 0; face < mesh.face_count(); ++face) {
    const Eigen::Vector3d a = area_vector(mesh, face);
    if (a.norm() == 0) continue;
    const Eigen::Vector3d along = result.axes.transpose() * a;
    for (std::size_t i = 0; i < 3; ++i) ends[i].add(along[static_cast<Eigen::Index>(i)], a.norm());
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Ends& e = ends[static_cast<std::size_t>(i)];
    if (!(e.projected.sum() > 0)) continue;
    result.along[i] = e.weighted.sum() / e.projected.sum();
    if (!(e.projected.minCoeff() > 0)) continue;  // An open mesh keeps (1).
    result.finer_end[i] = (e.weighted / e.projected).minCoeff();
    result.flat[i] = (e.flat / e.projected).maxCoeff();
  }
  return result;
}

Eigen::Matrix3d drag_shape(const Bluntness& bluntness, double blunt) {
  const Eigen::Vector3d least =
      (bluntness.finer_end / blunt).cwiseMax(bluntness.flat.array().pow(1.0 / 3).matrix());
  const Eigen::Vector3d share = (bluntness.along / blunt).cwiseMin(least).cwiseMin(1);
  if (!(share.minCoeff() < 1)) return Eigen::Matrix3d::Identity();
  return bluntness.axes * share.asDiagonal() * bluntness.axes.transpose();
}

}  // namespace hydro

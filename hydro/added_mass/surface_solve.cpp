#include "hydro/added_mass/surface_solve.h"

#include <cmath>

#include "hydro/added_mass/patch_integrals.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/decompositions.h"
#include "hydro/parallel.h"

namespace hydro {
namespace {

using bem::kPerSphere;
using Eigen::Index;
using Eigen::Vector3d;

/// Term that keeps the constant of a closed cavity's potential finite, which (1) leaves free and
/// which causes no load. It is small enough to change nothing else.
constexpr double kCavity = 1e-8;

struct System {
  Eigen::MatrixXd matrix;
  Eigen::Matrix<double, Eigen::Dynamic, 6> side;
};

/// Fills the three rows of equation (1) for patch `i`.
void fill_rows(const std::vector<Patch>& patches, const std::vector<PatchMoments>& moments,
               const WaterPlane& plane, std::size_t i, System& system) {
  const Index row = 3 * static_cast<Index>(i);
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  for (const PatchPoint& point : patches[i].points) {
    const Vector3d f = patches[i].functions(point.at);
    const Vector3d test = point.weight / patches[i].area * f;
    own += test * f.transpose();
    for (std::size_t j = 0; j < patches.size(); ++j) {
      Seen seen;
      add_seen(patches[j], moments[j], point.at, kPerSphere, seen);
      if (plane.bounded())
        add_seen(patches[j], moments[j], plane.mirrored(point.at), -kPerSphere, seen);
      system.matrix.block<3, 3>(row, 3 * static_cast<Index>(j)) += test * seen.twofold.transpose();
      system.side.middleRows<3>(row) += test * seen.single;
    }
  }
  system.matrix.block<3, 3>(row, row) += (0.5 + kCavity) * own;
  for (Index k = 0; k < 2; ++k)  // a function that the patch lacks has a coefficient of 0
    if (patches[i].slopes[static_cast<std::size_t>(k)].isZero(0))
      system.matrix(row + k + 1, row + k + 1) = 1;
}

/// The symmetry_error of a matrix: rotations are divided by the root of the wetted area.
double asymmetry(const Matrix6d& matrix, const std::vector<Patch>& patches) {
  double area = 0;
  for (const Patch& patch : patches) area += patch.area;
  Vector6d lever = Vector6d::Ones();
  lever.tail<3>() *= std::sqrt(area);
  const Matrix6d even = lever.cwiseInverse().asDiagonal() * (matrix - matrix.transpose()) *
                        lever.cwiseInverse().asDiagonal();
  return even.cwiseAbs().maxCoeff() / matrix.diagonal().head<3>().maxCoeff();
}

}  // namespace

SurfaceSolution solve_under(const TriMesh& mesh_B, const WaterPlane& plane, int count) {
  const std::vector<Patch> patches = wetted_patches(mesh_B, plane, count);
  if (patches.empty()) return {};
  std::vector<PatchMoments> moments;
  for (const Patch& patch : patches) moments.push_back(moments_of(patch));
  const Index unknowns = 3 * static_cast<Index>(patches.size());
  System system{Eigen::MatrixXd::Zero(unknowns, unknowns),
                Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(unknowns, 6)};
  parallel_for(patches.size(),
               [&](std::size_t i) { fill_rows(patches, moments, plane, i, system); });
  const Eigen::Matrix<double, Eigen::Dynamic, 6> psi = solve_dense(system.matrix, system.side);
  Matrix6d matrix = Matrix6d::Zero();
  for (std::size_t i = 0; i < patches.size(); ++i)
    matrix += psi.middleRows<3>(3 * static_cast<Index>(i)).transpose() * moments[i].load;
  SurfaceSolution solution{.unknowns = static_cast<int>(unknowns)};
  solution.symmetry_error = asymmetry(matrix, patches);
  solution.matrix = semi_definite_part(matrix);
  return solution;
}

}  // namespace hydro

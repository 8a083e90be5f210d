#include "hydro/added_mass/rigid_wave_load.h"

#include <Eigen/Eigenvalues>

#include "hydro/airy_waves.h"
#include "hydro/loads/refine.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Eigenvalues of ∫ J Jᵀ dS below this part of the largest belong to motions that move no water.
constexpr double kLeast = 1e-6;

/// ∫ J Jᵀ dS and ∫ J u̇·n dS, with r over the radius.
struct NormalEquations {
  Matrix6d matrix = Matrix6d::Zero();
  Vector6d rhs = Vector6d::Zero();
};

/// Adds a wet panel by the rule of the edges' middles, which is exact for linear u̇ and J.
void add_panel(const Panel& panel, const Vector3d& depth, const AiryWaves& waves,
               const Vector3d& p_WB, double radius, NormalEquations& sum) {
  const Vector3d a = area_vector(panel);
  const double area = a.norm();
  if (area == 0) return;
  const Vector3d n = a / area;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vector3d r = (panel[i] + panel[j]) / 2;
    Vector6d J;
    J << n, r.cross(n) / radius;
    const double u_n = waves.at(p_WB + r, (depth[i] + depth[j]) / 2).acceleration.dot(n);
    sum.matrix += area / 3 * J * J.transpose();
    sum.rhs += area / 3 * u_n * J;
  }
}

/// The least solution of the equations.
Vector6d solve(const NormalEquations& equations) {
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(equations.matrix);
  const Vector6d& values = eigen.eigenvalues();
  Vector6d inverse = Vector6d::Zero();
  for (int i = 0; i < 6; ++i)
    if (values[i] > kLeast * values[5]) inverse[i] = 1 / values[i];
  return eigen.eigenvectors() *
         inverse.cwiseProduct(eigen.eigenvectors().transpose() * equations.rhs);
}

}  // namespace

Wrench rigid_wave_load(const Matrix6d& A, const TriMesh& mesh_B, const BodyState& state,
                       const Sea& sea, double time) {
  const AiryWaves waves(sea, time);
  if (waves.waves().empty() || A.isZero(0)) return {};
  const double radius = mesh_B.vertices.colwise().norm().maxCoeff();
  const SurfaceSampler surface(sea, state.position, time, kSmallestPanel * radius);
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Eigen::Matrix3Xd r = R_WB * mesh_B.vertices;
  const double level = sea.level - state.position.z();
  NormalEquations equations;
  const auto add_piece = [&](const Panel& piece, const Vector3d& elevation) {
    const Vector3d z(piece[0].z(), piece[1].z(), piece[2].z());
    for (const PanelPart& wet : positive_part(piece, (elevation - z).array() + level))
      add_panel(wet.panel, wet.value, waves, state.position, radius, equations);
  };
  for (const auto& face : mesh_B.faces.colwise()) {
    const Panel panel = {r.col(face[0]), r.col(face[1]), r.col(face[2])};
    const Vector3d elevation(surface.elevation(panel[0]), surface.elevation(panel[1]),
                             surface.elevation(panel[2]));
    for_each_linear_piece(panel, elevation, surface, add_piece);
  }
  Vector6d a = solve(equations);
  a.tail<3>() /= radius;
  Vector6d a_B;
  a_B << R_WB.transpose() * a.head<3>(), R_WB.transpose() * a.tail<3>();
  const Vector6d load = A * a_B;
  return {R_WB * load.head<3>(), R_WB * load.tail<3>()};
}

}  // namespace hydro

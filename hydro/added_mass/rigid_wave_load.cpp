#include "hydro/added_mass/rigid_wave_load.h"

#include "hydro/airy_waves.h"
#include "hydro/decompositions.h"

namespace hydro {
namespace {

/// Eigenvalues of ∫ J Jᵀ dS below this part of the largest belong to motions that move no water.
constexpr double kLeast = 1e-6;

/// ψ_m = J_m on every face.
AddedMassSolution rigid_potentials(const TriMesh& mesh) {
  AddedMassSolution solution;
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    const Eigen::Vector3d a = area_vector(mesh, f);
    const Eigen::Vector3d n = a.isZero(0) ? a : a.normalized();
    CornerPotentials psi;
    std::array<Eigen::Vector3d, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d r = mesh.vertices.col(mesh.faces(i, f));
      corners[static_cast<std::size_t>(i)] = r;
      psi.col(i) << n, r.cross(n);
    }
    solution.matrix += triangle_share(corners, psi);
    solution.potentials.push_back(psi);
  }
  solution.matrix = (0.5 * (solution.matrix + solution.matrix.transpose())).eval();
  return solution;
}

/// The least solution of M a = b for a semi-definite M.
Vector6d least_solution(const Matrix6d& M, const Vector6d& b) {
  const EigenDecomposition6 eigen = eigen_decomposition(M);
  const double least = kLeast * eigen.values.maxCoeff();
  Vector6d inverse = Vector6d::Zero();
  for (int i = 0; i < 6; ++i)
    if (eigen.values[i] > least) inverse[i] = 1 / eigen.values[i];
  return eigen.vectors * inverse.cwiseProduct(eigen.vectors.transpose() * b);
}

}  // namespace

Wrench RigidWaveLoad::at(const Matrix6d& A, const TriMesh& mesh_B, const BodyState& state,
                         const Sea& sea, double time) const {
  if (!has_airy_waves(sea) || A.isZero(0)) return {};
  std::call_once(made_, [&] {
    radius_ = mesh_B.vertices.colwise().norm().maxCoeff();
    flow_ = std::make_unique<const WettedAddedMass>(mesh_B, rigid_potentials(mesh_B));
  });
  const kernel::WaveShare flow = flow_->wave_share(state, sea, time);
  Vector6d scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1 / radius_);
  const Matrix6d share = scale.asDiagonal() * flow.share * scale.asDiagonal();
  const Vector6d a = scale.cwiseProduct(
      least_solution(0.5 * (share + share.transpose()), scale.cwiseProduct(flow.load)));
  const Vector6d load = A * a;
  return {state.orientation * load.head<3>(), state.orientation * load.tail<3>()};
}

}  // namespace hydro

#include "hydro/added_mass/wetted_added_mass.h"

#include <cassert>
#include <optional>

#include "hydro/added_mass/wetted_share.h"
#include "hydro/decompositions.h"
#include "hydro/loads/kernel/water_surface.h"
#include "hydro/loads/refine.h"

namespace hydro {

using Eigen::Vector3d;

Matrix6d semi_definite_part(const Matrix6d& matrix) {
  const Matrix6d symmetric = 0.5 * (matrix + matrix.transpose());
  if (Cholesky6(symmetric).positive_definite()) return symmetric;
  const EigenDecomposition6 eigen = eigen_decomposition(symmetric);
  if (eigen.values[0] >= 0) return symmetric;
  const Vector6d kept = eigen.values.cwiseMax(0);
  const Matrix6d part = eigen.vectors * kept.asDiagonal() * eigen.vectors.transpose();
  return 0.5 * (part + part.transpose());
}

WettedAddedMass::WettedAddedMass(const TriMesh& mesh_B, const AddedMassSolution& solution)
    : radius_(mesh_B.vertices.colwise().norm().maxCoeff()),
      whole_(semi_definite_part(solution.matrix)),
      panels_(kernel::make_panels(mesh_B)),
      tree_(kernel::make_tree(panels_)),
      potentials_(kernel::make_potentials(mesh_B, panels_, tree_, solution.potentials)) {
  assert(is_symmetric(solution.matrix));
}

Matrix6d WettedAddedMass::at(const BodyState& state, const Sea& sea, double time) const {
  assert(is_unit(state.orientation));
  const SurfaceBounds bounds = surface_bounds(sea);
  if (tree_.nodes.empty() || state.position.z() - radius_ >= bounds.highest)
    return Matrix6d::Zero();
  if (state.position.z() + radius_ < bounds.lowest) return sea.density * whole_;
  const Vector3d up_B = state.orientation.conjugate() * Vector3d::UnitZ();
  const kernel::Node& root = tree_.nodes.front();
  const double middle = state.position.z() + up_B.dot(Vector3d::Map(root.centre));
  const double half = up_B.cwiseAbs().dot(Vector3d::Map(root.half));
  if (middle - half >= bounds.highest) return Matrix6d::Zero();
  if (middle + half < bounds.lowest) return sea.density * whole_;
  kernel::LoadInputs in;
  Vector3d::Map(in.up) = up_B;
  in.below = sea.level - state.position.z();
  std::optional<kernel::WaterSurface> surface;
  if (!is_flat(sea)) {
    surface.emplace(sea, state, time, kSmallestPanel * radius_, panels_.longest_edge);
    in.surface = &*surface;
  }
  return sea.density * semi_definite_part(kernel::wetted_share(panels_, tree_, potentials_, in));
}

}  // namespace hydro

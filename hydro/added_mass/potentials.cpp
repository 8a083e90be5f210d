#include "hydro/added_mass/potentials.h"

#include <algorithm>
#include <cassert>

namespace hydro::kernel {
namespace {

/// Twice the area over the sum of the squared coordinates below which a face is a line: the slope
/// across it would be noise, and its area is nothing.
constexpr double kThinnest = 1e-14;

/// ψ_c, ψ_x and ψ_y of each function: a row a function.
CornerPotentials in_the_plane(const Face& face, const CornerPotentials& at_corners) {
  const Eigen::Vector3d &x = face.x, &y = face.y;
  CornerPotentials psi = CornerPotentials::Zero();
  psi.col(0) = at_corners.rowwise().mean();
  const double twice_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  if (!(twice_area > kThinnest * (x.squaredNorm() + y.squaredNorm()))) return psi;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    psi.col(1) += (y[j] - y[k]) / twice_area * at_corners.col(i);
    psi.col(2) += (x[k] - x[j]) / twice_area * at_corners.col(i);
  }
  return psi;
}

Matrix6d share_of(const TriMesh& mesh_B, int face, const CornerPotentials& psi) {
  const auto v = mesh_B.faces.col(face);
  return triangle_share(
      {mesh_B.vertices.col(v[0]), mesh_B.vertices.col(v[1]), mesh_B.vertices.col(v[2])}, psi);
}

}  // namespace

Potentials make_potentials(const TriMesh& mesh_B, const Panels& panels, const Tree& tree,
                           const std::vector<CornerPotentials>& corners) {
  assert(static_cast<Eigen::Index>(corners.size()) == mesh_B.face_count());
  Potentials potentials;
  potentials.blocks.resize(panels.leaves.size() * kLeafFaces / kMostLanes);
  std::vector<Matrix6d> of_leaf(panels.leaves.size(), Matrix6d::Zero());
  for (std::size_t place = 0; place < panels.face.size(); ++place) {
    const int face = panels.face[place];
    const CornerPotentials& psi = corners[static_cast<std::size_t>(face)];
    const std::size_t leaf = place / kLeafFaces;
    of_leaf[leaf] += share_of(mesh_B, face, psi);
    potentials.largest = std::max(potentials.largest, psi.topRows<3>().cwiseAbs().maxCoeff());
    const CornerPotentials rows =
        in_the_plane(face_of(panels.leaves[leaf], static_cast<int>(place % kLeafFaces)), psi);
    PotentialBlock& block = potentials.blocks[place / kMostLanes];
    for (int m = 0; m < 6; ++m)
      for (int i = 0; i < 3; ++i) block.row[3 * m + i][place % kMostLanes] = rows(m, i);
  }
  potentials.shares.resize(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {  // Children stand behind their parent.
    const Node& node = tree.nodes[i];
    if (node.leaf()) {
      potentials.shares[i] = of_leaf[static_cast<std::size_t>(node.first)];
    } else {
      const auto right = static_cast<std::size_t>(tree.nodes[i + 1].next);
      potentials.shares[i] = potentials.shares[i + 1] + potentials.shares[right];
    }
  }
  return potentials;
}

}  // namespace hydro::kernel

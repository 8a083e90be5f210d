#include "hydro/statics/immersed_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "hydro/mesh/mass_properties.h"

namespace hydro {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kMargin = 1e-12;  ///< Over the body's radius.

/// ∫ k·n f dS over a branch for the factor f of a row of its moments.
double along(const Vector3d& k, const kernel::Node& node, int row) {
  return k.dot(Eigen::Map<const Vector3d>(node.moment[row]));
}

/// Adds (7) of a branch that is wholly wet.
void add_whole(const kernel::Node& node, const Matrix3d& R_WB, double h, WetSums& sums) {
  using namespace kernel;
  const Vector3d k = R_WB.row(2).transpose();
  const auto of = [&](int row) { return along(k, node, row); };
  const double a = of(kOne);
  const Vector3d s(of(kPlace), of(kPlace + 1), of(kPlace + 2));
  const double xy = of(kSquare + 3), yz = of(kSquare + 4), zx = of(kSquare + 5);
  Matrix3d Q;
  Q << of(kSquare), xy, zx, xy, of(kSquare + 1), yz, zx, yz, of(kSquare + 2);
  const Vector3d Qk = Q * k;
  sums.volume += k.dot(s) + h * a;
  sums.horizontal += R_WB.topRows<2>() * (Qk + h * s);
  sums.depth -= (k.dot(Qk) + 2 * h * k.dot(s) + h * h * a) / 2;
  sums.surface += node.moment[kOne][kAreaLane];
}

}  // namespace

ImmersedMesh::ImmersedMesh(const TriMesh& mesh_B)
    : mesh_B_(mesh_B),
      margin_(kMargin * mesh_B.vertices.colwise().norm().maxCoeff()),
      volume_(solid_properties(mesh_B).volume) {
  kernel::Panels panels = kernel::make_panels(mesh_B);
  tree_ = kernel::make_tree(panels);
  faces_ = std::move(panels.face);
}

void ImmersedMesh::add_leaf(const kernel::Node& leaf, const Matrix3d& R_WB, double height,
                            WetSums& sums) const {
  const std::size_t first = static_cast<std::size_t>(leaf.first) * kernel::kLeafFaces;
  const std::size_t last = std::min(faces_.size(), first + kernel::kLeafFaces);
  for (std::size_t i = first; i < last; ++i) {
    Panel panel = panel_of(mesh_B_, faces_[i]);
    Vector3d depth;
    for (int corner = 0; corner < 3; ++corner) {
      Vector3d& r = panel[static_cast<std::size_t>(corner)];
      r = R_WB * r;
      depth[corner] = -(r.z() + height);
    }
    add_panel(panel, depth, sums);
  }
}

Hydrostatics ImmersedMesh::at(const Matrix3d& R_WB, double height) const {
  WetSums sums;
  const auto k = R_WB.row(2);
  const int count = static_cast<int>(tree_.nodes.size());
  for (int i = 0; i < count;) {
    const kernel::Node& node = tree_.nodes[static_cast<std::size_t>(i)];
    const double above = k.dot(Eigen::Map<const Vector3d>(node.centre)) + height;
    const double reach = k.cwiseAbs().dot(Eigen::Map<const Vector3d>(node.half)) + margin_;
    const bool dry = above - reach >= 0, wet = above + reach < 0;
    if (wet) add_whole(node, R_WB, height, sums);
    if (!wet && !dry && node.leaf()) add_leaf(node, R_WB, height, sums);
    i = wet || dry ? node.next : i + 1;
  }
  return hydrostatics_of(sums, height);
}

double ImmersedMesh::lowest(const Matrix3d& R_WB) const {
  return (R_WB.row(2) * mesh_B_.vertices).minCoeff();
}

double ImmersedMesh::floating_height(const Matrix3d& R_WB, double volume) const {
  if (!(volume > 0 && volume < volume_))
    throw std::invalid_argument("found a displacement of " + std::to_string(volume) +
                                " m^3, expected more than 0 and less than the body's volume, " +
                                std::to_string(volume_) + " m^3");
  double wet =
      -(R_WB.row(2) * mesh_B_.vertices).maxCoeff();  // heights at which the body is all wet
  double dry = -lowest(R_WB);                        // and all dry
  double height = wet + (dry - wet) * (1 - volume / volume_);
  for (int i = 0; i < 200; ++i) {
    const Hydrostatics h = at(R_WB, height);
    const double excess = h.volume - volume;
    if (std::abs(excess) <= 1e-15 * volume) break;
    (excess > 0 ? wet : dry) = height;
    double next = height + excess / h.waterplane.area;
    if (!(next > wet && next < dry)) next = (wet + dry) / 2;  // also for an area of 0
    if (next == height || next == wet || next == dry) break;  // neighbouring numbers
    height = next;
  }
  return height;
}

}  // namespace hydro

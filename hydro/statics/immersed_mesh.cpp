#include "hydro/statics/immersed_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "hydro/mesh/mass_properties.h"

namespace hydro {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kLeafFaces = 32;
constexpr double kMargin = 1e-12;  ///< Over the body's radius.

/// Adds (7) of faces that are wholly wet.
template <class Node>
void add_whole(const Node& node, const Matrix3d& R_WB, double h, WetSums& sums) {
  const Vector3d k = R_WB.row(2).transpose();
  const double a = k.dot(node.area);
  const Vector3d s = node.first_moment.transpose() * k;
  const Vector3d Qk =
      (k[0] * node.second_moment[0] + k[1] * node.second_moment[1] + k[2] * node.second_moment[2]) *
      k;
  sums.volume += (k.dot(s) + 3 * h * a) / 3;
  sums.horizontal += R_WB.topRows<2>() * (Qk + 4 * h * s) / 12;
  sums.depth -= (k.dot(Qk) + 8 * h * k.dot(s) + 12 * h * h * a) / 24;
  sums.surface += node.surface;
}

}  // namespace

ImmersedMesh::ImmersedMesh(const TriMesh& mesh_B)
    : mesh_B_(mesh_B),
      margin_(kMargin * mesh_B.vertices.colwise().norm().maxCoeff()),
      volume_(solid_properties(mesh_B).volume),
      order_(static_cast<std::size_t>(mesh_B.face_count())) {
  std::iota(order_.begin(), order_.end(), 0);
  build(0, static_cast<int>(order_.size()));
}

int ImmersedMesh::build(int first, int last) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Node node{.first = first, .last = last};
  node.second_moment.fill(Matrix3d::Zero());
  Eigen::AlignedBox3d box;
  for (int i = first; i < last; ++i)
    for (const int corner : mesh_B_.faces.col(order_[static_cast<std::size_t>(i)]))
      box.extend(mesh_B_.vertices.col(corner));
  node.middle = box.center();
  node.half = box.sizes() / 2;
  if (last - first <= kLeafFaces) {
    add_faces(node);
    nodes_[static_cast<std::size_t>(index)] = node;
    return index;
  }
  Eigen::Index axis;
  node.half.maxCoeff(&axis);
  const auto place = [&](int face) {
    const auto corners = mesh_B_.faces.col(face);
    return mesh_B_.vertices(axis, corners[0]) + mesh_B_.vertices(axis, corners[1]) +
           mesh_B_.vertices(axis, corners[2]);
  };
  const int middle = (first + last) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](int a, int b) { return std::pair(place(a), a) < std::pair(place(b), b); });
  const int left = build(first, middle);
  node.right = build(middle, last);
  for (const int child : {left, node.right}) {
    const Node& part = nodes_[static_cast<std::size_t>(child)];
    node.area += part.area;
    node.first_moment += part.first_moment;
    for (std::size_t m = 0; m < 3; ++m) node.second_moment[m] += part.second_moment[m];
    node.surface += part.surface;
  }
  nodes_[static_cast<std::size_t>(index)] = node;
  return index;
}

void ImmersedMesh::add_faces(Node& node) const {
  for (int i = node.first; i < node.last; ++i) {
    const Panel r = panel_of(mesh_B_, order_[static_cast<std::size_t>(i)]);
    const Vector3d a = area_vector(r);
    const Vector3d s = r[0] + r[1] + r[2];
    const Matrix3d Q = r[0] * r[0].transpose() + r[1] * r[1].transpose() + r[2] * r[2].transpose() +
                       s * s.transpose();
    node.area += a;
    node.first_moment += a * s.transpose();
    for (int m = 0; m < 3; ++m) node.second_moment[static_cast<std::size_t>(m)] += a[m] * Q;
    node.surface += a.norm();
  }
}

void ImmersedMesh::add_wet(int index, const Matrix3d& R_WB, double height, WetSums& sums) const {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  const auto k = R_WB.row(2);
  const double above = k.dot(node.middle) + height;
  const double reach = k.cwiseAbs().dot(node.half) + margin_;
  if (above - reach >= 0) return;
  if (above + reach < 0) return add_whole(node, R_WB, height, sums);
  if (node.right > 0) {
    add_wet(index + 1, R_WB, height, sums);
    add_wet(node.right, R_WB, height, sums);
    return;
  }
  for (int i = node.first; i < node.last; ++i) {
    Panel panel = panel_of(mesh_B_, order_[static_cast<std::size_t>(i)]);
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
  add_wet(0, R_WB, height, sums);
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

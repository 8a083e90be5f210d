#include "hydro/statics/immersed_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/parallel.h"

namespace hydro {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kLeafFaces = 8;      ///< The most faces of a leaf.
constexpr double kMargin = 1e-12;  ///< By which boxes are too large, over the body's radius.

/// The faces along a curve, and the vertices as they meet them: what is near is read at once.
TriMesh along_curve(const TriMesh& mesh) {
  TriMesh ordered{Eigen::Matrix3Xd(3, mesh.vertex_count()), Eigen::Matrix3Xi(3, mesh.face_count())};
  std::vector<int> place(static_cast<std::size_t>(mesh.vertex_count()), -1);
  int vertices = 0, faces = 0;
  for (const int face : faces_along_curve(mesh)) {
    for (int corner = 0; corner < 3; ++corner) {
      const int vertex = mesh.faces(corner, face);
      if (place[vertex] < 0) {
        place[vertex] = vertices++;
        ordered.vertices.col(place[vertex]) = mesh.vertices.col(vertex);
      }
      ordered.faces(corner, faces) = place[vertex];
    }
    ++faces;
  }
  ordered.vertices.conservativeResize(3, vertices);
  return ordered;
}

/// The moments over a face: those of its corners, for the mean of x y over a triangle is
/// (Σ x_i y_i + Σ x_i Σ y_i) / 12.
Eigen::Matrix<double, 10, 3> face_moments(const Panel& r, const Vector3d& area_vector) {
  const Vector3d sum = r[0] + r[1] + r[2];
  const Matrix3d square = (r[0] * r[0].transpose() + r[1] * r[1].transpose() +
                           r[2] * r[2].transpose() + sum * sum.transpose()) /
                          12;
  Eigen::Matrix<double, 10, 1> mean;
  mean << 1, sum / 3, square.diagonal(), square(0, 1), square(1, 2), square(2, 0);
  return mean * area_vector.transpose();
}

}  // namespace

ImmersedMesh::ImmersedMesh(const TriMesh& mesh_B)
    : mesh_B_(along_curve(mesh_B)),
      radius_(mesh_B_.vertices.colwise().norm().maxCoeff()),
      volume_(solid_properties(mesh_B_).volume) {
  const int faces = static_cast<int>(mesh_B_.face_count());
  nodes_.reserve(static_cast<std::size_t>(4 * faces / kLeafFaces + 1));
  divide(0, faces);
  std::vector<int> leaves;
  for (int i = 0; i < static_cast<int>(nodes_.size()); ++i)
    if (nodes_[i].next == i + 1) leaves.push_back(i);
  parallel_for(leaves.size(), [&](std::size_t i) { fill_leaf(nodes_[leaves[i]]); });
  for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; --i) {
    Node& node = nodes_[i];
    if (node.next == i + 1) continue;
    const Node &left = nodes_[i + 1], &right = nodes_[left.next];
    node.moments = left.moments + right.moments;
    node.area = left.area + right.area;
    node.box = left.box.merged(right.box);
  }
}

/// Lays out the nodes of a run of faces, which is halved down to leaves.
void ImmersedMesh::divide(int first, int last) {
  const std::size_t here = nodes_.size();
  nodes_.push_back({.first = first, .last = last});
  if (last - first > kLeafFaces) {
    const int middle = first + (last - first) / 2;
    divide(first, middle);
    divide(middle, last);
  }
  nodes_[here].next = static_cast<int>(nodes_.size());
}

void ImmersedMesh::fill_leaf(Node& leaf) const {
  for (int i = leaf.first; i < leaf.last; ++i) {
    const Panel panel = panel_of(mesh_B_, i);
    const Vector3d area = area_vector(mesh_B_, i);
    leaf.moments += face_moments(panel, area);
    leaf.area += area.norm();
    for (const Vector3d& r : panel) leaf.box.extend(r);
  }
  const Vector3d margin = Vector3d::Constant(kMargin * radius_);
  leaf.box.min() -= margin;
  leaf.box.max() += margin;
}

/// Adds (7) of a branch that is wholly wet.
void ImmersedMesh::add_whole(const Node& node, const Matrix3d& R_WB, double h,
                             WetSums& sums) const {
  const Vector3d k = R_WB.row(2).transpose();
  const Eigen::Matrix<double, 10, 1> m = node.moments * k;
  const double a = m[0];
  const Vector3d s = m.segment<3>(1);
  Matrix3d Q;
  Q << m[4], m[7], m[9], m[7], m[5], m[8], m[9], m[8], m[6];
  const Vector3d Qk = Q * k;
  sums.volume += k.dot(s) + h * a;
  sums.horizontal += R_WB.topRows<2>() * (Qk + h * s);
  sums.depth -= (k.dot(Qk) + 2 * h * k.dot(s) + h * h * a) / 2;
  sums.surface += node.area;
}

void ImmersedMesh::add_leaf(const Node& leaf, const Matrix3d& R_WB, double height,
                            WetSums& sums) const {
  for (int i = leaf.first; i < leaf.last; ++i) {
    Panel panel = panel_of(mesh_B_, i);
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
  const Vector3d k = R_WB.row(2);
  for (int i = 0; i < static_cast<int>(nodes_.size());) {
    const Node& node = nodes_[i];
    const double above = k.dot(node.box.center()) + height;
    const double reach = k.cwiseAbs().dot(node.box.sizes()) / 2;
    const bool dry = above - reach >= 0, wet = above + reach < 0, leaf = node.next == i + 1;
    if (wet) add_whole(node, R_WB, height, sums);
    if (!wet && !dry && leaf) add_leaf(node, R_WB, height, sums);
    i = wet || dry ? node.next : i + 1;
  }
  return hydrostatics_of(sums, height);
}

double ImmersedMesh::lowest_along(const Vector3d& up) const {
  double lowest = HUGE_VAL;
  for (int i = 0; i < static_cast<int>(nodes_.size());) {
    const Node& node = nodes_[i];
    const double least = up.dot(node.box.center()) - up.cwiseAbs().dot(node.box.sizes()) / 2;
    if (least < lowest && node.next == i + 1)
      for (int face = node.first; face < node.last; ++face)
        for (const int v : mesh_B_.faces.col(face))
          lowest = std::min(lowest, up.dot(mesh_B_.vertices.col(v)));
    i = least < lowest ? i + 1 : node.next;
  }
  return lowest;
}

double ImmersedMesh::lowest(const Matrix3d& R_WB) const { return lowest_along(R_WB.row(2)); }

FloatingMesh ImmersedMesh::afloat(const Matrix3d& R_WB, double volume,
                                  std::optional<double> guess) const {
  if (!(volume > 0 && volume < volume_))
    throw std::invalid_argument("found a displacement of " + std::to_string(volume) +
                                " m^3, expected more than 0 and less than the body's volume, " +
                                std::to_string(volume_) + " m^3");
  double wet = lowest_along(-R_WB.row(2));  // heights at which the body is all wet
  const double highest = -lowest(R_WB);     // and all dry
  double dry = highest;
  FloatingMesh found{.height = wet + (dry - wet) * (1 - volume / volume_)};
  if (guess && *guess > wet && *guess < dry) found.height = *guess;
  for (int i = 0; i < 200; ++i) {
    found.hydrostatics = at(R_WB, found.height);
    const double excess = found.hydrostatics.volume - volume;
    if (std::abs(excess) <= 1e-15 * volume) break;
    (excess > 0 ? wet : dry) = found.height;
    double next = found.height + excess / found.hydrostatics.waterplane.area;
    if (!(next > wet && next < dry)) next = (wet + dry) / 2;        // also for an area of 0
    if (next == found.height || next == wet || next == dry) break;  // neighbouring numbers
    found.height = next;
  }
  found.draught = highest - found.height;
  return found;
}

}  // namespace hydro

#include "hydro/loads/kernel/tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hydro/loads/point_rules.h"
#include "hydro/spatial.h"

namespace hydro::kernel {
namespace {

using Eigen::Vector3d;

Vector6d along_normal(const Vector3d& r, const Vector3d& n) {
  Vector6d j;
  j << n, r.cross(n);
  return j;
}

constexpr int kPoints = 6;
/// The factors of J at each of the points, and J there, laid out as a node's moments are.
using Factors = Eigen::Matrix<double, kMoments, kPoints>;
using Lanes = Eigen::Matrix<double, kPoints, kMostLanes, Eigen::RowMajor>;
using Moments = Eigen::Matrix<double, kMoments, kMostLanes, Eigen::RowMajor>;

void set_point(int point, const Vector3d& r, const Vector3d& n, double weight, Factors& factors,
               Lanes& lanes) {
  const Vector6d j = along_normal(r, n);
  lanes.row(point).setZero();
  lanes.row(point).head<6>() = j;
  lanes(point, kAreaLane) = 1;
  factors(kOne, point) = 1;
  factors.block<3, 1>(kPlace, point) = r;
  factors.block<3, 1>(kSquare, point) = r.cwiseProduct(r);
  factors.block<3, 1>(kSquare + 3, point) << r.x() * r.y(), r.y() * r.z(), r.z() * r.x();
  int k = kNormal;
  for (int b = 0; b < 6; ++b)
    for (int c = b; c < 6; ++c) factors(k++, point) = j[b] * j[c];
  factors.col(point) *= weight;
}

/// The integrands are cubic; the rule is of degree 4.
void add_face(const Face& face, Node& node) {
  using namespace six_points;
  Factors factors;
  Lanes lanes;
  for (int i = 0; i < 3; ++i) {
    const Vector3d offset = face.corner(i) - face.c;
    set_point(i, face.c + (1 - 3 * kInner) * offset, face.n, kInnerWeight * face.area, factors,
              lanes);
    set_point(3 + i, face.c + (1 - 3 * kOuter) * offset, face.n, kOuterWeight * face.area, factors,
              lanes);
  }
  Eigen::Map<Moments>(node.moment[0]) += factors.lazyProduct(lanes);
}

/// The bounds of a node while it is made, as lowest and highest values.
struct Bounds {
  Vector3d low = Vector3d::Constant(HUGE_VAL), high = Vector3d::Constant(-HUGE_VAL);
  Vector6d j_low = Vector6d::Constant(HUGE_VAL), j_high = Vector6d::Constant(-HUGE_VAL);

  void include(const Vector3d& r, const Vector6d& j) {
    low = low.cwiseMin(r);
    high = high.cwiseMax(r);
    j_low = j_low.cwiseMin(j);
    j_high = j_high.cwiseMax(j);
  }
  void include(const Node& node) {
    const Eigen::Map<const Vector3d> centre(node.centre), half(node.half);
    const Eigen::Map<const Vector6d> j(node.j_centre), j_half(node.j_half);
    include(centre - half, j - j_half);
    include(centre + half, j + j_half);
  }
};

/// The bounds are widened by some roundings, so that they hold for what the kernel computes.
void set_bounds(const Bounds& b, Node& node) {
  constexpr double kWiden = 1e-14;
  const double size = b.low.cwiseAbs().cwiseMax(b.high.cwiseAbs()).maxCoeff();
  const double j_size = b.j_low.cwiseAbs().cwiseMax(b.j_high.cwiseAbs()).maxCoeff();
  Eigen::Map<Vector3d>(node.centre) = (b.low + b.high) / 2;
  Eigen::Map<Vector3d>(node.half) = ((b.high - b.low) / 2).array() + kWiden * size;
  Eigen::Map<Vector6d>(node.j_centre) = (b.j_low + b.j_high) / 2;
  Eigen::Map<Vector6d>(node.j_half) = ((b.j_high - b.j_low) / 2).array() + kWiden * j_size;
}

void fill_leaf(const Leaf& leaf, Node& node) {
  Bounds bounds;
  for (int lane = 0; lane < kLeafFaces; ++lane) {
    const Face face = face_of(leaf, lane);
    add_face(face, node);
    for (int i = 0; i < 3; ++i)
      bounds.include(face.corner(i), along_normal(face.corner(i), face.n));
  }
  set_bounds(bounds, node);
}

void fill_branch(const Node& left, const Node& right, Node& node) {
  Bounds bounds;
  bounds.include(left);
  bounds.include(right);
  set_bounds(bounds, node);
  for (int k = 0; k < kMoments; ++k)
    for (int a = 0; a < kMostLanes; ++a) node.moment[k][a] = left.moment[k][a] + right.moment[k][a];
}

/// Halves as `make_panels` does.
void build(const Panels& panels, int first, int last, std::vector<Node>& nodes) {
  const std::size_t here = nodes.size();
  nodes.emplace_back();
  nodes[here].first = first;
  nodes[here].last = last;
  if (last - first == 1) {
    fill_leaf(panels.leaves[first], nodes[here]);
  } else {
    const int middle = first + (last - first + 1) / 2;
    build(panels, first, middle, nodes);
    const std::size_t right = nodes.size();
    build(panels, middle, last, nodes);
    fill_branch(nodes[here + 1], nodes[right], nodes[here]);
  }
  nodes[here].next = static_cast<int>(nodes.size());
}

}  // namespace

double volume_over_area(const Tree& tree) {
  const auto& moment = tree.nodes[0].moment;
  return moment[kPlace + 2][2] / moment[kOne][kAreaLane];
}

Tree make_tree(const Panels& panels) {
  Tree tree;
  const int leaves = static_cast<int>(panels.leaves.size());
  if (leaves == 0) return tree;
  tree.nodes.reserve(2 * panels.leaves.size());
  build(panels, 0, leaves, tree.nodes);
  // Halving ends at more than half of this, so there are fewer than kMostChunks.
  tree.chunk_leaves = std::max(16, (2 * leaves + kMostChunks - 1) / kMostChunks);
  return tree;
}

}  // namespace hydro::kernel

#include "hydro/loads/kernel/clusters.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro/loads/kernel/tree.h"
#include "hydro/parallel.h"

namespace hydro::kernel {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A hull of fewer leaves has no clusters: there a leaf is too large for the bound to be below a
/// tolerance of 1e-4, and to look costs up to a tenth more.
constexpr int kFewestLeaves = 256;

/// θ: the size that δ has over a branch at the edge of being taken, as a part of the velocity. A
/// product of k features then counts in the kernel as much as its term of equation (1).
constexpr double kTheta = 0.25;

/// What is left of the kernel when the rest is roundings, as a part of it.
constexpr double kLeastPivot = 1e-13;

constexpr int kFeatures = 9 + 9 + 3;

/// Points with areas that stand for a branch before some are chosen.
struct Points {
  Eigen::Matrix3Xd r, n;
  Eigen::VectorXd area;

  Points(Index count) : r(3, count), n(3, count), area(count) {}
  Index count() const { return area.size(); }
  Points first(Index count) const {
    Points some(count);
    some.r = r.leftCols(count);
    some.n = n.leftCols(count);
    some.area = area.head(count);
    return some;
  }
};

/// The points of the rule of degree 2 on each face.
Points points_of(const Leaf& leaf) {
  Points points(3 * kLeafFaces);
  Index count = 0;
  for (int lane = 0; lane < kLeafFaces; ++lane) {
    const Face face = face_of(leaf, lane);
    if (face.area == 0) continue;
    for (int i = 0; i < 3; ++i) {
      points.r.col(count) = 0.5 * (face.c + face.corner(i));
      points.n.col(count) = face.n;
      points.area[count++] = face.area / 3;
    }
  }
  return points.first(count);
}

Vector3d vector(const double (&from)[3]) { return Vector3d(from); }
Matrix3d across(const Vector3d& n) { return Matrix3d::Identity() - n * n.transpose(); }

Points points_of(const Cluster& left, const Cluster& right) {
  Points points(left.count + right.count);
  Index to = 0;
  for (const Cluster* from : {&left, &right}) {
    for (int i = 0; i < from->count; ++i, ++to) {
      for (int axis = 0; axis < 3; ++axis) {
        points.r(axis, to) = from->r[axis][i];
        points.n(axis, to) = from->n[axis][i];
      }
      points.area[to] = from->area[i];
    }
  }
  return points;
}

void set(double (&to)[3], const Vector3d& v) {
  for (int axis = 0; axis < 3; ++axis) to[axis] = v[axis];
}

/// Chooses the place and the normal that the features are seen from, and their scales.
void set_frame(const Points& points, Cluster& cluster) {
  const double area = points.area.sum();
  const Vector3d centre = points.r * points.area / area;
  const Matrix3d mean = points.n * points.area.asDiagonal() * points.n.transpose() / area;
  Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
  solver.compute(mean);
  const Vector3d normal = solver.eigenvectors().col(2);
  double tilt2 = 0, extent2 = 0;
  for (Index i = 0; i < points.count(); ++i) {
    tilt2 += points.area[i] * 2 * points.n.col(i).cross(normal).squaredNorm();
    extent2 += points.area[i] * (points.r.col(i) - centre).squaredNorm();
  }
  set(cluster.centre, centre);
  set(cluster.normal, normal);
  cluster.lever = centre.norm();
  // On a plane N − M is roundings, which are not to be made large.
  cluster.tilt = std::max(std::sqrt(tilt2 / area), 1e-6);
  cluster.extent = std::sqrt(extent2 / area);
}

/// (I − N) [x]×
Matrix3d turned(const Vector3d& n, const Vector3d& x) {
  Matrix3d skew;
  skew << 0, -x.z(), x.y(), x.z(), 0, -x.x(), -x.y(), x.x(), 0;
  return across(n) * skew;
}

Eigen::MatrixXd features_of(const Points& points, const Cluster& cluster) {
  Eigen::MatrixXd y(kFeatures, points.count());
  const Vector3d centre = vector(cluster.centre), m = vector(cluster.normal);
  const Matrix3d M = m * m.transpose();
  for (Index i = 0; i < points.count(); ++i) {
    const Vector3d n = points.n.col(i), x = (points.r.col(i) - centre) / cluster.extent;
    const Matrix3d tilt = (n * n.transpose() - M) / cluster.tilt;
    y.col(i) << tilt.reshaped(), turned(n, x).reshaped(), x;
  }
  return y;
}

/// Points by the pivots of the kernel's Cholesky factor: each is the one that those before it say
/// least of.
Eigen::VectorX<Index> pivots_of(const Eigen::MatrixXd& kernel) {
  const Index count = kernel.rows(), most = std::min<Index>(kMostPoints, count);
  Eigen::VectorXd left = kernel.diagonal();
  Eigen::MatrixXd factor(count, most);
  Eigen::VectorX<Index> pivots(most);
  Index known = 0;
  for (; known < most; ++known) {
    Index pivot = 0;
    const double square = left.maxCoeff(&pivot);
    if (square <= kLeastPivot * kernel(pivot, pivot)) break;
    factor.col(known) = kernel.col(pivot);
    factor.col(known).noalias() -=
        factor.leftCols(known) * factor.row(pivot).head(known).transpose();
    factor.col(known) /= std::sqrt(square);
    left -= factor.col(known).cwiseAbs2();
    pivots[known] = pivot;
  }
  return pivots.head(known);
}

/// Areas for some of the points, such that the sums of their features' products are next to those
/// of all in the kernel's norm: least squares, without the points whose area were negative.
Eigen::VectorXd chosen_areas(const Eigen::MatrixXd& products, const Eigen::VectorXd& area) {
  const Eigen::MatrixXd kernel = products.unaryExpr([](double p) {
    constexpr double s = kTheta * kTheta;
    double sum = 0;
    for (int k = kGaps; k > 0; --k) sum = s * p / (k * k) * (1 + sum);
    return 1 + sum;
  });
  const Eigen::VectorXd wanted = kernel * area;
  Eigen::VectorX<Index> points = pivots_of(kernel);
  Eigen::VectorXd best;
  for (Index kept = 0; kept < points.size();) {
    if (kept > 0) points.conservativeResize(kept);
    best = kernel(points, points).ldlt().solve(wanted(points));
    kept = 0;
    for (Index i = 0; i < points.size(); ++i)
      if (best[i] > 0) points[kept++] = points[i];
    if (kept == 0) {  // By roundings: what equal areas lose is measured as well.
      best.setOnes();
      break;
    }
  }
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(area.size());
  weight(points) = best * (area.sum() / best.sum());
  return weight;
}

/// What lies between two sums of the features' products, per area, with what roundings may hide.
void set_gaps(const Eigen::MatrixXd& products, const Eigen::VectorXd& change, double area,
              Cluster& cluster) {
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  Eigen::MatrixXd power = products;
  const Eigen::VectorXd size = change.cwiseAbs();
  for (double& gap : cluster.gap) {
    const double square = std::max(0.0, change.dot(power * change));
    gap = std::sqrt(square + kRounding * size.dot(power.cwiseAbs() * size)) / area;
    power.array() *= products.array();
  }
}

/// Adds a part's gaps as they are in the features of the whole, y = Q y_part + q.
void inherit(const Cluster& part, double share, Cluster& whole) {
  const Vector3d m = vector(part.normal), m_whole = vector(whole.normal);
  const Vector3d step = vector(part.centre) - vector(whole.centre);
  const double Q = std::max(part.tilt / whole.tilt, part.extent / whole.extent) +
                   step.norm() * part.tilt / whole.extent;
  const double q2 =
      2 * m.cross(m_whole).squaredNorm() / (whole.tilt * whole.tilt) +
      (turned(m, step).squaredNorm() + step.squaredNorm()) / (whole.extent * whole.extent);
  const double q = std::sqrt(q2);
  for (int k = 1; k <= kGaps; ++k) {
    double gap = 0, ways = 1;  // Σ_j (k over j) Q^j q^(k − j) g_j
    for (int j = k; j > 0; --j) {
      gap += ways * std::pow(Q, j) * std::pow(q, k - j) * part.gap[j - 1];
      ways *= static_cast<double>(j) / (k - j + 1);
    }
    whole.gap[k - 1] += share * gap;
  }
}

void set_spreads(const Panels& panels, const Node& node, Cluster& cluster) {
  const Vector3d centre = vector(cluster.centre), m = vector(cluster.normal);
  double area = 0, tilt6 = 0, extent6 = 0, face3 = 0;
  for (int leaf = node.first; leaf < node.last; ++leaf) {
    for (int lane = 0; lane < kLeafFaces; ++lane) {
      const Face face = face_of(panels.leaves[static_cast<std::size_t>(leaf)], lane);
      if (face.area == 0) continue;
      const double tilt2 = face.n.cross(m).squaredNorm();
      area += face.area;
      tilt6 += face.area * tilt2 * tilt2 * tilt2;
      cluster.most_tilt = std::max(cluster.most_tilt, tilt2);
      for (int i = 0; i < 3; ++i) {  // Means over convex functions: not more.
        const Vector3d corner = face.corner(i);
        const double extent2 = (corner - centre).squaredNorm();
        extent6 += face.area / 3 * extent2 * extent2 * extent2;
        face3 += face.area / 3 * std::pow((corner - face.c).norm(), 3);
        cluster.most_extent = std::max(cluster.most_extent, extent2);
      }
    }
  }
  double own_tilt6 = 0, own_extent6 = 0;
  for (int i = 0; i < cluster.count; ++i) {
    const Vector3d r(cluster.r[0][i], cluster.r[1][i], cluster.r[2][i]);
    const Vector3d n(cluster.n[0][i], cluster.n[1][i], cluster.n[2][i]);
    own_tilt6 += cluster.area[i] * std::pow(n.cross(m).squaredNorm(), 3);
    own_extent6 += cluster.area[i] * std::pow((r - centre).squaredNorm(), 3);
  }
  cluster.tilt6 = std::pow(std::max(tilt6, own_tilt6) / area, 1.0 / 6);
  cluster.extent6 = std::pow(std::max(extent6, own_extent6) / area, 1.0 / 6);
  cluster.most_tilt = std::sqrt(cluster.most_tilt);
  cluster.most_extent = std::sqrt(cluster.most_extent);
  cluster.face3 = face3 / area;
}

/// Chooses among the points and measures what that loses.
void choose(const Points& points, Cluster& cluster) {
  set_frame(points, cluster);
  const Eigen::MatrixXd y = features_of(points, cluster);
  const Eigen::MatrixXd products = y.transpose() * y;
  const Eigen::VectorXd weight = chosen_areas(products, points.area);
  for (Index i = 0; i < points.count(); ++i) {
    if (weight[i] <= 0) continue;
    const int to = cluster.count++;
    for (int axis = 0; axis < 3; ++axis) {
      cluster.r[axis][to] = points.r(axis, i);
      cluster.n[axis][to] = points.n(axis, i);
    }
    cluster.area[to] = weight[i];
  }
  set_gaps(products, weight - points.area, points.area.sum(), cluster);
}

void make_cluster(const Panels& panels, const std::vector<Node>& nodes, int node,
                  std::vector<Cluster>& all) {
  const Node& here = nodes[node];
  Cluster& cluster = all[node];
  if (here.leaf()) {
    choose(points_of(panels.leaves[here.first]), cluster);
  } else {
    const Cluster& left = all[node + 1];
    const Cluster& right = all[nodes[node + 1].next];
    const Points points = points_of(left, right);
    choose(points, cluster);
    const double share = points.area.head(left.count).sum() / points.area.sum();
    inherit(left, share, cluster);
    inherit(right, 1 - share, cluster);
  }
  set_spreads(panels, here, cluster);
}

/// The nodes by their distance from the root.
void list_levels(const std::vector<Node>& nodes, int node, std::size_t depth,
                 std::vector<std::vector<int>>& levels) {
  if (levels.size() <= depth) levels.emplace_back();
  levels[depth].push_back(node);
  if (nodes[node].leaf()) return;
  list_levels(nodes, node + 1, depth + 1, levels);
  list_levels(nodes, nodes[node + 1].next, depth + 1, levels);
}

}  // namespace

std::vector<Cluster> make_clusters(const Panels& panels, const std::vector<Node>& nodes) {
  if (static_cast<int>(panels.leaves.size()) < kFewestLeaves) return {};
  std::vector<Cluster> clusters(nodes.size());
  std::vector<std::vector<int>> levels;
  list_levels(nodes, 0, 0, levels);
  for (auto level = levels.rbegin(); level != levels.rend(); ++level)
    parallel_for(level->size(),
                 [&](std::size_t i) { make_cluster(panels, nodes, (*level)[i], clusters); });
  return clusters;
}

}  // namespace hydro::kernel

#include "hydro/mesh/face_tree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace hydro {
namespace {

constexpr int kLeafFaces = 4;
constexpr int kDepth = 64;  // halving 2^31 faces needs 31 levels

Eigen::AlignedBox3d face_box(const TriMesh& mesh, int face) {
  Eigen::AlignedBox3d box;
  for (const int v : mesh.faces.col(face)) box.extend(mesh.vertices.col(v));
  return box;
}

/// The lower 16 bits of n with two zeros between neighbours.
std::uint64_t spread(std::uint64_t n) {
  n = (n | n << 16) & 0x0000FF0000FF;
  n = (n | n << 8) & 0x00F00F00F00F;
  n = (n | n << 4) & 0x0C30C30C30C3;
  return (n | n << 2) & 0x249249249249;
}

/// Place of a point on the Z-order curve through a box of 2^16 cells a side.
std::uint64_t curve_place(const Eigen::Vector3d& p, const Eigen::AlignedBox3d& box, double cell) {
  std::uint64_t place = 0;
  for (int axis = 0; axis < 3; ++axis)
    place |= spread(static_cast<std::uint64_t>((p[axis] - box.min()[axis]) / cell)) << axis;
  return place;
}

/// True if the ray, its parameter >= 0, meets the box.
bool meets(const Eigen::AlignedBox3d& box, const Eigen::Array3d& start,
           const Eigen::Array3d& inverse_direction) {
  const Eigen::Array3d a = (box.min().array() - start) * inverse_direction;
  const Eigen::Array3d b = (box.max().array() - start) * inverse_direction;
  return a.max(b).minCoeff() >= std::max(a.min(b).maxCoeff(), 0.0);
}

/// True if the ray meets the triangle, after Möller and Trumbore, Fast, minimum storage
/// ray-triangle intersection (1997).
bool crosses(const Eigen::Vector3d& start, const Eigen::Vector3d& direction,
             const Eigen::Matrix3d& corners) {
  const Eigen::Vector3d e1 = corners.col(1) - corners.col(0);
  const Eigen::Vector3d e2 = corners.col(2) - corners.col(0);
  const Eigen::Vector3d p = direction.cross(e2);
  const double determinant = e1.dot(p);
  if (determinant == 0) return false;
  const Eigen::Vector3d to_start = start - corners.col(0);
  const Eigen::Vector3d q = to_start.cross(e1);
  const double u = to_start.dot(p) / determinant, v = direction.dot(q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && e2.dot(q) / determinant > 0;
}

/// Returns the part of the way from a to b, 0 … 1, at which a segment is nearest to a point.
double place_on_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                        const Eigen::Vector3d& b) {
  const double length2 = (b - a).squaredNorm();
  return length2 > 0 ? std::clamp((point - a).dot(b - a) / length2, 0.0, 1.0) : 0;
}

/// Squared distance of a point from a triangle [m^2].
double squared_distance(const Eigen::Vector3d& point, const Eigen::Matrix3d& corners) {
  const Eigen::Vector3d e1 = corners.col(1) - corners.col(0), e2 = corners.col(2) - corners.col(0);
  const Eigen::Vector3d normal = e1.cross(e2), arm = point - corners.col(0);
  const double area2 = normal.squaredNorm();
  if (area2 > 0) {
    const double u = arm.cross(e2).dot(normal) / area2, v = e1.cross(arm).dot(normal) / area2;
    const double off = arm.dot(normal);
    if (u >= 0 && v >= 0 && u + v <= 1) return off * off / area2;
  }
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d a = corners.col(i), b = corners.col((i + 1) % 3);
    const Eigen::Vector3d nearest = a + place_on_segment(point, a, b) * (b - a);
    least = std::min(least, (point - nearest).squaredNorm());
  }
  return least;
}

}  // namespace

std::vector<int> faces_along_curve(const TriMesh& mesh) {
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  const double extent = std::max(box.sizes().maxCoeff(), 1e-300);
  std::vector<std::pair<std::uint64_t, int>> places;
  places.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f)
    places.emplace_back(curve_place(face_box(mesh, f).center(), box, extent / 65535), f);
  std::sort(places.begin(), places.end());
  std::vector<int> order;
  order.reserve(places.size());
  for (const auto& [place, face] : places) order.push_back(face);
  return order;
}

FaceTree::FaceTree(const TriMesh& mesh) : mesh_(mesh), order_(faces_along_curve(mesh)) {
  boxes_.reserve(order_.size());
  for (const int face : order_) boxes_.push_back(face_box(mesh, face));
  nodes_.reserve(order_.size());
  if (!order_.empty()) build(0, static_cast<int>(order_.size()));
}

int FaceTree::build(int first, int last) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back({{}, first, last});
  Eigen::AlignedBox3d box;
  if (last - first <= kLeafFaces) {
    for (int i = first; i < last; ++i) box.extend(boxes_[i]);
    leaves_.push_back(index);
  } else {
    const int middle = first + (last - first) / 2;
    box = nodes_[build(first, middle)].box;
    const int right = build(middle, last);
    box.extend(nodes_[right].box);
    nodes_[index].right = right;
  }
  nodes_[index].box = box;
  return index;
}

bool FaceTree::visit_faces(const Node& leaf, const Node& other, int& budget,
                           const std::function<void(int, int)>& visit) const {
  for (int i = leaf.first; i < leaf.last; ++i) {
    for (int j = std::max(other.first, i + 1); j < other.last; ++j) {
      if (!boxes_[i].intersects(boxes_[j])) continue;
      if (budget-- == 0) return false;
      visit(order_[i], order_[j]);
    }
  }
  return true;
}

int FaceTree::most_pairs() const { return std::max(256, 50'000'000 / std::max(1, leaf_count())); }

void FaceTree::visit_pairs(int leaf, const std::function<void(int, int)>& visit) const {
  const Node& own = nodes_[leaves_[leaf]];
  int budget = most_pairs();
  int stack[kDepth] = {0}, size = 1;
  while (size > 0) {
    const int index = stack[--size];
    const Node& node = nodes_[index];
    if (node.last <= own.first || !node.box.intersects(own.box)) continue;
    if (node.right == 0) {
      if (!visit_faces(own, node, budget, visit)) return;
    } else {
      stack[size++] = node.right;
      stack[size++] = index + 1;
    }
  }
}

int FaceTree::nearest(const Eigen::Vector3d& point) const {
  int found = -1;
  double least = std::numeric_limits<double>::infinity();
  int stack[kDepth] = {0}, size = nodes_.empty() ? 0 : 1;
  while (size > 0) {
    const int index = stack[--size];
    const Node& node = nodes_[index];
    if (node.box.squaredExteriorDistance(point) >= least) continue;
    if (node.right != 0) {
      // The nearer child is visited first, so that most of the other is left out.
      const bool left_first = nodes_[index + 1].box.squaredExteriorDistance(point) <=
                              nodes_[node.right].box.squaredExteriorDistance(point);
      stack[size++] = left_first ? node.right : index + 1;
      stack[size++] = left_first ? index + 1 : node.right;
      continue;
    }
    for (int i = node.first; i < node.last; ++i) {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k) corners.col(k) = mesh_.vertices.col(mesh_.faces(k, order_[i]));
      const double distance = squared_distance(point, corners);
      if (distance >= least) continue;
      least = distance;
      found = order_[i];
    }
  }
  return found;
}

int FaceTree::crossings(const Eigen::Vector3d& start, const Eigen::Vector3d& direction,
                        const std::function<bool(int)>& counts) const {
  const Eigen::Array3d inverse = direction.array().inverse();
  int count = 0;
  int stack[kDepth] = {0}, size = nodes_.empty() ? 0 : 1;
  while (size > 0) {
    const int index = stack[--size];
    const Node& node = nodes_[index];
    if (!meets(node.box, start, inverse)) continue;
    if (node.right != 0) {
      stack[size++] = node.right;
      stack[size++] = index + 1;
      continue;
    }
    for (int i = node.first; i < node.last; ++i) {
      if (!counts(order_[i])) continue;
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k) corners.col(k) = mesh_.vertices.col(mesh_.faces(k, order_[i]));
      if (crosses(start, direction, corners)) ++count;
    }
  }
  return count;
}

bool FaceTree::contains(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d directions[] = {
      {0.5403, 0.2983, 0.7868}, {-0.3817, 0.8642, 0.3271}, {0.2219, -0.7193, -0.6583}};
  int inside = 0;
  for (const Eigen::Vector3d& direction : directions)
    inside += crossings(point, direction, [](int) { return true; }) % 2;
  return inside >= 2;
}

}  // namespace hydro

#include "hydro/mesh/mesh_overlap.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "hydro/parallel.h"

namespace hydro {
namespace {

constexpr double kMargin = 1e-6;  // relative to the diagonal of the mesh's box, see the header

/// A face with its unit normal.
struct Triangle {
  Eigen::Matrix3d corners;
  Eigen::Vector3d normal;
};

Triangle triangle(const TriMesh& mesh, int face) {
  Triangle t;
  for (int i = 0; i < 3; ++i) t.corners.col(i) = mesh.vertices.col(mesh.faces(i, face));
  t.normal = (t.corners.col(1) - t.corners.col(0)).cross(t.corners.col(2) - t.corners.col(0));
  t.normal.normalize();
  return t;
}

/// Returns the triangles of all faces, because each face occurs in about ten pairs.
std::vector<Triangle> triangles_of(const TriMesh& mesh) {
  std::vector<Triangle> triangles(static_cast<std::size_t>(mesh.face_count()));
  parallel_for(triangles.size(),
               [&](std::size_t f) { triangles[f] = triangle(mesh, static_cast<int>(f)); });
  return triangles;
}

/// Heights of b's corners over a's plane [m].
Eigen::Vector3d heights_over(const Triangle& a, const Triangle& b) {
  return (b.corners.colwise() - a.corners.col(0)).transpose() * a.normal;
}

/// Inward unit normal of side i of a triangle, in its plane.
Eigen::Vector3d inward(const Triangle& t, int i) {
  return t.normal.cross(t.corners.col((i + 1) % 3) - t.corners.col(i)).normalized();
}

/// True if p, in the triangle's plane, lies inside, farther than the margin from all sides.
bool well_inside(const Triangle& t, const Eigen::Vector3d& p, double margin) {
  for (int i = 0; i < 3; ++i)
    if (!(inward(t, i).dot(p - t.corners.col(i)) > margin)) return false;
  return true;
}

/// The point where a side of b passes through the inside of a.
std::optional<Eigen::Vector3d> piercing(const Triangle& a, const Triangle& b,
                                        const Eigen::Vector3d& heights, double margin) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double from = heights[i], to = heights[j];
    if (from * to >= 0 || std::min(std::abs(from), std::abs(to)) <= margin) continue;
    const Eigen::Vector3d p =
        b.corners.col(i) + from / (from - to) * (b.corners.col(j) - b.corners.col(i));
    if (well_inside(a, p, margin)) return p;
  }
  return std::nullopt;
}

/// True if a side of `a` separates the two coplanar triangles.
bool separates(const Triangle& a, const Triangle& b, double margin) {
  for (int i = 0; i < 3; ++i) {
    const Eigen::RowVector3d across = inward(a, i).transpose();
    if ((across * (b.corners.colwise() - a.corners.col(i))).maxCoeff() <= margin) return true;
  }
  return false;
}

/// A common point of two triangles that cut each other; none if they do not.
std::optional<Eigen::Vector3d> common_point(const Triangle& a, const Triangle& b, double margin) {
  const Eigen::Vector3d b_over_a = heights_over(a, b);
  const Eigen::Vector3d a_over_b = heights_over(b, a);
  const bool coplanar =
      b_over_a.cwiseAbs().maxCoeff() <= margin && a_over_b.cwiseAbs().maxCoeff() <= margin;
  if (coplanar) {
    if (a.normal.dot(b.normal) < 0 || separates(a, b, margin) || separates(b, a, margin))
      return std::nullopt;
    return b.corners.rowwise().mean();
  }
  const auto one_side = [&](const Eigen::Vector3d& h) {
    return h.minCoeff() >= -margin || h.maxCoeff() <= margin;
  };
  if (one_side(b_over_a) || one_side(a_over_b)) return std::nullopt;
  if (const auto p = piercing(a, b, b_over_a, margin)) return p;
  return piercing(b, a, a_over_b, margin);
}

/// True if the faces share three vertices: they are duplicates, not a cut.
bool same_corners(const TriMesh& mesh, int f, int g) {
  for (const int v : mesh.faces.col(f))
    if ((mesh.faces.col(g).array() != v).all()) return false;
  return true;
}

/// Overlaps found from one leaf of the tree.
struct Found {
  Eigen::Index count = 0;
  std::pair<int, int> first;  ///< The lowest pair of faces.
  Eigen::Vector3d point;

  void add(Eigen::Index n, const std::pair<int, int>& faces, const Eigen::Vector3d& at) {
    if (n > 0 && (count == 0 || faces < first)) {
      first = faces;
      point = at;
    }
    count += n;
  }
};

/// Calls `found(leaf, lower face, higher face, common point)` for each pair of faces that overlap
/// and for which `wanted` holds, on several threads; those of a leaf on one.
template <class Wanted, class Report>
void visit_overlaps(const TriMesh& mesh, const FaceTree& tree, Wanted wanted, Report found) {
  const double margin = kMargin * bounding_box(mesh).diagonal().norm();
  const std::vector<Triangle> triangles = triangles_of(mesh);
  parallel_for(static_cast<std::size_t>(tree.leaf_count()), [&](std::size_t index) {
    tree.visit_pairs(static_cast<int>(index), [&](int f, int g) {
      const auto faces = std::minmax(f, g);
      if (!wanted(f, g)) return;
      const auto p = common_point(triangles[static_cast<std::size_t>(faces.first)],
                                  triangles[static_cast<std::size_t>(faces.second)], margin);
      if (p && !same_corners(mesh, f, g)) found(index, faces, *p);
    });
  });
}

}  // namespace

Overlaps find_overlaps(const TriMesh& mesh, const FaceTree& tree) {
  std::vector<Found> of_leaf(static_cast<std::size_t>(tree.leaf_count()));
  visit_overlaps(
      mesh, tree, [](int, int) { return true; },
      [&](std::size_t leaf, const std::pair<int, int>& faces, const Eigen::Vector3d& p) {
        of_leaf[leaf].add(1, faces, p);
      });
  Found all;
  for (const Found& found : of_leaf) all.add(found.count, found.first, found.point);
  if (all.count == 0) return {};
  return {.count = all.count, .first = all.point};
}

std::vector<std::pair<int, int>> overlapping_parts(const TriMesh& mesh, const FaceTree& tree,
                                                   const std::vector<int>& part_of_face) {
  std::vector<std::vector<std::pair<int, int>>> of_leaf(
      static_cast<std::size_t>(tree.leaf_count()));
  visit_overlaps(
      mesh, tree,
      [&](int f, int g) {
        return std::min(part_of_face[f], part_of_face[g]) >= 0 &&
               part_of_face[f] != part_of_face[g];
      },
      [&](std::size_t leaf, const std::pair<int, int>& faces, const Eigen::Vector3d&) {
        of_leaf[leaf].push_back(std::minmax(part_of_face[faces.first], part_of_face[faces.second]));
      });
  std::vector<std::pair<int, int>> pairs;
  for (const auto& found : of_leaf) pairs.insert(pairs.end(), found.begin(), found.end());
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace hydro

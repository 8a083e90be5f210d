#include "hydro/mesh/mesh_union.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "hydro/mesh/convex_polygon.h"
#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mesh_overlap.h"
#include "hydro/mesh/side_splitter.h"
#include "hydro/mesh/weld.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Distance up to which surfaces touch, relative to the size.
constexpr double kTouching = 1e-6;

double diagonal_of(const TriMesh& mesh) { return bounding_box(mesh).diagonal().norm(); }

Polygon corners(const TriMesh& mesh, int face) {
  Polygon triangle;
  for (const int v : mesh.faces.col(face)) triangle.emplace_back(mesh.vertices.col(v));
  return triangle;
}

/// True if the inside of `a`, just below the middle of one of its faces, lies in the tree's mesh.
bool reaches_into(const TriMesh& a, const FaceTree& tree, const Eigen::AlignedBox3d& box,
                  double below) {
  for (int f = 0; f < a.face_count(); ++f) {
    const Polygon t = corners(a, f);
    const Vector3d p = (t[0] + t[1] + t[2]) / 3 - below * area_vector(a, f).normalized();
    if (box.contains(p) && tree.contains(p)) return true;
  }
  return false;
}

/// Extends the box by the vertices of `a` that lie in or on the tree's mesh.
void add_vertices(const TriMesh& a, const FaceTree& tree, const Eigen::AlignedBox3d& around,
                  double margin, Eigen::AlignedBox3d& box) {
  Eigen::AlignedBox3d near = around;
  near.min().array() -= margin;
  near.max().array() += margin;
  for (const auto& v : a.vertices.colwise()) {
    const Vector3d p = v;
    // A vertex on the surface counts, too: it is tried a little nearer to the middle.
    const Vector3d inward = (around.center() - p).normalized();
    if (near.contains(p) && (tree.contains(p) || tree.contains(p + 10 * margin * inward)))
      box.extend(p);
  }
}

/// Extends the box by the points where sides of `b` pass through the triangle `a`.
void add_piercings(const Polygon& a, const Polygon& b, Eigen::AlignedBox3d& box) {
  const Vector3d normal = (a[1] - a[0]).cross(a[2] - a[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d &from = b[i], &to = b[(i + 1) % 3];
    const double below = normal.dot(from - a[0]), above = normal.dot(to - a[0]);
    if (below * above >= 0) continue;
    const Vector3d p = from + below / (below - above) * (to - from);
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k)
      inside = inside && (a[(k + 1) % 3] - a[k]).cross(p - a[k]).dot(normal) >= 0;
    if (inside) box.extend(p);
  }
}

/// The faces of other parts that touch each face of a mesh with the opposite normal.
using Contacts = std::vector<std::vector<int>>;

bool touch(const Polygon& a, const Polygon& b, double margin) {
  const Vector3d n = (a[1] - a[0]).cross(a[2] - a[0]).normalized();
  const Vector3d m = (b[1] - b[0]).cross(b[2] - b[0]).normalized();
  if (n.dot(m) > -0.999) return false;
  for (const Vector3d& p : b)
    if (std::abs(n.dot(p - a[0])) > margin) return false;
  for (const Vector3d& p : a)
    if (std::abs(m.dot(p - b[0])) > margin) return false;
  Polygon common = a;
  const Polygon turned = {b[0], b[2], b[1]};
  for (std::size_t side = 0; side < 3 && !common.empty(); ++side)
    common = kept_part(common, from_side(common, turned, side, n, margin), 1);
  return has_area(common, margin);
}

Contacts contacts_between(const TriMesh& mesh, const std::vector<int>& part_of_face,
                          double margin) {
  Contacts contacts(part_of_face.size());
  const FaceTree tree(mesh);
  for (int leaf = 0; leaf < tree.leaf_count(); ++leaf)
    tree.visit_pairs(leaf, [&](int f, int g) {
      if (part_of_face[f] == part_of_face[g]) return;
      if (!touch(corners(mesh, f), corners(mesh, g), margin)) return;
      contacts[f].push_back(g);
      contacts[g].push_back(f);
    });
  return contacts;
}

/// A mesh of triangles that repeat their vertices.
class Soup {
 public:
  void add(const Polygon& polygon) {
    for (std::size_t i = 2; i < polygon.size(); ++i)
      for (const std::size_t corner : {std::size_t{0}, i - 1, i})
        points_.push_back(polygon[corner]);
  }
  TriMesh mesh() const {
    const auto count = static_cast<Eigen::Index>(points_.size());
    TriMesh mesh{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xi(3, count / 3)};
    for (Eigen::Index i = 0; i < count; ++i) {
      mesh.vertices.col(i) = points_[static_cast<std::size_t>(i)];
      mesh.faces(i % 3, i / 3) = static_cast<int>(i);
    }
    return mesh;
  }

 private:
  Polygon points_;
};

std::vector<int> vertices_in(const TriMesh& mesh, const Eigen::AlignedBox3d& box) {
  std::vector<int> found;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (box.contains(Vector3d(mesh.vertices.col(v)))) found.push_back(v);
  return found;
}

/// The surface of a part in a plane, if it is convex.
struct PlaneOfPart {
  int part;
  Vector3d normal;  ///< Normal of the faces that touch the surface.
  double height;    ///< Height of the plane along the normal [m].
  Polygon hull;     ///< Counter-clockwise about the normal; empty if the surface is not convex.
};
using Planes = std::vector<PlaneOfPart>;

const Polygon& convex_surface(const TriMesh& mesh, const std::vector<int>& part_of_face, int part,
                              const Vector3d& normal, double height, double margin,
                              Planes& planes) {
  for (const PlaneOfPart& known : planes)
    if (known.part == part && std::abs(known.height - height) <= margin &&
        known.normal.dot(normal) > 1 - 1e-12)
      return known.hull;
  Polygon points;
  double area = 0;
  const Eigen::VectorXd heights = (normal.transpose() * mesh.vertices).transpose();
  for (int g = 0; g < mesh.face_count(); ++g) {
    if (part_of_face[g] != part) continue;
    const Eigen::Vector3i face = mesh.faces.col(g);
    const Vector3d off(heights[face[0]], heights[face[1]], heights[face[2]]);
    if ((off.array() - height).abs().maxCoeff() > margin) continue;
    const double facing = -area_vector(mesh, g).dot(normal);
    if (facing <= 0) continue;
    for (const int v : face) points.emplace_back(mesh.vertices.col(v));
    area += facing;
  }
  Polygon hull = convex_hull(std::move(points), normal, margin);
  if (std::abs(area_of(hull) - area) > 1e-9 * area) hull.clear();
  planes.push_back({part, normal, height, std::move(hull)});
  return planes.back().hull;
}

/// Returns convex polygons that together are the surface of the other parts where they touch a
/// face. A surface that is convex is one, which leaves fewer and better triangles around it.
std::vector<Polygon> holes(const TriMesh& mesh, int face, const std::vector<int>& touching,
                           const std::vector<int>& part_of_face, double margin, Planes& planes) {
  const Vector3d normal = area_vector(mesh, face).normalized();
  const double height = normal.dot(mesh.vertices.col(mesh.faces(0, face)));
  std::set<int> parts;
  for (const int g : touching) parts.insert(part_of_face[g]);
  std::vector<Polygon> all;
  for (const int part : parts) {
    const Polygon& hull = convex_surface(mesh, part_of_face, part, normal, height, margin, planes);
    if (!hull.empty()) {
      all.push_back(hull);
      continue;
    }
    for (const int g : touching)
      if (part_of_face[g] == part) {
        const Polygon t = corners(mesh, g);
        all.push_back({t[0], t[2], t[1]});
      }
  }
  return all;
}

}  // namespace

int CommonPart::axis() const {
  Eigen::Index least = 0;
  box.sizes().minCoeff(&least);
  return static_cast<int>(least);
}

std::optional<CommonPart> common_part(const TriMesh& a, const TriMesh& b) {
  const TriMesh both = side_by_side({a, b});
  const double margin = kTouching * diagonal_of(both);
  const Eigen::AlignedBox3d shared = bounding_box(a).intersection(bounding_box(b));
  if (shared.isEmpty() || shared.sizes().minCoeff() <= margin) return std::nullopt;
  const FaceTree tree_a(a), tree_b(b), tree(both);
  if (find_overlaps(both, tree).count == 0 && !reaches_into(a, tree_b, shared, 10 * margin) &&
      !reaches_into(b, tree_a, shared, 10 * margin))
    return std::nullopt;
  CommonPart part;
  add_vertices(a, tree_b, shared, margin, part.box);
  add_vertices(b, tree_a, shared, margin, part.box);
  const auto faces_of_a = static_cast<int>(a.face_count());
  for (int leaf = 0; leaf < tree.leaf_count(); ++leaf)
    tree.visit_pairs(leaf, [&](int f, int g) {
      if ((f < faces_of_a) == (g < faces_of_a)) return;
      add_piercings(corners(both, f), corners(both, g), part.box);
      add_piercings(corners(both, g), corners(both, f), part.box);
    });
  if (part.box.isEmpty()) part.box = shared;
  return part;
}

TriMesh side_by_side(const std::vector<TriMesh>& parts) {
  Eigen::Index vertices = 0, faces = 0;
  for (const TriMesh& part : parts) {
    vertices += part.vertex_count();
    faces += part.face_count();
  }
  TriMesh all{Eigen::Matrix3Xd(3, vertices), Eigen::Matrix3Xi(3, faces)};
  vertices = faces = 0;
  for (const TriMesh& part : parts) {
    all.vertices.middleCols(vertices, part.vertex_count()) = part.vertices;
    all.faces.middleCols(faces, part.face_count()) =
        part.faces.array() + static_cast<int>(vertices);
    vertices += part.vertex_count();
    faces += part.face_count();
  }
  return all;
}

TriMesh joined(const std::vector<TriMesh>& parts) {
  TriMesh all = side_by_side(parts);
  std::vector<int> part_of_face;
  for (std::size_t i = 0; i < parts.size(); ++i)
    part_of_face.insert(part_of_face.end(), static_cast<std::size_t>(parts[i].face_count()),
                        static_cast<int>(i));
  const double margin = kTouching * diagonal_of(all);
  const Contacts contacts = contacts_between(all, part_of_face, margin);
  Soup soup;
  Eigen::AlignedBox3d touching;
  Planes planes;
  for (int f = 0; f < all.face_count(); ++f) {
    const Vector3d normal = area_vector(all, f).normalized();
    std::vector<Polygon> rest = {corners(all, f)};
    if (!contacts[f].empty())
      for (const Polygon& hole : holes(all, f, contacts[f], part_of_face, margin, planes))
        rest = without(rest, hole, normal, margin);
    for (const Polygon& polygon : rest) soup.add(polygon);
    if (contacts[f].empty()) continue;
    for (const Vector3d& p : corners(all, f)) touching.extend(p);
  }
  if (touching.isEmpty()) return all;
  touching.min().array() -= 2 * margin;
  touching.max().array() += 2 * margin;
  const TriMesh cut = welded(soup.mesh(), 2 * margin);
  return welded(split_sides(cut, vertices_in(cut, touching), 3 * margin, 3 * margin), 0);
}

}  // namespace hydro

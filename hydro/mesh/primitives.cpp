#include "hydro/mesh/primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace hydro {
namespace {

void require_size(double size, const char* name) {
  if (!(size > 0) || !std::isfinite(size))
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(size) +
                                ", expected a positive length [m]");
}

void require_count(int count, int least, const char* name) {
  if (count < least)
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(count) +
                                ", expected at least " + std::to_string(least));
}

/// `count` is a double so that a product of large counts cannot overflow.
void require_triangles(double count) {
  if (count > kMostTriangles)
    throw std::invalid_argument("the mesh would have " + std::to_string(count) +
                                " triangles, expected at most " + std::to_string(kMostTriangles));
}

/// Fills the columns of a face matrix one after the other.
class FaceWriter {
 public:
  explicit FaceWriter(Eigen::Matrix3Xi& faces) : faces_(faces) {}
  void add(int a, int b, int c) { faces_.col(next_++) << a, b, c; }
  /// The quadrilateral a, b, c, d, counter-clockwise, cut from a to c or else from b to d.
  void add_quad(int a, int b, int c, int d, bool cut_ac) {
    add(a, b, cut_ac ? c : d);
    add(cut_ac ? a : b, c, d);
  }

 private:
  Eigen::Matrix3Xi& faces_;
  Eigen::Index next_ = 0;
};

/// Numbers the points of the surface of the lattice {0 … n}³: the square k = 0, the rings of 4n
/// points between, the square k = n.
class BoxLattice {
 public:
  explicit BoxLattice(int n) : n_(n) {}
  int point_count() const { return 6 * n_ * n_ + 2; }
  int operator()(const std::array<int, 3>& p) const {
    const int square = (n_ + 1) * (n_ + 1);
    if (p[2] == 0) return in_square(p);
    if (p[2] == n_) return square + 4 * n_ * (n_ - 1) + in_square(p);
    return square + 4 * n_ * (p[2] - 1) + on_ring(p);
  }

 private:
  int in_square(const std::array<int, 3>& p) const { return p[1] * (n_ + 1) + p[0]; }
  int on_ring(const std::array<int, 3>& p) const {
    if (p[1] == 0) return p[0];
    if (p[0] == n_) return n_ + p[1];
    return p[1] == n_ ? 3 * n_ - p[0] : 4 * n_ - p[1];
  }
  int n_;
};

/// Vertex positions: (2i − n)/(2n) of the size, so that opposite points are exact opposites.
Eigen::Matrix3Xd box_vertices(const Eigen::Vector3d& size, int n, const BoxLattice& number) {
  Eigen::Matrix3Xd vertices(3, number.point_count());
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; i += (j % n && k % n) ? n : 1)
        vertices.col(number({i, j, k})) =
            size.cwiseProduct(Eigen::Vector3d(2 * i - n, 2 * j - n, 2 * k - n)) / (2.0 * n);
  return vertices;
}

/// Adds the side of the box where lattice coordinate `axis` is 0 or n. Its diagonals point to its
/// middle; where a middle cell has no such direction, the choices on all sides together have the
/// symmetry of a tetrahedron.
void add_box_side(FaceWriter& faces, const BoxLattice& number, int n, int axis, bool far) {
  const auto at = [&](int i, int j) {
    std::array<int, 3> p;
    p[axis] = far ? n : 0;
    p[(axis + 1) % 3] = i;
    p[(axis + 2) % 3] = j;
    return number(p);
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const bool rising = (2 * i + 1 < n) == (2 * j + 1 < n + (far ? 1 : 0));
      if (far)
        faces.add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), rising);
      else
        faces.add_quad(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j), rising);
    }
  }
}

/// The point at angle 2π·j/n of the unit circle, exactly symmetric about both axes.
Eigen::Vector2d circle_point(int j, int n) {
  if (2 * j > n) return circle_point(n - j, n).cwiseProduct(Eigen::Vector2d(1, -1));
  if (4 * j == n) return {0, 1};
  if (4 * j > n) {
    const double angle = M_PI * (n - 2 * j) / n;
    return {-std::cos(angle), std::sin(angle)};
  }
  const double angle = M_PI * (2 * j) / n;
  return {std::cos(angle), std::sin(angle)};
}

/// A ring of a surface of revolution about z.
struct RingOfVertices {
  double rho;  ///< Distance from the axis [m].
  double z;    ///< [m]
};

/// Faces of a surface of revolution with `rings` rings between the poles. Vertices are numbered
/// from the top pole over the rings to the bottom pole.
Eigen::Matrix3Xi revolution_faces(int rings, int slices) {
  Eigen::Matrix3Xi faces(3, 2 * slices * rings);
  FaceWriter writer(faces);
  const int bottom = rings * slices + 1;
  const auto at = [&](int k, int j) { return 1 + k * slices + j % slices; };
  for (int j = 0; j < slices; ++j) {
    writer.add(0, at(0, j), at(0, j + 1));
    for (int k = 0; k + 1 < rings; ++k)
      writer.add_quad(at(k, j), at(k + 1, j), at(k + 1, j + 1), at(k, j + 1), (j + k) % 2 == 0);
    writer.add(bottom, at(rings - 1, j + 1), at(rings - 1, j));
  }
  return faces;
}

/// The closed surface of revolution through `rings`, from the top down, with poles at z = ±z_pole.
TriMesh revolve(const std::vector<RingOfVertices>& rings, double z_pole, int slices) {
  TriMesh mesh;
  mesh.vertices.resize(3, static_cast<Eigen::Index>(rings.size()) * slices + 2);
  Eigen::Index next = 0;
  mesh.vertices.col(next++) << 0, 0, z_pole;
  for (const RingOfVertices& ring : rings)
    for (int j = 0; j < slices; ++j)
      mesh.vertices.col(next++) << ring.rho * circle_point(j, slices), ring.z;
  mesh.vertices.col(next) << 0, 0, -z_pole;
  mesh.faces = revolution_faces(static_cast<int>(rings.size()), slices);
  return mesh;
}

/// Twelve vertices (0, ±1, ±φ) and their cyclic permutations; the faces are the triples whose
/// vertices are all neighbours, at distance 2.
TriMesh icosahedron() {
  TriMesh mesh{Eigen::Matrix3Xd(3, 12), Eigen::Matrix3Xi(3, 20)};
  const double golden = (1 + std::sqrt(5.0)) / 2;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d p(0, i & 1 ? -1 : 1, i & 2 ? -golden : golden);
    for (int axis = 0; axis < 3; ++axis) mesh.vertices(axis, i) = p[(axis + i / 4) % 3];
  }
  const auto at = [&](int i) { return mesh.vertices.col(i); };
  const auto neighbours = [&](int i, int j) { return (at(i) - at(j)).squaredNorm() < 5; };
  FaceWriter writer(mesh.faces);
  for (int i = 0; i < 12; ++i)
    for (int j = i + 1; j < 12; ++j)
      for (int k = j + 1; k < 12; ++k)
        if (neighbours(i, j) && neighbours(j, k) && neighbours(k, i)) {
          const bool outward = at(i).dot(at(j).cross(at(k))) > 0;
          writer.add(i, outward ? j : k, outward ? k : j);
        }
  return mesh;
}

/// Each triangle split in four at the middles of its edges.
TriMesh subdivided(const TriMesh& mesh) {
  const Eigen::Index edges = mesh.face_count() * 3 / 2;
  TriMesh fine{Eigen::Matrix3Xd(3, mesh.vertex_count() + edges),
               Eigen::Matrix3Xi(3, 4 * mesh.face_count())};
  fine.vertices.leftCols(mesh.vertex_count()) = mesh.vertices;
  int next = static_cast<int>(mesh.vertex_count());
  std::unordered_map<std::int64_t, int> middles;
  middles.reserve(static_cast<std::size_t>(edges));
  const auto middle = [&](int a, int b) {
    const std::int64_t key = (std::int64_t{std::min(a, b)} << 32) + std::max(a, b);
    const auto [place, added] = middles.try_emplace(key, next);
    if (added) fine.vertices.col(next++) = (mesh.vertices.col(a) + mesh.vertices.col(b)) / 2;
    return place->second;
  };
  FaceWriter writer(fine.faces);
  for (const auto& face : mesh.faces.colwise()) {
    const int a = face[0], b = face[1], c = face[2];
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    writer.add(a, ab, ca);
    writer.add(b, bc, ab);
    writer.add(c, ca, bc);
    writer.add(ab, bc, ca);
  }
  return fine;
}

}  // namespace

TriMesh make_box(const Eigen::Vector3d& size, int divisions) {
  for (const double edge : size) require_size(edge, "size");
  require_count(divisions, 1, "divisions");
  require_triangles(12.0 * divisions * divisions);
  const BoxLattice number(divisions);
  TriMesh mesh{box_vertices(size, divisions, number),
               Eigen::Matrix3Xi(3, 12 * divisions * divisions)};
  FaceWriter faces(mesh.faces);
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true}) add_box_side(faces, number, divisions, axis, far);
  return mesh;
}

TriMesh make_sphere(double radius, int slices, int stacks) {
  require_size(radius, "radius");
  return make_ellipsoid(Eigen::Vector3d::Constant(radius), slices, stacks);
}

TriMesh make_ellipsoid(const Eigen::Vector3d& semi_axes, int slices, int stacks) {
  for (const double semi_axis : semi_axes) require_size(semi_axis, "semi_axes");
  require_count(slices, 3, "slices");
  require_count(stacks, 2, "stacks");
  require_triangles(2.0 * slices * (stacks - 1.0));
  std::vector<RingOfVertices> rings;
  for (int k = 1; k < stacks; ++k) {
    // Latitude is measured from the equator, so that the two halves have the same digits.
    const double latitude = M_PI * (stacks - 2 * k) / (2.0 * stacks);
    rings.push_back({std::cos(latitude), std::sin(latitude)});
  }
  TriMesh mesh = revolve(rings, 1, slices);
  mesh.vertices = semi_axes.asDiagonal() * mesh.vertices;
  return mesh;
}

TriMesh make_icosphere(double radius, int subdivisions) {
  require_size(radius, "radius");
  require_count(subdivisions, 0, "subdivisions");
  if (subdivisions > 9)
    throw std::invalid_argument("subdivisions is " + std::to_string(subdivisions) +
                                ", expected at most 9");
  TriMesh mesh = icosahedron();
  mesh.vertices.colwise().normalize();
  for (int level = 0; level < subdivisions; ++level) {
    mesh = subdivided(mesh);
    mesh.vertices.colwise().normalize();
  }
  mesh.vertices *= radius;
  return mesh;
}

int cylinder_cap_rings(double radius, double height, int slices, int stacks) {
  const double panel = std::max(2 * M_PI * radius / slices, height / stacks);
  return std::max(1, static_cast<int>(std::lround(radius / panel)));
}

TriMesh make_cylinder(double radius, double height, int slices, int stacks) {
  require_size(radius, "radius");
  require_size(height, "height");
  require_count(slices, 3, "slices");
  require_count(stacks, 1, "stacks");
  const int cap = cylinder_cap_rings(radius, height, slices, stacks);
  require_triangles(2.0 * slices * (stacks + 2.0 * cap - 1));
  std::vector<RingOfVertices> rings;
  for (int k = 1; k < cap; ++k) rings.push_back({radius * k / cap, height / 2});
  for (int k = 0; k <= stacks; ++k)
    rings.push_back({radius, height * (stacks - 2.0 * k) / (2.0 * stacks)});
  for (int k = cap - 1; k > 0; --k) rings.push_back({radius * k / cap, -height / 2});
  return revolve(rings, height / 2, slices);
}

}  // namespace hydro

#include "app/render/shaded_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "hydro/mesh/edge_table.h"

namespace render {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using hydro::TriMesh;

/// Faces around each vertex as consecutive lists.
struct FacesOfVertices {
  std::vector<Index> first;  // V + 1
  std::vector<Index> faces;
};

FacesOfVertices faces_of_vertices(const TriMesh& mesh) {
  FacesOfVertices around;
  around.first.assign(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
  for (const int v : mesh.faces.reshaped()) ++around.first[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 1; v < around.first.size(); ++v) around.first[v] += around.first[v - 1];
  around.faces.resize(static_cast<std::size_t>(mesh.faces.size()));
  std::vector<Index> next = around.first;
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (const int v : mesh.faces.col(f))
      around.faces[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = f;
  return around;
}

/// Returns the unit normal of a face's corner from those faces around its vertex that lie within
/// the crease angle.
Vector3d corner_normal(const Eigen::Matrix3Xd& areas, const Index* begin, const Index* end,
                       Index face) {
  const Vector3d own = areas.col(face).normalized();
  Vector3d sum = Vector3d::Zero();
  for (const Index* f = begin; f != end; ++f) {
    const Vector3d a = areas.col(*f);
    if (a.dot(own) >= std::cos(kCreaseAngle) * a.norm()) sum += a;
  }
  // A face without area covers no pixel, so that any unit vector will do.
  return sum.norm() > 0 ? Vector3d(sum.normalized()) : Vector3d(Vector3d::UnitZ());
}

/// Collects the vertices of a shaded mesh, one for each normal at a vertex of the mesh.
class SkinVertices {
 public:
  explicit SkinVertices(Index mesh_vertices) : sides_(static_cast<std::size_t>(mesh_vertices)) {}

  int add(int mesh_vertex, const Vector3d& normal) {
    std::vector<int>& sides = sides_[static_cast<std::size_t>(mesh_vertex)];
    for (const int side : sides)
      if (normals_[static_cast<std::size_t>(side)].dot(normal) > 1 - 1e-9) return side;
    const int added = static_cast<int>(origins_.size());
    sides.push_back(added);
    origins_.push_back(mesh_vertex);
    normals_.push_back(normal);
    return added;
  }

  void store(const TriMesh& mesh, ShadedMesh& skin) const {
    const auto count = static_cast<Index>(origins_.size());
    skin.vertices.resize(3, count);
    skin.normals.resize(3, count);
    for (Index i = 0; i < count; ++i) {
      skin.vertices.col(i) = mesh.vertices.col(origins_[static_cast<std::size_t>(i)]);
      skin.normals.col(i) = normals_[static_cast<std::size_t>(i)];
    }
  }

 private:
  std::vector<std::vector<int>> sides_;
  std::vector<int> origins_;
  std::vector<Vector3d> normals_;
};

/// Splits edges once. It stores their midpoints, so that two faces share that of their edge.
class EdgeSplitter {
 public:
  EdgeSplitter(const TriMesh& mesh, double longest) : longest_(longest) {
    for (const auto v : mesh.vertices.colwise()) vertices_.emplace_back(v);
    for (const auto f : mesh.faces.colwise()) split(f);
  }

  TriMesh result() const {
    TriMesh mesh;
    mesh.vertices.resize(3, static_cast<Index>(vertices_.size()));
    mesh.faces.resize(3, static_cast<Index>(faces_.size()));
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      mesh.vertices.col(static_cast<Index>(i)) = vertices_[i];
    for (std::size_t i = 0; i < faces_.size(); ++i)
      mesh.faces.col(static_cast<Index>(i)) = faces_[i];
    return mesh;
  }

 private:
  /// Returns the vertex in the middle of an edge, or -1 if the edge is short enough.
  int middle(int a, int b) {
    const Vector3d& p = vertices_[static_cast<std::size_t>(a)];
    const Vector3d& q = vertices_[static_cast<std::size_t>(b)];
    if ((p - q).norm() <= longest_) return -1;
    const auto [entry, added] =
        middles_.try_emplace(std::minmax(a, b), static_cast<int>(vertices_.size()));
    if (added) vertices_.push_back(0.5 * (p + q));
    return entry->second;
  }

  /// Adds one to four triangles. Corners are rotated so that the number of split edges determines
  /// the case.
  void split(const Eigen::Vector3i& face) {
    std::array<int, 3> v = {face[0], face[1], face[2]};
    std::array<int, 3> m = {middle(v[0], v[1]), middle(v[1], v[2]), middle(v[2], v[0])};
    const auto count = std::count_if(m.begin(), m.end(), [](int i) { return i >= 0; });
    // The rotation ends when a single split edge is first or a single whole edge is last.
    while ((count == 1 && m[0] < 0) || (count == 2 && m[2] >= 0)) {
      std::rotate(v.begin(), v.begin() + 1, v.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    }
    if (count == 0) add({{v[0], v[1], v[2]}});
    if (count == 1) add({{v[0], m[0], v[2]}, {m[0], v[1], v[2]}});
    if (count == 2) add({{m[0], v[1], m[1]}, {v[0], m[0], v[2]}, {m[0], m[1], v[2]}});
    if (count == 3)
      add({{v[0], m[0], m[2]}, {m[0], v[1], m[1]}, {m[2], m[1], v[2]}, {m[0], m[1], m[2]}});
  }

  void add(std::initializer_list<Eigen::Vector3i> faces) {
    faces_.insert(faces_.end(), faces.begin(), faces.end());
  }

  double longest_;
  std::vector<Vector3d> vertices_;
  std::vector<Eigen::Vector3i> faces_;
  std::map<std::pair<int, int>, int> middles_;
};

double total_area(const TriMesh& mesh) {
  double area = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) area += hydro::area_vector(mesh, f).norm();
  return area;
}

/// Returns twice the root mean square deviation of waves from a straight line [m], in the middle of
/// an edge of the given length along their heading.
double wave_sag(const hydro::WaveSurface& waves, double length) {
  double square = 0;
  for (const hydro::WaveComponent& w : waves.components) {
    const double turn = std::min(std::hypot(w.kx, w.ky) * length / 2, M_PI);
    square += 0.5 * std::pow(w.amplitude * (1 - std::cos(turn)), 2);
  }
  return 2 * std::sqrt(square);
}

double straight_edge(const hydro::FlatSurface&, double) {
  return std::numeric_limits<double>::infinity();
}

double straight_edge(const hydro::HeightField& field, double sag) {
  const double rise = field.heights.maxCoeff() - field.heights.minCoeff();
  return rise > sag ? field.cell : std::numeric_limits<double>::infinity();
}

double straight_edge(const hydro::WaveSurface& waves, double sag) {
  double longest_wave = 0;
  for (const hydro::WaveComponent& w : waves.components)
    longest_wave = std::max(longest_wave, 2 * M_PI / std::hypot(w.kx, w.ky));
  if (wave_sag(waves, longest_wave) <= sag) return std::numeric_limits<double>::infinity();
  double low = 0, high = longest_wave;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (wave_sag(waves, middle) <= sag ? low : high) = middle;
  }
  return high;
}

}  // namespace

Eigen::Matrix2Xi edges_of(const TriMesh& mesh) {
  const std::vector<hydro::HalfEdge> halves = hydro::sorted_half_edges(mesh);
  Eigen::Matrix2Xi edges(2, static_cast<Index>(halves.size()));
  Index count = 0;
  for (std::size_t i = 0; i < halves.size(); i = hydro::edge_end(halves, i))
    edges.col(count++) << halves[i].low, halves[i].high;
  return edges.leftCols(count);
}

Eigen::Matrix2Xi creases_of(const TriMesh& mesh) {
  const std::vector<hydro::HalfEdge> halves = hydro::sorted_half_edges(mesh);
  const auto normal = [&](const hydro::HalfEdge& half) {
    return hydro::area_vector(mesh, half.face).normalized();
  };
  Eigen::Matrix2Xi creases(2, static_cast<Index>(halves.size()));
  Index count = 0;
  for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
    end = hydro::edge_end(halves, i);
    const bool smooth =
        end - i == 2 && normal(halves[i]).dot(normal(halves[i + 1])) >= std::cos(kCreaseAngle);
    if (!smooth) creases.col(count++) << halves[i].low, halves[i].high;
  }
  return creases.leftCols(count);
}

ShadedMesh make_shaded_mesh(const TriMesh& mesh) {
  Eigen::Matrix3Xd areas(3, mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) areas.col(f) = hydro::area_vector(mesh, f);
  const FacesOfVertices around = faces_of_vertices(mesh);
  SkinVertices vertices(mesh.vertex_count());
  ShadedMesh skin;
  skin.triangles.resize(3, mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (int i = 0; i < 3; ++i) {
      const int v = mesh.faces(i, f);
      const Index* begin = around.faces.data() + around.first[static_cast<std::size_t>(v)];
      const Index* end = around.faces.data() + around.first[static_cast<std::size_t>(v) + 1];
      skin.triangles(i, f) = vertices.add(v, corner_normal(areas, begin, end, f));
    }
  vertices.store(mesh, skin);
  return skin;
}

TriMesh subdivided(const TriMesh& mesh, double longest, double most_faces) {
  // Final edges measure between half the limit and the limit; a right triangle with two sides of
  // half the limit has an area of an eighth of the limit squared.
  longest = std::max(longest, std::sqrt(8 * total_area(mesh) / most_faces));
  TriMesh result = mesh;
  while (longest_edge(result) > longest) result = EdgeSplitter(result, longest).result();
  return result;
}

double longest_straight_edge(const hydro::Sea& sea, double sag) {
  return std::visit([&](const auto& surface) { return straight_edge(surface, sag); }, sea.surface);
}

double longest_sheared_edge(const hydro::Sea& sea) {
  constexpr double kParts = 32;
  if (sea.profile.size() < 2) return std::numeric_limits<double>::infinity();
  return (sea.profile.back().depth - sea.profile.front().depth) / kParts;
}

}  // namespace render

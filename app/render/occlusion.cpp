#include "app/render/occlusion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/decompositions.h"
#include "hydro/mesh/edge_table.h"
#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mesh_parts.h"
#include "hydro/parallel.h"

namespace render {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr Index kMostVertices = 50'000;
constexpr Index kMostRays = 400'000;
constexpr Index kFewestRays = 8, kEnoughRays = 48;

/// Rays start this far above their vertex, so that they do not meet its own faces.
constexpr double kLift = 1e-3;  // of the mesh's size

/// Returns directions about +z whose density is proportional to the cosine of their angle to it:
/// points on a golden-angle spiral in the unit disc, projected onto the sphere.
std::vector<Vector3d> directions(Index count) {
  constexpr double kGoldenAngle = 2.399963229728653;
  std::vector<Vector3d> all;
  for (Index i = 0; i < count; ++i) {
    const double square = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double angle = kGoldenAngle * static_cast<double>(i);
    all.emplace_back(std::sqrt(square) * std::cos(angle), std::sqrt(square) * std::sin(angle),
                     std::sqrt(1 - square));
  }
  return all;
}

float open_share(const hydro::FaceTree& tree, const Vector3d& start, const Vector3d& normal,
                 const std::vector<Vector3d>& rays) {
  const Eigen::Quaterniond turn = hydro::shortest_turn(Vector3d::UnitZ(), normal);
  const auto free = std::count_if(rays.begin(), rays.end(), [&](const Vector3d& ray) {
    return tree.crossings(start, turn * ray, [](int) { return true; }) == 0;
  });
  return static_cast<float>(free) / static_cast<float>(rays.size());
}

/// Returns true if each edge has two faces and none bends inward by more than `lift` [m]. A closed
/// mesh of one part is then convex; a mesh of several parts may still occlude itself.
bool has_no_hollow_edge(const hydro::TriMesh& mesh, const std::vector<hydro::HalfEdge>& halves,
                        double lift) {
  const auto opposite = [&](const hydro::HalfEdge& side) {
    const auto f = mesh.faces.col(side.face);
    return mesh.vertices.col(f.sum() - side.low - side.high);
  };
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const std::size_t end = hydro::edge_end(halves, i);
    if (end != i + 2) return false;
    const hydro::HalfEdge &a = halves[i], &b = halves[++i];
    const Vector3d n = hydro::area_vector(mesh, a.face).normalized();
    if (n.dot(opposite(b) - mesh.vertices.col(a.low)) > lift) return false;
  }
  return true;
}

bool is_convex(const hydro::TriMesh& mesh, const hydro::FaceTree& tree, double lift) {
  const std::vector<hydro::HalfEdge> halves = hydro::sorted_half_edges(mesh);
  return has_no_hollow_edge(mesh, halves, lift) &&
         hydro::closed_parts(mesh, halves, tree).size() == 1;
}

}  // namespace

Eigen::RowVectorXf openness(const hydro::TriMesh& mesh, const ShadedMesh& skin) {
  const Index count = skin.vertices.cols();
  Eigen::RowVectorXf open = Eigen::RowVectorXf::Ones(count);
  if (count == 0 || count > kMostVertices) return open;
  const double lift = kLift * mesh.vertices.colwise().norm().maxCoeff();
  const hydro::FaceTree tree(mesh);
  if (is_convex(mesh, tree, lift)) return open;
  const std::vector<Vector3d> rays =
      directions(std::clamp(kMostRays / count, kFewestRays, kEnoughRays));
  hydro::parallel_for(static_cast<std::size_t>(count), [&](std::size_t i) {
    const auto v = static_cast<Index>(i);
    const Vector3d normal = skin.normals.col(v);
    open[v] = open_share(tree, skin.vertices.col(v) + lift * normal, normal, rays);
  });
  return open;
}

}  // namespace render

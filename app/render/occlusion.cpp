#include "app/render/occlusion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/face_tree.h"
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

/// Directions about +z, as dense as the cosine to it: points on a disc, along a spiral of the
/// golden angle, raised to the sphere.
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
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), normal);
  const auto free = std::count_if(rays.begin(), rays.end(), [&](const Vector3d& ray) {
    return tree.crossings(start, turn * ray, [](int) { return true; }) == 0;
  });
  return static_cast<float>(free) / static_cast<float>(rays.size());
}

/// True if all vertices are behind the plane of every face.
bool is_convex(const hydro::TriMesh& mesh, double tolerance) {
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Vector3d n = hydro::area_vector(mesh, f).normalized();
    const double height = n.dot(mesh.vertices.col(mesh.faces(0, f))) + tolerance;
    if ((n.transpose() * mesh.vertices).maxCoeff() > height) return false;
  }
  return true;
}

}  // namespace

Eigen::RowVectorXf openness(const hydro::TriMesh& mesh, const Skin& skin) {
  const Index count = skin.vertices.cols();
  Eigen::RowVectorXf open = Eigen::RowVectorXf::Ones(count);
  if (count == 0 || count > kMostVertices) return open;
  const double lift = kLift * mesh.vertices.colwise().norm().maxCoeff();
  if (is_convex(mesh, lift)) return open;
  const std::vector<Vector3d> rays =
      directions(std::clamp(kMostRays / count, kFewestRays, kEnoughRays));
  const hydro::FaceTree tree(mesh);
  hydro::parallel_for(static_cast<std::size_t>(count), [&](std::size_t i) {
    const auto v = static_cast<Index>(i);
    const Vector3d normal = skin.normals.col(v);
    open[v] = open_share(tree, skin.vertices.col(v) + lift * normal, normal, rays);
  });
  return open;
}

}  // namespace render

#include "hydro/mesh/mirror_symmetry.h"

#include <algorithm>
#include <vector>

namespace hydro {
namespace {

/// True if one of the points, ascending in x, is within the tolerance of p.
bool is_among(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& p,
              double tolerance) {
  auto point = std::lower_bound(points.begin(), points.end(), p.x() - tolerance,
                                [](const Eigen::Vector3d& q, double x) { return q.x() < x; });
  for (; point != points.end() && point->x() <= p.x() + tolerance; ++point)
    if ((*point - p).cwiseAbs().maxCoeff() <= tolerance) return true;
  return false;
}

}  // namespace

bool is_mirror_symmetric(const TriMesh& mesh, int axis, double tolerance) {
  // Ascending in a direction in which hardly any two vertices are alike, so that few are compared.
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.31, -0.52, 0.79).normalized()).toRotationMatrix();
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  mirror(axis, axis) = -1;
  std::vector<Eigen::Vector3d> points;
  for (const auto& vertex : mesh.vertices.colwise()) points.push_back(turn * vertex);
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() < b.x(); });
  return std::all_of(
      mesh.vertices.colwise().begin(), mesh.vertices.colwise().end(),
      [&](const auto& vertex) { return is_among(points, turn * (mirror * vertex), tolerance); });
}

}  // namespace hydro

#include "app/view/picking.h"

#include <Eigen/Geometry>
#include <limits>
#include <numbers>

namespace app {
namespace {

using Eigen::Vector3d;

/// Rate of the pull, 2π over the 0.3 s in which a body follows the mouse [1/s].
constexpr double kRate = 2 * std::numbers::pi / 0.3;

constexpr double kNone = std::numeric_limits<double>::infinity();

/// Returns the ray parameter t > 0 for which from + t·along lies on a triangle; kNone if the ray
/// misses it [MT97].
///
/// [MT97] Möller and Trumbore. Fast, minimum storage ray-triangle intersection.
/// J. Graphics Tools 2 (1997).
double distance_to_triangle(const Vector3d& from, const Vector3d& along,
                            const Eigen::Matrix3d& corners) {
  const Vector3d a = corners.col(1) - corners.col(0), b = corners.col(2) - corners.col(0);
  const Vector3d h = along.cross(b);
  const double determinant = a.dot(h);
  if (determinant == 0) return kNone;
  const Vector3d s = from - corners.col(0);
  const Vector3d q = s.cross(a);
  const double u = s.dot(h) / determinant, v = along.dot(q) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return kNone;
  const double distance = b.dot(q) / determinant;
  return distance > 0 ? distance : kNone;
}

double distance_to_mesh(const Vector3d& from, const Vector3d& along, const hydro::TriMesh& mesh) {
  double nearest = kNone;
  for (Eigen::Index i = 0; i < mesh.face_count(); ++i) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = mesh.vertices.col(mesh.faces(k, i));
    nearest = std::min(nearest, distance_to_triangle(from, along, corners));
  }
  return nearest;
}

}  // namespace

std::optional<Hit> first_hit(const Ray& ray, const std::vector<engine::BodySpec>& bodies,
                             const std::vector<hydro::BodyState>& states) {
  std::optional<Hit> first;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Eigen::Quaterniond to_B = states[i].orientation.conjugate();
    const Vector3d from = to_B * (ray.from_W - states[i].position);
    const Vector3d along = to_B * ray.along_W;
    const double depth = distance_to_mesh(from, along, bodies[i].mesh_B);
    if (depth < (first ? first->depth : kNone))
      first = Hit{static_cast<engine::BodyId>(i), from + depth * along, depth};
  }
  return first;
}

engine::Pull pull_towards(const Hit& held, const Ray& ray) {
  return {.at_B = held.at_B, .to_W = ray.from_W + held.depth * ray.along_W, .rate = kRate};
}

}  // namespace app

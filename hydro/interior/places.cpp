#include "hydro/interior/places.h"

#include <algorithm>
#include <cmath>

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Two faces with normals this much apart look opposite ways: the cosine of their angle is below.
constexpr double kOpposite = -0.5;

/// Height at which the vertical through a point meets a face, relative to the point; NaN where it
/// misses it.
double height_over(const TriMesh& mesh, Eigen::Index face, const Vector3d& point,
                   const Vector3d& up) {
  const Vector3d a = mesh.vertices.col(mesh.faces(0, face)) - point;
  const Vector3d b = mesh.vertices.col(mesh.faces(1, face)) - point;
  const Vector3d c = mesh.vertices.col(mesh.faces(2, face)) - point;
  const double whole = up.dot((b - a).cross(c - a));
  const Vector3d weight(up.dot(b.cross(c)), up.dot(c.cross(a)), up.dot(a.cross(b)));
  if (whole == 0 || (weight / whole).minCoeff() < 0) return NAN;
  return weight.dot(Vector3d(up.dot(a), up.dot(b), up.dot(c))) / whole;
}

/// The point of a segment from the origin that is nearest to it.
Vector3d nearest_on(const Vector3d& from, const Vector3d& to) {
  const Vector3d along = to - from;
  const double length = along.squaredNorm();
  if (length == 0) return from;
  return from + std::clamp(-from.dot(along) / length, 0.0, 1.0) * along;
}

double distance_to(const TriMesh& mesh, Eigen::Index face, const Vector3d& point) {
  const Vector3d normal = area_vector(mesh, face).normalized();
  const double above = height_over(mesh, face, point, normal);
  if (std::isfinite(above)) return std::abs(above);
  double nearest = HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const Vector3d from = mesh.vertices.col(mesh.faces(i, face)) - point;
    const Vector3d to = mesh.vertices.col(mesh.faces((i + 1) % 3, face)) - point;
    nearest = std::min(nearest, nearest_on(from, to).norm());
  }
  return nearest;
}

}  // namespace

int pocket_under(const TriMesh& mesh, const Pockets& division, const Vector3d& point,
                 const Vector3d& up) {
  int pocket = kSea;
  double highest = -HUGE_VAL;
  for (Eigen::Index f = 0; f < static_cast<Eigen::Index>(division.pocket_of_face.size()); ++f) {
    const double height = height_over(mesh, f, point, up);
    if (!(height <= 0) || height <= highest) continue;
    highest = height;
    pocket = division.pocket_of_face[f];
  }
  return pocket;
}

WallFaces wall_at(const TriMesh& mesh, const Vector3d& point) {
  WallFaces wall;
  double nearest = HUGE_VAL, opposite = HUGE_VAL;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const double distance = distance_to(mesh, f, point);
    if (distance >= nearest) continue;
    nearest = distance;
    wall.face[0] = f;
  }
  const Vector3d normal = area_vector(mesh, wall.face[0]).normalized();
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (normal.dot(area_vector(mesh, f).normalized()) > kOpposite) continue;
    const double distance = distance_to(mesh, f, point);
    if (distance >= opposite) continue;
    opposite = distance;
    wall.face[1] = f;
  }
  wall.distance = opposite;
  return wall;
}

}  // namespace hydro

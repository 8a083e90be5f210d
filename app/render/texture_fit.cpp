#include "app/render/texture_fit.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace render {
namespace {

using Eigen::Vector3d;

/// Part of the way from a corner to the middle at which the surface is read: on a seam the side of
/// the triangle decides. It outweighs the rounding of coordinates to floats, 1e-7.
constexpr double kInward = 1e-3;

/// Largest deviation of the middle's coordinates from the mean of the corners', over the longest
/// side between these. A seam deviates by a third or more.
constexpr float kNotLinear = 0.1F;

/// Largest distance of the middle from the surface, over the longest side of the triangle. A
/// triangle that closes a hole lies farther away.
constexpr double kOffSurface = 0.1;

/// Steps in which coordinates are kept: the corners in which triangles meet round to one vertex. A
/// step is a 16th of a pixel of the largest image.
constexpr float kStepsOfUnit = 65536;

/// A point of the surface.
struct SurfacePoint {
  Vector3d place;               ///< [m, B]
  Eigen::Vector2f coordinates;  ///< Its texture coordinates.
};

/// Returns about the nearest point of a face: within it the foot of the perpendicular.
SurfacePoint point_on(const Paint& paint, int face, const Vector3d& p) {
  const auto v = paint.surface_B.faces.col(face);
  Eigen::Matrix3d corners;
  for (int i = 0; i < 3; ++i) corners.col(i) = paint.surface_B.vertices.col(v[i]);
  const Vector3d e1 = corners.col(1) - corners.col(0), e2 = corners.col(2) - corners.col(0);
  const Vector3d normal = e1.cross(e2), arm = p - corners.col(0);
  Vector3d weights(1, 0, 0);
  if (const double area2 = normal.squaredNorm(); area2 > 0) {
    const double a = arm.cross(e2).dot(normal) / area2, b = e1.cross(arm).dot(normal) / area2;
    weights = Vector3d(1 - a - b, a, b).cwiseMax(0.0);
    weights /= weights.sum();
  }
  return {corners * weights, paint.textures->corners(face) * weights.cast<float>()};
}

/// True for a point of a face; to find the nearest face takes longer.
bool lies_on(const Paint& paint, int face, const Vector3d& p) {
  constexpr double kRounding = 1e-6;  // Times the way from the face's first corner.
  const Vector3d first = paint.surface_B.vertices.col(paint.surface_B.faces(0, face));
  return (point_on(paint, face, p).place - p).norm() <= kRounding * (p - first).norm();
}

template <class Corners>
auto longest_side_of(const Corners& c) {
  return std::max(
      {(c.col(0) - c.col(1)).norm(), (c.col(1) - c.col(2)).norm(), (c.col(2) - c.col(0)).norm()});
}

}  // namespace

std::optional<CornerCoordinates> fitted_coordinates(const hydro::FaceTree& tree, const Paint& paint,
                                                    const Eigen::Matrix3d& corners, int face) {
  const Vector3d middle = corners.rowwise().mean();
  const SurfacePoint at_middle = point_on(paint, face, middle);
  if ((at_middle.place - middle).norm() > kOffSurface * longest_side_of(corners))
    return std::nullopt;
  CornerCoordinates found;
  for (int i = 0; i < 3; ++i) {
    const Vector3d inner = corners.col(i) + kInward * (middle - corners.col(i));
    const int nearest = lies_on(paint, face, inner) ? face : tree.nearest(inner);
    if (paint.textures->of_face[nearest] != paint.textures->of_face[face] ||
        paint.textures->tints.col(nearest) != paint.textures->tints.col(face))
      return std::nullopt;
    const SurfacePoint at_corner = point_on(paint, nearest, inner);
    found.col(i) = at_middle.coordinates + (at_corner.coordinates - at_middle.coordinates) /
                                               static_cast<float>(1 - kInward);
  }
  const Eigen::Vector2f mean = found.rowwise().mean();
  const float rounding = 1e-5F * (1 + mean.cwiseAbs().maxCoeff());
  const float deviation = (at_middle.coordinates - mean).norm();
  if (!(deviation <= kNotLinear * longest_side_of(found) + rounding)) return std::nullopt;
  return (found * kStepsOfUnit).array().round() / kStepsOfUnit;
}

}  // namespace render

#pragma once

#include <Eigen/Core>
#include <vector>

/// @file
/// Convex polygons in planes in space: cutting them by lines, and subtracting one from others.
///
/// Lengths up to `margin` [m] count as none: points that near to a line lie on it, and a polygon
/// whose area is below the margin times its perimeter has none.

namespace hydro {

/// Corners in order; all of them in one plane.
using Polygon = std::vector<Eigen::Vector3d>;

/// Returns the signed distances of points from the line through a side of a convex polygon,
/// positive on its inner side; those within the margin are 0.
/// @param normal   Axis about which the polygon is counter-clockwise.
std::vector<double> from_side(const Polygon& points, const Polygon& polygon, std::size_t side,
                              const Eigen::Vector3d& normal, double margin);

/// Returns the part of a convex polygon on one side of a line.
/// @param distances   Signed distances of its corners from the line.
/// @param sign        Sign of the distances that are kept.
Polygon kept_part(const Polygon& polygon, const std::vector<double>& distances, int sign);

double area_of(const Polygon& polygon);

/// True if a polygon has three corners that are not nearly on one line.
bool has_area(const Polygon& polygon, double margin);

/// Returns the convex hull of points in a plane, counter-clockwise about its normal, without points
/// on its sides.
Polygon convex_hull(Polygon points, const Eigen::Vector3d& normal, double margin);

/// Subtracts a convex polygon, counter-clockwise about `normal`, from others in its plane.
std::vector<Polygon> without(const std::vector<Polygon>& polygons, const Polygon& hole,
                             const Eigen::Vector3d& normal, double margin);

}  // namespace hydro

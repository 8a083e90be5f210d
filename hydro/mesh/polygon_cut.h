#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace hydro {

/// Cuts a polygon into triangles by cutting off its corners, in the mean plane of the polygon, and
/// adds them to `faces`. They keep its sense. A concave polygon is cut inside; a corner on a
/// straight side gives no triangle without area. A convex one becomes a fan of its first corner. A
/// polygon that crosses itself or has no area is cut somehow, into as many triangles.
///
/// The time is that of the product of all corners and those that point inward.
/// @param vertices   All vertices of the mesh.
/// @param corners    Indices of the polygon's vertices, at least 3.
void cut_polygon(const std::vector<Eigen::Vector3d>& vertices, std::span<const int> corners,
                 std::vector<Eigen::Vector3i>& faces);

}  // namespace hydro

#pragma once

#include <Eigen/Core>
#include <vector>

namespace hydro {

/// Cuts the area inside a closed line and outside others into triangles, and adds them to `faces`.
/// Each hole is joined to the outline by a bridge, and the polygon that results is cut as
/// polygon_cut.h does.
/// @param vertices   All vertices of the mesh.
/// @param outline    Counter-clockwise about `normal`; the triangles are so, too.
/// @param holes      Clockwise, inside the outline and outside each other.
void cut_region(const std::vector<Eigen::Vector3d>& vertices, const std::vector<int>& outline,
                std::vector<std::vector<int>> holes, const Eigen::Vector3d& normal,
                std::vector<Eigen::Vector3i>& faces);

/// True if a point is inside a closed line, both projected along `normal`.
bool encloses(const std::vector<Eigen::Vector3d>& vertices, const std::vector<int>& outline,
              const Eigen::Vector3d& normal, const Eigen::Vector3d& point);

}  // namespace hydro

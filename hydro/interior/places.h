#pragma once

#include <array>

#include "hydro/interior/pockets.h"

/// @file
/// Which space a point or a wall of a hollow body belongs to.

namespace hydro {

/// The pocket whose surface is straight below a point in the mesh's frame, or kSea.
int pocket_under(const TriMesh& mesh, const Pockets& division, const Eigen::Vector3d& point,
                 const Eigen::Vector3d& up);

/// The two faces of the wall that a point lies in or near: the nearest one, and the nearest of
/// those that look the other way.
struct WallFaces {
  std::array<int, 2> face = {-1, -1};
  double distance = 0;  ///< Distance of the point to the second, farther one of them [m].
};

/// @param mesh   It has faces.
WallFaces wall_at(const TriMesh& mesh, const Eigen::Vector3d& point);

}  // namespace hydro

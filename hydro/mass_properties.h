#pragma once

#include "hydro/mesh.h"

namespace hydro {

/// Integrals over the solid that a closed mesh bounds, for density 1.
struct SolidProperties {
  double volume = 0;                                   ///< [m^3]
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< In the mesh frame [m].
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();   ///< About the centroid, mesh axes [m^5].
};

/// Exact to round-off: the sum over the tetrahedra that the faces span with a point of the mesh.
SolidProperties solid_properties(const TriMesh& mesh);

}  // namespace hydro

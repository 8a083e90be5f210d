#pragma once

#include "hydro/mesh/mesh.h"

namespace hydro {

/// Integrals over the solid that a closed mesh bounds, for density 1.
struct SolidProperties {
  double volume = 0;                                   ///< [m^3]
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< In the mesh frame [m].
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();   ///< About the centroid, mesh axes [m^5].
};

/// Exact to round-off: the sum over the tetrahedra that the faces span with the middle of the
/// mesh's bounding box, so a mesh far from its origin loses no more digits than its coordinates. A
/// cavity whose normals point into it counts negative, as does a mesh turned inward as a whole. For
/// a mesh without volume the centroid is the middle of the box.
SolidProperties solid_properties(const TriMesh& mesh);

}  // namespace hydro

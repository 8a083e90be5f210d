#pragma once

#include "hydro/mesh/mesh.h"

/// @file
/// Volume, centroid and inertia of the solid in a mesh.

namespace hydro {

/// Integrals over the solid that a closed mesh bounds, for density 1.
struct SolidProperties {
  double volume = 0;                                   ///< [m^3]
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< In the mesh frame [m].
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();   ///< About the centroid, mesh axes [m^5].
};

/// Returns the integrals, exact to round-off: they are sums over the tetrahedra between the faces
/// and the centre of the mesh's bounding box, so a mesh far from its origin loses no more digits
/// than its coordinates do. The volume of a cavity, or of a mesh whose normals all point inward, is
/// negative. For a mesh without volume the centroid is the centre of the box.
SolidProperties solid_properties(const TriMesh& mesh);

}  // namespace hydro

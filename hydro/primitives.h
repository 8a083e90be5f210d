#pragma once

#include "hydro/mesh.h"

/// @file
/// Closed meshes of simple solids, centred on the origin, outward, in metres. Vertices lie on the
/// smooth surface, so a mesh of a sphere is inscribed in it.
/// @throws std::invalid_argument if a size is not positive or a count is too small (named there).

namespace hydro {

/// 12·divisions² triangles; divisions >= 1.
TriMesh make_box(const Eigen::Vector3d& size, int divisions = 1);

/// UV sphere, poles on z: 2·slices·(stacks − 1) triangles; slices >= 3, stacks >= 2.
TriMesh make_sphere(double radius, int slices, int stacks);

/// The UV sphere scaled along the axes.
TriMesh make_ellipsoid(const Eigen::Vector3d& semi_axes, int slices, int stacks);

/// Icosahedron, each triangle split in four `subdivisions` times: 20·4^n triangles; 0 … 9.
TriMesh make_icosphere(double radius, int subdivisions);

/// Cylinder about z, capped: slices >= 3 around, stacks >= 1 along.
TriMesh make_cylinder(double radius, double height, int slices, int stacks);

}  // namespace hydro

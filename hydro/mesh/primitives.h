#pragma once

#include "hydro/mesh/mesh.h"

/// @file
/// Closed meshes of simple solids, centred on the origin, with outward normals, in metres. Vertices
/// lie on the smooth surface, so a mesh of a sphere is inscribed in it, and every vertex is shared
/// by all faces that meet there. Diagonals alternate, so a mesh with even counts is its own mirror
/// image in the coordinate planes, to the last digit.
/// @throws std::invalid_argument if a size is not positive and finite, a count is too small (named
///         there), or the mesh would have more than kMostTriangles.

namespace hydro {

/// Limit that catches mistyped counts: 50 million triangles fill about 2 GB.
constexpr double kMostTriangles = 5e7;

/// Box of 12·divisions² triangles on 6·divisions² + 2 vertices; divisions >= 1.
TriMesh make_box(const Eigen::Vector3d& size, int divisions = 1);

/// UV sphere, poles on z: 2·slices·(stacks − 1) triangles on slices·(stacks − 1) + 2 vertices;
/// slices >= 3, stacks >= 2.
TriMesh make_sphere(double radius, int slices, int stacks);

/// The UV sphere scaled along the axes.
TriMesh make_ellipsoid(const Eigen::Vector3d& semi_axes, int slices, int stacks);

/// Icosahedron, each triangle split in four `subdivisions` times: 20·4^n triangles on 10·4^n + 2
/// vertices; subdivisions is 0 … 9.
TriMesh make_icosphere(double radius, int subdivisions);

/// Number of concentric rings in each cap of make_cylinder: the radius over the longer edge of a
/// side panel, at least 1.
int cylinder_cap_rings(double radius, double height, int slices, int stacks);

/// Cylinder about z, capped: slices >= 3 around, stacks >= 1 along, 2·slices·(stacks + 2m − 1)
/// triangles with m = cylinder_cap_rings.
TriMesh make_cylinder(double radius, double height, int slices, int stacks);

}  // namespace hydro

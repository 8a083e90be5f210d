#pragma once

#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"

/// @file
/// Meshes as they are drawn.

namespace render {

/// Triangles with a normal a vertex. A vertex of the mesh on a crease appears once for each side.
struct ShadedMesh {
  Eigen::Matrix3Xd vertices;   ///< 3×V, in the mesh's frame [m].
  Eigen::Matrix3Xd normals;    ///< 3×V, unit.
  Eigen::Matrix3Xi triangles;  ///< 3×F
};

/// Edges at which normals turn by more than this stay sharp: those of a cube and of a cylinder's
/// caps do, those of a sphere of 12 slices do not [rad].
inline constexpr double kCreaseAngle = 0.6981317007977318;  // 40 degrees

/// The edges of a mesh, each once: 2×E, vertex numbers.
Eigen::Matrix2Xi edges_of(const hydro::TriMesh& mesh);

/// Smooth normals: in each corner of a face the sum of the normals, weighted by area, of the faces
/// around that vertex which lie within the crease angle of the face itself.
ShadedMesh make_shaded_mesh(const hydro::TriMesh& mesh);

/// The same surface with triangles split until no edge is longer than `longest` [m]. Edges are
/// halved, each on its own account, so that no gaps open. `longest` is raised as far as needed to
/// make no more than about `most_faces`.
hydro::TriMesh subdivided(const hydro::TriMesh& mesh, double longest, double most_faces);

/// The longest edge along which the water surface departs from linear by less than `sag` [m], in
/// any direction: for waves twice the departure's root mean square over time, for a height field
/// its cell. Infinite if the surface never departs so far.
double longest_straight_edge(const hydro::Sea& sea, double sag);

}  // namespace render

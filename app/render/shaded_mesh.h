#pragma once

#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"

/// @file
/// Meshes prepared for drawing.

namespace render {

/// Triangles with vertex normals. A vertex of the mesh on a crease appears once for each side.
struct ShadedMesh {
  Eigen::Matrix3Xd vertices;   ///< 3×V, in the mesh's frame [m].
  Eigen::Matrix3Xd normals;    ///< 3×V, unit.
  Eigen::Matrix3Xi triangles;  ///< 3×F
};

/// Angle between face normals above which an edge stays sharp [rad]: edges of a cube and of a
/// cylinder's caps do, edges of a sphere of 12 slices do not.
inline constexpr double kCreaseAngle = 0.6981317007977318;  // 40 degrees

/// Returns the edges of a mesh, each once, as vertex indices (2×E).
Eigen::Matrix2Xi edges_of(const hydro::TriMesh& mesh);

/// Returns those edges of a mesh along which its faces meet at more than the crease angle or that
/// have another number of faces than two, as vertex indices (2×E).
Eigen::Matrix2Xi creases_of(const hydro::TriMesh& mesh);

/// Makes a mesh with smooth normals. The normal in a corner of a face is the area-weighted mean
/// over the faces around that vertex whose normals lie within the crease angle of the face's.
ShadedMesh make_shaded_mesh(const hydro::TriMesh& mesh);

/// Returns the surface with triangles split until no edge is longer than `longest` [m]. The length
/// of an edge alone decides on its halving, so that no gaps open. `longest` is raised where it
/// would lead to more than about `most_faces`.
hydro::TriMesh subdivided(const hydro::TriMesh& mesh, double longest, double most_faces);

/// Returns the length of the longest edge, in any direction, along which the water surface deviates
/// from a straight line by less than `sag` [m]. For waves the deviation is twice its root mean
/// square over time; for a height field the length is that of its cell. The length is infinite if
/// the surface never deviates so far.
double longest_straight_edge(const hydro::Sea& sea, double sag);

/// Returns the length of an edge along which a current that changes with depth is drawn as linear:
/// a small part of its table [m]. The length is infinite in a uniform current.
double longest_sheared_edge(const hydro::Sea& sea);

}  // namespace render

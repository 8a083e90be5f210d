#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

/// @file
/// Triangle meshes.

namespace hydro {

/// A triangle mesh. Faces are counter-clockwise when seen from outside, so that normals point out
/// of the solid. The name of the variable states the frame of the vertices (`mesh_B`).
struct TriMesh {
  Eigen::Matrix3Xd vertices;  ///< 3×V [m].
  Eigen::Matrix3Xi faces;     ///< 3×F, columns of `vertices`.

  /// Number of vertices.
  Eigen::Index vertex_count() const { return vertices.cols(); }
  /// Number of faces.
  Eigen::Index face_count() const { return faces.cols(); }
};

/// True if both meshes have the same vertices and faces, in the same order.
bool same_mesh(const TriMesh& a, const TriMesh& b);

/// The mesh moved by `offset` [m].
TriMesh translated(TriMesh mesh, const Eigen::Vector3d& offset);

/// The mesh scaled about its origin; a negative factor mirrors it and keeps normals outward.
TriMesh scaled(TriMesh mesh, double factor);

/// The mesh rotated and moved by `X_AB`: its vertices are given in B and returned in A.
TriMesh transformed(TriMesh mesh_B, const Eigen::Isometry3d& X_AB);

/// The mesh with the orientation of every face reversed.
TriMesh flipped(TriMesh mesh);

/// Area times unit normal of face `face`, by the right-hand rule [m^2].
Eigen::Vector3d area_vector(const TriMesh& mesh, Eigen::Index face);

/// Length of the longest edge [m]; 0 for a mesh without faces.
double longest_edge(const TriMesh& mesh);

/// Smallest axis-aligned box around the vertices [m].
Eigen::AlignedBox3d bounding_box(const TriMesh& mesh);

}  // namespace hydro

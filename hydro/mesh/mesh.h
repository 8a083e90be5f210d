#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace hydro {

/// A triangle mesh. Faces are counter-clockwise when seen from outside, so that normals point out
/// of the solid. The frame of the vertices is told by the name of the variable (`mesh_B`).
struct TriMesh {
  Eigen::Matrix3Xd vertices;  ///< 3×V [m].
  Eigen::Matrix3Xi faces;     ///< 3×F, columns of `vertices`.

  Eigen::Index vertex_count() const { return vertices.cols(); }
  Eigen::Index face_count() const { return faces.cols(); }
};

/// True if the two have the same vertices and faces, in the same order.
bool same_mesh(const TriMesh& a, const TriMesh& b);

/// The mesh moved by `offset` [m].
TriMesh translated(TriMesh mesh, const Eigen::Vector3d& offset);

/// The mesh scaled about its origin; a negative factor mirrors it and keeps normals outward.
TriMesh scaled(TriMesh mesh, double factor);

/// The mesh rotated and moved by `X_AB`: vertices given in B come back in A.
TriMesh transformed(TriMesh mesh_B, const Eigen::Isometry3d& X_AB);

/// The mesh with every face turned over.
TriMesh flipped(TriMesh mesh);

/// Area times unit normal of face `face`, by the right-hand rule [m^2].
Eigen::Vector3d area_vector(const TriMesh& mesh, Eigen::Index face);

/// Of the faces [m]; 0 without any.
double longest_edge(const TriMesh& mesh);

/// Smallest axis-aligned box around the vertices [m].
Eigen::AlignedBox3d bounding_box(const TriMesh& mesh);

}  // namespace hydro

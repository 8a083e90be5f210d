#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// Checks that a triangle mesh bounds a solid: the mesh is closed, two faces meet at each edge, and
/// all faces are oriented consistently and outward.
///
/// Adjacent faces must share vertices (see weld.h): equal positions alone do not connect faces. A
/// mesh may have several closed parts, side by side or nested. A part inside another bounds a
/// cavity and must be oriented inward, a part in that cavity outward, and so on.

namespace hydro {

/// The faults of a mesh, with the place of the first of each kind. A sound solid has zero counts.
struct MeshReport {
  /// Faults of one kind.
  struct Finding {
    Eigen::Index count = 0;                           ///< Number of faults.
    Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< Point of the first fault, mesh frame [m].
  };
  Finding not_finite;         ///< Vertices with an infinite or undefined coordinate.
  Finding open_edges;         ///< Edges with one face.
  Finding crowded_edges;      ///< Edges with more than two faces.
  Finding misoriented_edges;  ///< Edges whose two faces have opposite orientations.
  Finding degenerate_faces;   ///< Faces without area: flatter than 1e-12 of their longest edge.
  Finding duplicate_faces;    ///< Faces with the same three vertices as an earlier one.
  Finding self_overlaps;      ///< Pairs of faces that cut through each other (mesh_overlap.h).
  Finding misturned_parts;    ///< Closed parts oriented against the rest.
  bool inward = false;        ///< True for a closed, consistent mesh whose normals point inward.
  bool empty = false;         ///< True for a closed mesh that encloses no volume.
  double volume = 0;          ///< Signed by the orientation [m^3]; 0 unless closed and finite.

  /// True if two faces meet at each edge.
  bool closed() const { return open_edges.count == 0 && crowded_edges.count == 0; }
  bool sound() const;  ///< True if no fault was found.
};

/// Checks a mesh. If a vertex is not finite, only the connections between faces are checked. Parts
/// are checked if the faces fit together and do not cut each other.
/// @throws std::invalid_argument if a face names a vertex that does not exist.
MeshReport check_mesh(const TriMesh& mesh);

/// True if a face is flatter than 1e-12 of its longest edge.
bool has_no_area(const TriMesh& mesh, Eigen::Index face);

/// Describes each kind of fault in one sentence with count and place; empty for a sound solid.
std::vector<std::string> describe(const MeshReport& report);

/// A mesh after the only unambiguous repair: a mesh whose normals all point inward is turned
/// outward.
struct RepairedMesh {
  TriMesh mesh;                    ///< The mesh after the repair.
  MeshReport report;               ///< Report on the repaired mesh.
  std::vector<std::string> notes;  ///< Changes made, one sentence each.
};
/// Repairs a mesh if it is inward as a whole, and returns others as they are.
RepairedMesh repaired(TriMesh mesh);

}  // namespace hydro

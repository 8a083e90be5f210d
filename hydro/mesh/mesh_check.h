#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// Whether a triangle mesh bounds a solid: closed, two faces an edge, turned one way, outward.
///
/// Vertices must be shared between faces (see weld.h); what lies apart in the mesh is apart here.
/// A mesh may have several closed parts: side by side, or inside each other. A part inside another
/// bounds a cavity and must be turned inward, a part in that cavity outward, and so on.

namespace hydro {

/// What is wrong with a mesh, and where first. Counts are zero for a sound solid.
struct MeshReport {
  struct Finding {
    Eigen::Index count = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< A point of the first one, mesh frame [m].
  };
  Finding not_finite;         ///< Vertices with an infinite or undefined coordinate.
  Finding open_edges;         ///< Edges with one face.
  Finding crowded_edges;      ///< Edges with more than two faces.
  Finding misoriented_edges;  ///< Edges whose two faces are turned against each other.
  Finding degenerate_faces;   ///< Faces without area: flatter than 1e-12 of their longest edge.
  Finding duplicate_faces;    ///< Faces with the same three vertices as an earlier one.
  Finding self_overlaps;      ///< Pairs of faces that cut through each other (mesh_overlap.h).
  Finding
      misturned_parts;  ///< Closed parts turned against the rest: a solid counted twice or less.
  bool inward = false;  ///< Closed and consistent, but normals point into the solid.
  bool empty = false;   ///< Closed, but encloses nothing.
  double volume = 0;    ///< Signed by the orientation [m^3]; 0 unless closed and finite.

  bool closed() const { return open_edges.count == 0 && crowded_edges.count == 0; }
  bool sound() const;  ///< Nothing is wrong.
};

/// Checks a mesh. Where vertices are not finite only what needs no coordinates is looked at; parts
/// are looked at if the faces fit together and do not cut each other.
/// @throws std::invalid_argument if a face names a vertex that does not exist.
MeshReport check_mesh(const TriMesh& mesh);

/// One sentence a fault, in plain words with count and place; empty for a sound solid.
std::vector<std::string> describe(const MeshReport& report);

/// A mesh after the one repair that has only one right answer: a mesh that is turned inward as a
/// whole is turned outward.
struct RepairedMesh {
  TriMesh mesh;
  MeshReport report;               ///< Of the mesh as it is here.
  std::vector<std::string> notes;  ///< What was changed, one sentence each.
};
RepairedMesh repaired(TriMesh mesh);

}  // namespace hydro

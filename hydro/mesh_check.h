#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hydro/mesh.h"

/// @file
/// Whether a triangle mesh bounds a solid: closed, two faces an edge, turned one way, outward.

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
  Finding degenerate_faces;   ///< Faces without area.
  Finding duplicate_faces;    ///< Faces with the same three vertices as an earlier one.
  Finding self_overlaps;      ///< Pairs of faces that cut through each other.
  bool inward = false;        ///< Closed and consistent, but normals point into the solid.
  double volume = 0;          ///< Signed by the orientation [m^3].

  bool closed() const { return open_edges.count == 0 && crowded_edges.count == 0; }
};

MeshReport check_mesh(const TriMesh& mesh);

/// One sentence a fault, in plain words with count and place; empty for a sound solid.
std::vector<std::string> describe(const MeshReport& report);

}  // namespace hydro

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// Where the faces of two meshes cut each other.

namespace hydro {

/// A point of the cut on an edge of a face.
struct EdgePoint {
  int vertex = 0;       ///< In CutFaces::vertices.
  int side = 0;         ///< The edge from corner `side` of the face to the next.
  double at = 0;        ///< Share of the edge before it, from that corner.
  bool enters = false;  ///< True if the edge enters the other mesh there.
};

/// The cut through a face.
struct FaceCut {
  std::vector<EdgePoint> edge_points;        ///< Ascending around the face.
  std::vector<std::array<int, 2>> segments;  ///< From, to: the other mesh is on their left.
};

/// Two meshes, one behind the other, with all points of the cut.
struct CutFaces {
  std::vector<Eigen::Vector3d> vertices;  ///< Vertices of the first, of the second, of the cut.
  std::vector<FaceCut> cuts;              ///< Per face of both.
};

/// Finds the cut of two closed meshes. @return none if they are not in general position: if a
/// vertex of one lies on a face of the other, or two edges meet.
/// @param both    The faces and vertices of the first mesh, then those of the second.
/// @param first   Number of faces of the first.
std::optional<CutFaces> cut_faces(const TriMesh& both, int first);

}  // namespace hydro

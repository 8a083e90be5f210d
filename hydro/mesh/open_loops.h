#pragma once

#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// The open edges of a mesh, traced into closed lines.

namespace hydro {

/// Shape of an open loop.
enum class LoopShape {
  flat,  ///< In a plane, to a thousandth of its extent.
  bent,  ///< Not in a plane.
  line   ///< On itself, there and back: it encloses no area, as a crack does.
};

/// A closed line of open edges that visits no vertex twice.
struct OpenLoop {
  /// Vertices in the order in which a face that fills the loop would name them.
  std::vector<int> vertices;
  int face = 0;  ///< A face with an edge on the loop.
  LoopShape shape = LoopShape::flat;
  double length = 0;                                 ///< [m]
  double area = 0;                                   ///< Area of its projection on its plane [m^2].
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< Mean of its vertices [m].
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< Axis about which it is counter-clockwise.
  double off_plane = 0;  ///< Largest distance of a vertex from the plane through the middle [m].
  double extent = 0;     ///< Longest side of the box around it [m].
};

struct OpenBorder {
  std::vector<OpenLoop> loops;
  Eigen::Index loose_edges = 0;  ///< Open edges that no loop has, for lack of consistent faces.
};

/// Traces the open edges. The faces of a part must be oriented consistently, vertices be finite.
OpenBorder open_border(const TriMesh& mesh);

/// Returns the vertices on open edges, ascending.
std::vector<int> open_vertices(const TriMesh& mesh);

}  // namespace hydro

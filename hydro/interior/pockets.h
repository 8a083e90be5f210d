#pragma once

#include <cmath>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// The hollows of a body: parts of its surface on which water can stand apart from the sea.
///
/// A connected part of the surface below a level encloses either water (its walls look up and in)
/// or the body (they look down and out). The parts below all levels form a tree, whose vertices are
/// visited from the lowest to the highest: at a local minimum a part begins, at a saddle two parts
/// meet. A part that encloses water is a pocket up to the saddle at which it meets the outside, its
/// spill height; one that is enclosed by a pocket, as a bracket that hangs into it, is a part of
/// it. Which of the two encloses the other shows in the areas of their sections A(s) at the saddle:
/// that of a pocket is positive, that of a body negative, and the larger one encloses the smaller
/// one. With the volumes V(s) = ∫ A ds they follow from sums over the faces of each part, piecewise
/// cubic in the height s.
///
/// Two pockets that meet stay apart. Above their spill heights pockets grow on by the watershed: a
/// vertex belongs where its lowest neighbour belongs, a face where its lowest vertex does. So
/// sills, the edges between pockets and to the sea, are the crests that water passes over. Closed
/// parts of the mesh that turn their faces inward, voids, are pockets that never spill.
///
/// Only the direction of the vertical counts, neither the sea nor the body's height in it.

namespace hydro {

/// Stands for the sea where a pocket is expected.
inline constexpr int kSea = -1;

/// A hollow in one attitude. Heights are along `up` above the origin of the mesh [m].
struct Pocket {
  std::vector<int> faces;  ///< Ascending.
  int lowest = 0;          ///< Its lowest vertex.
  double floor = 0;        ///< Height of that vertex.
  double spill = 0;        ///< Height above which it overflows; infinite for a void.
  double capacity = 0;     ///< Volume below the spill height; of a void, its whole volume [m^3].

  /// True for a pocket without sills, in any attitude.
  bool is_void() const { return !std::isfinite(spill); }
};

/// An edge between two pockets, or a pocket and the sea, over which water passes.
struct SillEdge {
  int pocket = 0;        ///< Index of a pocket.
  int other = kSea;      ///< Greater than `pocket`, or kSea.
  int from = 0, to = 0;  ///< Vertices of the mesh.
};

/// All pockets of a mesh in one attitude.
struct Pockets {
  std::vector<Pocket> pockets;      ///< Ascending by their lowest vertex.
  std::vector<SillEdge> sills;      ///< By (pocket, other).
  std::vector<int> pocket_of_face;  ///< kSea for faces of the outside; empty without pockets.
};

/// The pockets of a closed mesh whose vertical is the unit vector `up`, given in the mesh's frame.
/// Pockets that hold less than kLeastPocket of the volume of the box around the mesh count as the
/// outside, and a pocket that holds less than kLeastPart of another one when they meet is a part of
/// it. The time is O(n log n).
Pockets find_pockets(const TriMesh& mesh, const Eigen::Vector3d& up);

/// True if all edges are convex, so that the mesh has no pocket in any attitude.
bool is_convex(const TriMesh& mesh);

}  // namespace hydro

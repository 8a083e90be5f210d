#pragma once

#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mesh.h"

/// @file
/// Faces of one mesh that cut through each other.
///
/// A pair is found if an edge of one face passes through the inside of the other, or if the two lie
/// in one plane, turned the same way, with a common area; both by more than a margin of 1e-6 of the
/// mesh's size. The margin is eight times the resolution of the floats that mesh files hold, so
/// parts that only touch, and neighbours along an edge, are never taken for a pair; shallower cuts
/// are missed. Of faces that crowd at one place no more pairs are looked at than
/// FaceTree::most_pairs().

namespace hydro {

struct Overlaps {
  Eigen::Index count = 0;                           ///< Pairs found.
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< A point of the first pair [m].
};

/// Vertices must be finite; `tree` must be of this mesh.
Overlaps find_overlaps(const TriMesh& mesh, const FaceTree& tree);

}  // namespace hydro

#pragma once

#include <utility>
#include <vector>

#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mesh.h"

/// @file
/// Faces of one mesh that cut through each other.
///
/// A pair is found if an edge of one face passes through the interior of the other, or if the two
/// faces are coplanar, oriented alike and share an area; either overlap must exceed a margin of
/// 1e-6 of the mesh's size. The margin is eight times the resolution of the floats in mesh files,
/// so parts that only touch and neighbours along an edge are never reported; shallower cuts are
/// missed. Where faces crowd, at most FaceTree::most_pairs() pairs are examined per leaf.

namespace hydro {

struct Overlaps {
  Eigen::Index count = 0;                           ///< Pairs found.
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< A point of the first pair [m].
};

/// Finds the overlaps. Vertices must be finite; `tree` must belong to this mesh.
Overlaps find_overlaps(const TriMesh& mesh, const FaceTree& tree);

/// Returns the pairs of parts that cut through each other, ascending, the lower part first.
/// @param part_of_face   Part of each face; negative: none.
std::vector<std::pair<int, int>> overlapping_parts(const TriMesh& mesh, const FaceTree& tree,
                                                   const std::vector<int>& part_of_face);

}  // namespace hydro

#pragma once

#include <optional>
#include <vector>

#include "hydro/mesh/face_tree.h"
#include "hydro/mesh/mesh.h"

/// @file
/// The union of closed meshes that lie apart or touch.
///
/// Surfaces touch where they lie within 1e-6 of the size of both meshes together, the margin of
/// mesh_overlap.h. Where two faces of different meshes touch with opposite normals there is no
/// surface of the union: the common area is cut out of both, and the rest is joined along its
/// outline. Meshes that touch in points or along edges only remain separate parts.

namespace hydro {

/// The part that two solids have in common.
struct CommonPart {
  Eigen::AlignedBox3d box;  ///< Around it [m].

  /// The axis along which the least shift separates the two, and that shift [m].
  int axis() const;
  double depth() const { return box.sizes()[axis()]; }
};

/// Finds what two closed meshes, whose normals point outward, have in common; none if they lie
/// apart, touch, or one lies in a cavity of the other.
std::optional<CommonPart> common_part(const TriMesh& a, const TriMesh& b);

/// Puts the vertices and faces of meshes behind each other in one, without joining them.
TriMesh side_by_side(const std::vector<TriMesh>& parts);

/// Returns the union of closed meshes that have nothing in common. Shapes that touch along an edge
/// and in a face at once may give a mesh that check_mesh faults.
TriMesh joined(const std::vector<TriMesh>& parts);

}  // namespace hydro

#pragma once

#include <Eigen/Core>
#include <array>

#include "hydro/mesh/mesh.h"

/// @file
/// The part of a triangle where a linear function is positive: the wet part of a panel (depth > 0)
/// or the part that moves into the water (v·n > 0).

namespace hydro {

/// Vertices of a triangular panel [m], counter-clockwise when seen from the water, relative to the
/// body's centre of mass in W axes: a body far from the origin loses no digits.
using Panel = std::array<Eigen::Vector3d, 3>;

/// A triangle with the values of a linear function at its vertices, none of them negative.
struct PanelPart {
  Panel panel = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
};

/// At most two triangles.
struct PanelParts {
  std::array<PanelPart, 2> part;
  int count = 0;

  const PanelPart* begin() const { return part.data(); }
  const PanelPart* end() const { return part.data() + count; }
};

/// Cuts `panel` where the linear function with the given vertex values is zero and returns the
/// positive side. A vertex made by the cut has the value zero.
///
/// An edge is always cut from its positive end to its negative one, so two panels that share it
/// get the same point to the last bit and the positive side of a closed mesh has no cracks. No
/// tolerance is used: slivers may come out, which is harmless for integrals.
PanelParts positive_part(const Panel& panel, const Eigen::Vector3d& value);

/// Area times outward unit normal [m^2].
Eigen::Vector3d area_vector(const Panel& panel);

/// The corners of a face.
inline Panel panel_of(const TriMesh& mesh, Eigen::Index face) {
  const auto corner = mesh.faces.col(face);
  return {mesh.vertices.col(corner[0]), mesh.vertices.col(corner[1]), mesh.vertices.col(corner[2])};
}

}  // namespace hydro

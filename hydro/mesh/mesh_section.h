#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/mesh/mesh.h"

namespace hydro {

/// A closed curve in which a plane cuts a mesh: 2×N, counter-clockwise about the solid when seen
/// from the positive side of the plane, clockwise about a void [m].
using SectionLoop = Eigen::Matrix2Xd;

/// Cuts a closed mesh by the plane on which coordinate `axis` is `at` [m]. The points are in the
/// two coordinates that follow the axis in cyclic order. A vertex on the plane counts as beyond it,
/// so each loop is closed. Empty where the plane misses the mesh.
std::vector<SectionLoop> mesh_section(const TriMesh& mesh, int axis, double at);

/// Area that a loop encloses, negative about a void [m^2].
double enclosed_area(const SectionLoop& loop);

/// The loop without the points that lie within `tolerance` [m] of the line between their
/// neighbours.
SectionLoop simplified(const SectionLoop& loop, double tolerance);

}  // namespace hydro

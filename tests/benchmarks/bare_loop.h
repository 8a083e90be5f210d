#pragma once

#include <array>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/spatial.h"

/// @file
/// The floor that the kernel is measured against: a plain vectorised loop over all triangles, with
/// buoyancy and pressure drag by their closed forms and nothing else. It cuts nothing and looks at
/// nothing, so its result is right for a wholly submerged body whose panels do not turn only; its
/// cost is that of reading the triangles and doing the arithmetic.

namespace bench {

/// Vertices of triangles, numbers of one kind side by side [m]. The count is a multiple of 8; what
/// fills it up has no area.
struct BareTriangles {
  explicit BareTriangles(const hydro::TriMesh& mesh_B);
  std::array<std::array<std::vector<double>, 3>, 3> r;  ///< Vertex, axis.
  std::size_t count = 0;
};

/// Force and moment of buoyancy, then of pressure drag, both without their coefficients.
std::array<double, 12> bare_loop(const BareTriangles& triangles, const Eigen::Vector3d& up,
                                 double below, const hydro::Twist& motion);

}  // namespace bench

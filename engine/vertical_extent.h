#pragma once

#include "engine/spec.h"

namespace engine {

/// Heights that bound a body [m].
struct VerticalExtent {
  double lowest;  ///< z of the lowest point.
  double height;
};

/// Extent of a box in B, which bounds the mesh, for a body in a state.
VerticalExtent vertical_extent(const Eigen::AlignedBox3d& box_B, const hydro::BodyState& state);

/// z of the lowest point of the box [m].
double lowest_point(const Eigen::AlignedBox3d& box_B, const hydro::BodyState& state);

}  // namespace engine

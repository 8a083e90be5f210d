#pragma once

#include "engine/spec.h"

namespace engine {

/// True if the water can move the body: it is wet, can move, and has a coefficient that is not
/// zero.
bool feels_water(const BodySpec& spec);

/// A box from below upwards [m].
struct VerticalExtent {
  double lowest;  ///< z of its lowest point.
  double height;
};

/// Of a box in B, for a body in the given state. No point of a mesh that lies in the box is beyond.
VerticalExtent vertical_extent(const Eigen::AlignedBox3d& box_B, const hydro::BodyState& state);

/// Its lowest point alone [m].
double lowest_point(const Eigen::AlignedBox3d& box_B, const hydro::BodyState& state);

}  // namespace engine

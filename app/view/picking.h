#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/view/orbit.h"
#include "engine/pull.h"
#include "engine/spec.h"

/// @file
/// Bodies under the mouse, and the hand that draws them.

namespace app {

/// The first point of a body that a ray meets, from either side of its triangles.
struct Hit {
  engine::BodyId body = 0;
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();  ///< [m]
  double depth = 0;                                ///< Along the camera's view [m].
};

/// @param states   In the order of the bodies.
std::optional<Hit> first_hit(const Ray& ray, const std::vector<engine::BodySpec>& bodies,
                             const std::vector<hydro::BodyState>& states);

/// What the point that was taken hold of is drawn with: to the mouse's place in the plane that
/// faces the camera as far off as it was then.
/// @param ray   Of the mouse now.
engine::Pull pull_towards(const Hit& held, const Ray& ray);

}  // namespace app

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/view/orbit.h"
#include "engine/base/spec.h"
#include "engine/motion/pull.h"

/// @file
/// Picking of bodies with the mouse, and the pull on a picked body.

namespace app {

/// First point of a body on a ray. Triangles are hit from both sides.
struct Hit {
  engine::BodyId body = 0;
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();  ///< [m]
  double depth = 0;  ///< Distance along the camera's viewing direction [m].
};

/// @param states   States in the order of the bodies.
std::optional<Hit> first_hit(const Ray& ray, const std::vector<engine::BodySpec>& bodies,
                             const std::vector<hydro::BodyState>& states);

/// Returns the pull on the held point towards the mouse's point in the plane that faces the camera
/// at the depth of the hit.
/// @param ray   Present ray of the mouse.
engine::Pull pull_towards(const Hit& held, const Ray& ray);

}  // namespace app

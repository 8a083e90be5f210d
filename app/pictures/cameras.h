#pragma once

#include <vector>

#include "app/assembly/built_scene.h"
#include "app/pictures/shot_spool.h"
#include "app/render/renderer.h"
#include "app/scene/scene.h"

/// @file
/// Cameras of a scene.

namespace app {

/// Returns the scene's `cameras`, or else its `camera` alone, which has no name since its files
/// need none.
std::vector<scene::Camera> cameras_of(const scene::Render& render);

/// Returns a camera at time 0. A place that the scene does not give is such that all bodies are
/// seen at their start.
render::Camera camera_at_start(const scene::Camera& camera, const assembly::BuiltScene& built);

/// Returns a camera at the time of a shot. A camera that follows a body is displaced as far as the
/// body's centre of mass from its start; one on a body moves and turns with it. An orbiting camera
/// turns about the vertical, or the body's z axis, through the point it looks at.
render::Camera camera_at(const scene::Camera& camera, const assembly::BuiltScene& built,
                         const Shot& shot);

}  // namespace app

#pragma once

#include <vector>

#include "app/pictures/shot_spool.h"
#include "app/render/renderer.h"
#include "app/scene/scene.h"
#include "engine/spec.h"

/// @file
/// Where the cameras of a scene are.

namespace app {

/// Those that draw: `cameras`, or else `camera` alone. A single one has no name, since its files
/// need none.
std::vector<scene::Camera> cameras_of(const scene::Render& render);

/// The view at a time. A camera that follows a body has moved by as much as the body's centre of
/// mass has from where it starts; one that orbits has turned about the vertical through the point
/// it looks at.
render::Camera camera_at(const scene::Camera& camera, const engine::SimulationSpec& spec,
                         const Shot& shot);

}  // namespace app

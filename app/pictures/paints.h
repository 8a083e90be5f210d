#pragma once

#include <memory>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/render/body_appearance.h"
#include "app/scene/scene.h"

namespace app {

/// Returns for each body the colours of its mesh file (mesh_paint.h); null for a body whose scene
/// gives it a `color`, or whose shape is no mesh file with colours.
std::vector<std::shared_ptr<const render::Paint>> paints_of(const scene::Scene& scene,
                                                            const assembly::BuiltScene& built);

}  // namespace app

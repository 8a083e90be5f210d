#pragma once

#include <vector>

#include "app/logs/interior_csv.h"
#include "app/render/renderer.h"
#include "engine/base/spec.h"
#include "engine/hollows/interior_water.h"

namespace app {

/// How the hollows of a body are drawn.
render::Hollows hollows_of(const engine::BodySpec& body);

/// The water in the hollows of all bodies, as it is drawn.
render::Interiors drawn_interiors(const std::vector<engine::InteriorState>& interiors);

/// The same at a logged time. Bodies without rows at that time are dry.
render::Interiors drawn_interiors(const InteriorLog& log, const engine::SimulationSpec& spec,
                                  double time);

}  // namespace app

#pragma once

#include <optional>

#include "app/assembly/build_shape.h"
#include "app/assembly/built_scene.h"
#include "hydro/sea.h"

namespace assembly {

/// Returns the sea of a scene. Faults and notes go to the log.
/// @param irregular   Filled for irregular waves.
hydro::Sea build_sea(const scene::Water& water, double gravity,
                     std::optional<IrregularSea>& irregular, BuildLog& log);

}  // namespace assembly

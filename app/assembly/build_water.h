#pragma once

#include "app/assembly/built_scene.h"
#include "app/base/reporter.h"
#include "app/scene/scene.h"

/// @file
/// Builds simulated water that bodies feel.

namespace assembly {

/// Gives the scene the grid of its simulated water, and the hulls that `radiation_choices` has
/// chosen their sources in it. A hull that is narrower than a cell has none and feels no waves,
/// which a warning tells. Nothing happens without `water.simulated: {}`.
/// @throws InputError where a given grid does not suit the scene
void add_simulated_water(const scene::Scene& scene, BuiltScene& built, app::Reporter& reporter);

/// The grid for hulls that float in a scene.
/// @param hulls   For each body; none: it is no hull.
engine::WaterGrid water_grid(const scene::SimulatedWater& given, const engine::SimulationSpec& spec,
                             const std::vector<RadiationChoice>& choices);

}  // namespace assembly

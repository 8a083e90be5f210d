#pragma once

#include <optional>

#include "app/scene/scene.h"
#include "engine/base/spec.h"
#include "hydro/water/simulated_water.h"

namespace app {

/// The waves that the bodies of a scene make in its pictures; none if the scene asks for none or no
/// body can move the water.
/// @param spec   It must outlive what is returned.
std::optional<hydro::SimulatedWater> bodies_waves(const scene::Scene& scene,
                                                  const engine::SimulationSpec& spec);

/// The size of their cells [m]; 0 if there are none.
double cell_of_waves(const scene::Scene& scene, const engine::SimulationSpec& spec);

}  // namespace app

#pragma once

#include "app/pictures/shot_spool.h"
#include "app/render/color_scale.h"
#include "app/scene/render.h"
#include "engine/spec.h"

/// @file
/// The ends of a pressure scale that suits a sequence of pictures.

namespace app {

struct PressureRange {
  double lowest = 0, highest = 0;  ///< [Pa]

  void include(double pressure);
};

/// Over the bodies' wetted vertices, and 0.
PressureRange pressure_range(const engine::SimulationSpec& spec, const Shot& shot,
                             scene::ShownPressure shows);

/// The scale that a scene asks for; ends that are to be found hold the range, at round values.
render::PressureScale pressure_scale(const scene::Render& look, const PressureRange& range);

/// The same, over all shots.
render::PressureScale pressure_scale(const scene::Render& look, const engine::SimulationSpec& spec,
                                     const ShotSpool& shots);

}  // namespace app

#pragma once

#include "app/pictures/shot_spool.h"
#include "app/render/color_scale.h"
#include "app/scene/render.h"
#include "engine/spec.h"

/// @file
/// Ends of a pressure scale for a sequence of pictures.

namespace app {

struct PressureRange {
  double lowest = 0, highest = 0;  ///< [Pa]

  void include(double pressure);
};

/// Returns the range of pressures over the bodies' wetted vertices, with 0 included.
PressureRange pressure_range(const engine::SimulationSpec& spec, const Shot& shot,
                             scene::ShownPressure shows);

/// Returns the scale that a scene asks for. Automatic ends are round values that enclose the range.
render::PressureScale pressure_scale(const scene::Render& look, const PressureRange& range);

/// Returns the scale for the pressures in all shots.
render::PressureScale pressure_scale(const scene::Render& look, const engine::SimulationSpec& spec,
                                     const ShotSpool& shots);

}  // namespace app

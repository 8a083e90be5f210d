#pragma once

#include "app/pictures/shot_spool.h"
#include "app/render/color_scale.h"
#include "app/scene/render.h"
#include "engine/base/spec.h"

/// @file
/// Ends of a pressure scale for a sequence of pictures.

namespace app {

struct PressureRange {
  double lowest = 0, highest = 0;  ///< [Pa]

  void include(double pressure);
  void include(const PressureRange& other);
};

/// Returns the range of pressures over the bodies' wetted vertices, with 0 included.
PressureRange pressure_range(const engine::SimulationSpec& spec, const Shot& shot,
                             scene::ShownPressure shows);

/// Returns the range of pressures in all shots.
PressureRange pressure_range(const engine::SimulationSpec& spec, const ShotSpool& shots,
                             scene::ShownPressure shows);

/// Returns the scale that a scene asks for, which marks its ends if pictures go beyond them. Ends
/// that are not given are round values that enclose their range; a diverging scale is centred at
/// zero by its other end, or by the larger of both.
/// @param expected   Range for `auto`, of `expected_pressure`.
/// @param drawn      Range of the pictures, for `drawn`.
render::PressureScale pressure_scale(const scene::Render& look, const PressureRange& expected,
                                     const PressureRange& drawn);

}  // namespace app

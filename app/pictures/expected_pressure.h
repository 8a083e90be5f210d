#pragma once

#include "app/pictures/pressure_range.h"
#include "app/scene/render.h"
#include "engine/base/spec.h"

namespace app {

/// Returns the pressures to expect on the wet surfaces of a scene, with 0 included, from the scene
/// alone: the scale of its pictures then depends neither on their times nor on how a run goes.
///
/// The water above the deepest point is that of the body as it floats at the orientation of the
/// start, as it starts, or wholly dived after a fall; of a body that sinks, that down to the ground
/// or to its height twice. A body with a joint neither floats nor sinks, and an immovable one or
/// one with a fixed joint stays where it starts. Waves add √2 of their root sum square, to what
/// floats not more than its freeboard. The dynamic pressure is ½ ρ C_p v² with the speed of the
/// start, of the fall to the water, of the water in waves, or √(g L)/4 for a body of length L,
/// whichever is largest.
PressureRange expected_pressure(const engine::SimulationSpec& spec, scene::ShownPressure shows);

}  // namespace app

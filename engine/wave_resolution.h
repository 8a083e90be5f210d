#pragma once

#include <optional>
#include <string>

#include "engine/body.h"

namespace engine {

/// Says that the step is too long for the waves that a body in this state meets, if it is: for a
/// wave of at least a tenth of the largest amplitude that passes a body in the water in less than
/// kStepsPerWave steps. With fewer the wave's load is more than a fifth off, (2π/8)²/3, between the
/// instants at which it is found.
std::optional<std::string> wave_resolution_warning(const Body& body, const hydro::BodyState& state,
                                                   const Environment& environment, double step);

}  // namespace engine

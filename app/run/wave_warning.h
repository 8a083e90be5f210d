#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/spec.h"

namespace app {

/// Steps per period of encounter below which a wave is not resolved [-]. With fewer the wave's load
/// is more than a fifth off, (2π/8)²/3, between the instants at which it is found.
inline constexpr double kStepsPerWave = 8;

/// Returns a warning if the step is too long for the waves that bodies in these states meet: if a
/// wave of at least a tenth of the largest amplitude passes a body in the water in less than
/// kStepsPerWave steps.
std::optional<std::string> wave_warning(const engine::SimulationSpec& spec,
                                        const std::vector<hydro::BodyState>& states);

}  // namespace app

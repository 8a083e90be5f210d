#pragma once

#include <optional>
#include <string>

#include "engine/body.h"

namespace engine {

/// Fewest steps in the period at which a body meets a wave. With fewer the wave's load is more than
/// a fifth off, (2π/8)²/3, between the instants at which it is found.
inline constexpr double kStepsAPeriod = 8;

/// Says that the step is too long for the waves that a body meets, if it is: for a wave of at least
/// a tenth of the largest amplitude that passes a body in the water in less than kStepsAPeriod
/// steps.
std::optional<std::string> encounter_warning(const Body& body, const Surroundings& around,
                                             double step);

}  // namespace engine

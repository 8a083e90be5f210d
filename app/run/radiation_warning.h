#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/spec.h"

namespace app {

/// Largest angle from the mean pose up to which a body's waves are told to some accuracy [rad].
inline constexpr double kLargestTilt = 30 * std::numbers::pi / 180;

/// Returns a warning if a body with radiation is turned further than kLargestTilt from its mean
/// pose in these states, as one that capsizes.
/// Spheres about their centres may turn.
std::optional<std::string> radiation_warning(const engine::SimulationSpec& spec,
                                             const std::vector<hydro::BodyState>& states);

}  // namespace app

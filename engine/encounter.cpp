#include "engine/encounter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/wetness.h"

namespace engine {

std::optional<std::string> encounter_warning(const Body& body, const Surroundings& around,
                                             double step) {
  const auto* waves = around.sea ? std::get_if<hydro::WaveSurface>(&around.sea->surface) : nullptr;
  if (!waves || !body.wet || lowest_point(body.box_B, body.motion.state) >= around.highest)
    return std::nullopt;
  double largest = 0;
  for (const hydro::WaveComponent& wave : waves->components)
    largest = std::max(largest, std::abs(wave.amplitude));
  const Eigen::Vector3d& v = body.motion.state.linear_velocity;
  for (const hydro::WaveComponent& wave : waves->components) {
    const double frequency = std::abs(wave.omega - wave.kx * v.x() - wave.ky * v.y());
    const double period = 2 * std::numbers::pi / frequency;
    if (std::abs(wave.amplitude) < 0.1 * largest || period >= kStepsAPeriod * step) continue;
    return fmt::format(
        "body '{}' meets a wave every {:.3g} s, {:.2g} steps of {:.3g} s: a step below {:.2g} s "
        "would resolve it",
        body.spec->name, period, period / step, step, period / kStepsAPeriod);
  }
  return std::nullopt;
}

}  // namespace engine

#include "engine/wave_resolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/constants.h"

namespace engine {

std::optional<std::string> wave_resolution_warning(const Body& body, const hydro::BodyState& state,
                                                   const Environment& environment, double step) {
  const auto* waves =
      environment.sea ? std::get_if<hydro::WaveSurface>(&environment.sea->surface) : nullptr;
  if (!waves || !body.wet || !may_be_wet(body, environment, state)) return std::nullopt;
  double largest = 0;
  for (const hydro::WaveComponent& wave : waves->components)
    largest = std::max(largest, std::abs(wave.amplitude));
  const Eigen::Vector3d& v = state.linear_velocity;
  for (const hydro::WaveComponent& wave : waves->components) {
    const double frequency = std::abs(wave.omega - wave.kx * v.x() - wave.ky * v.y());
    const double period = 2 * std::numbers::pi / frequency;
    if (std::abs(wave.amplitude) < 0.1 * largest || period >= kStepsPerWave * step) continue;
    return fmt::format(
        "body '{}' meets a wave every {:.3g} s, {:.2g} steps of {:.3g} s: a step below {:.2g} s "
        "would resolve it",
        body.spec->name, period, period / step, step, period / kStepsPerWave);
  }
  return std::nullopt;
}

}  // namespace engine

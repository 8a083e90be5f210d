#include "app/run/wave_warning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/motion/locks.h"

namespace app {
namespace {

/// Part of the largest amplitude below which a wave is left out.
constexpr double kLeastAmplitude = 0.1;

/// Returns the period of the first wave that a body with this velocity meets in less than
/// `shortest` [s]; 0 if there is none.
double too_short_a_period(const hydro::WaveSurface& waves, const Eigen::Vector3d& v,
                          double shortest) {
  double largest = 0;
  for (const hydro::WaveComponent& wave : waves.components)
    largest = std::max(largest, std::abs(wave.amplitude));
  for (const hydro::WaveComponent& wave : waves.components) {
    const double frequency = std::abs(wave.omega - wave.kx * v.x() - wave.ky * v.y());
    const double period = 2 * std::numbers::pi / frequency;
    if (std::abs(wave.amplitude) >= kLeastAmplitude * largest && period < shortest) return period;
  }
  return 0;
}

/// Returns true if the water may reach the body and acts on it.
bool is_wet(const engine::BodySpec& body, const hydro::BodyState& state, const hydro::Sea& sea) {
  if (!body.wet || hydro::no_load(body.coefficients) || engine::immovable(body.locked))
    return false;
  const Eigen::RowVector3d up = state.orientation.toRotationMatrix().row(2);
  const double lowest = state.position.z() + (up * body.mesh_B.vertices).minCoeff();
  return lowest < hydro::surface_bounds(sea).highest;
}

}  // namespace

std::optional<std::string> wave_warning(const engine::SimulationSpec& spec,
                                        const std::vector<hydro::BodyState>& states) {
  const auto* waves = spec.sea ? std::get_if<hydro::WaveSurface>(&spec.sea->surface) : nullptr;
  if (!waves) return std::nullopt;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double period =
        too_short_a_period(*waves, states[i].linear_velocity, kStepsPerWave * spec.step);
    if (period == 0 || !is_wet(spec.bodies[i], states[i], *spec.sea)) continue;
    return fmt::format(
        "body '{}' meets a wave every {:.3g} s, {:.2g} steps of {:.3g} s: a step below {:.2g} s "
        "would resolve it",
        spec.bodies[i].name, period, period / spec.step, spec.step, period / kStepsPerWave);
  }
  return std::nullopt;
}

}  // namespace app

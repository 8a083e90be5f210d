#include <cmath>

#include "app/pages/packing.h"
#include "app/pictures/expected_pressure.h"
#include "app/report/page_data.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

/// Number of rows in which pressures are looked for.
constexpr std::size_t kPressureRows = 100;

/// Returns the range of pressures in rows spread over the run.
PressureRange logged_pressures(const LoggedRun& run, scene::ShownPressure shows) {
  PressureRange range;
  for (std::size_t i = 0; i < std::min(run.rows, kPressureRows); ++i) {
    const std::size_t row = i * (run.rows - 1) / std::max<std::size_t>(kPressureRows - 1, 1);
    Shot shot{.time = run.trajectory.tracks.begin()->second.times[row], .states = {}};
    for (const scene::Body& body : run.scene.bodies)
      shot.states.push_back(run.trajectory.tracks.at(body.name).states[row]);
    range.include(pressure_range(run.built.spec, shot, shows));
  }
  return range;
}

/// Returns the mean wave number of linear waves by their energy [1/m]; 0 where the pressure is that
/// of the depth.
double mean_wave_number(const hydro::Sea& sea) {
  const auto* waves = std::get_if<hydro::WaveSurface>(&sea.surface);
  if (!waves || waves->kinematics == hydro::Kinematics::hydrostatic) return 0;
  double sum = 0, weight = 0;
  for (const hydro::WaveComponent& wave : waves->components) {
    sum += wave.amplitude * wave.amplitude * std::hypot(wave.kx, wave.ky);
    weight += wave.amplitude * wave.amplitude;
  }
  return weight > 0 ? sum / weight : 0;
}

}  // namespace

Json page_pressure(const LoggedRun& run) {
  const engine::SimulationSpec& spec = run.built.spec;
  if (!spec.sea || run.scene.bodies.empty() || run.rows == 0) return nullptr;
  const scene::Render look = run.scene.render.value_or(scene::Render{});
  const render::PressureScale scale =
      pressure_scale(look, expected_pressure(spec, look.shows), logged_pressures(run, look.shows));
  const auto& colors = render::scale_colors(scale.colors);
  Json ticks = Json::array();
  for (const render::Tick& tick : render::round_ticks(scale))
    ticks.push_back({{"place", tick.place}, {"label", tick.label}});
  Json drags = Json::array();
  for (const engine::BodySpec& body : spec.bodies) {
    const Eigen::Matrix3d& K = body.coefficients.drag_shape;
    const auto& calibration = body.coefficients.calibration;
    // The factor depends on the motion; its mean over the axes is near enough for a colour.
    const double factor = calibration ? calibration->factor.mean() : 1;
    drags.push_back({factor * body.coefficients.pressure_drag.front,
                     factor * body.coefficients.pressure_drag.back, K(0, 0), K(1, 1), K(2, 2),
                     K(0, 1), K(0, 2), K(1, 2)});
  }
  const hydro::Sea& sea = *spec.sea;
  const bool dynamic = scale.shows == render::Pressure::dynamic;
  const bool hydrostatic = scale.shows == render::Pressure::hydrostatic;
  return {{"name", render::scale_name(scale.shows)},
          {"min", scale.min},
          {"max", scale.max},
          {"below", scale.below},
          {"above", scale.above},
          {"colors", packed<std::uint8_t>({&colors[0].r, 3 * colors.size()})},
          {"ticks", ticks},
          {"weight", dynamic ? 0 : sea.density * sea.gravity},
          {"half_density", hydrostatic ? 0 : 0.5 * sea.density},
          {"current", {sea.current.x(), sea.current.y(), sea.current.z()}},
          {"wave_number", mean_wave_number(sea)},
          {"drags", drags}};
}

}  // namespace app

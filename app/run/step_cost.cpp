#include "app/run/step_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "app/base/wall_clock.h"

namespace app {
namespace {

/// Wall time after which no more steps are taken, and after which the last one is left [s].
constexpr double kEnough = 0.1, kTooMuch = 0.25;

constexpr int kMostMeasured = 10;

/// Waves, triangles and loads of which fewer make a step dear [-].
constexpr std::size_t kManyWaves = 12;
constexpr Eigen::Index kManyTriangles = 10'000;
constexpr double kMostly = 0.5;

std::string keys_to_change(const StepCost& cost, const engine::SimulationSpec& spec) {
  Eigen::Index triangles = 0;
  for (const engine::BodySpec& body : spec.bodies) triangles += body.mesh_B.face_count();
  const auto* waves = spec.sea ? std::get_if<hydro::WaveSurface>(&spec.sea->surface) : nullptr;
  if (cost.loads < kMostly) return "a longer step takes less";
  if (waves && waves->components.size() >= kManyWaves)
    return "a larger hydro.wave_tolerance, fewer components of the spectrum or a longer step take "
           "less";
  if (triangles > kManyTriangles) return "coarser meshes or a longer step take less";
  return "a longer step takes less";
}

}  // namespace

std::optional<StepCost> measured_cost(engine::Simulation& simulation) {
  if (simulation.spec().bodies.empty()) return std::nullopt;
  const engine::SimulationState start = simulation.state();
  const engine::Timings before = simulation.timings();
  const WallClock clock;
  simulation.stop_if([&] { return clock.seconds() > kTooMuch; });
  StepCost cost{.seconds = kTooMuch, .at_least = true, .loads = 1};
  bool failed = false;
  try {
    // The least of two at least: the first step of a run is in short substeps.
    for (int i = 0; i < 2 || (i < kMostMeasured && clock.seconds() < kEnough); ++i) {
      const WallClock step;
      simulation.step();
      const double seconds = step.seconds();
      cost.seconds = cost.at_least ? seconds : std::min(cost.seconds, seconds);
      cost.at_least = false;
      const engine::Timings& t = simulation.timings();
      const double hydro = t.hydro - before.hydro;
      cost.loads = hydro / (hydro + t.collision - before.collision + t.engine - before.engine);
    }
  } catch (const engine::StepStopped&) {
  } catch (const engine::SimulationError&) {
    failed = true;
  }
  simulation.stop_if({});
  simulation.restore(start);
  return failed ? std::nullopt : std::optional(cost);
}

std::string cost_text(const StepCost& cost, const engine::SimulationSpec& spec) {
  const double speed = spec.step / cost.seconds;
  std::string text =
      fmt::format("{}{:.3g} ms a step, {}{} x real time", cost.at_least ? "more than " : "",
                  1e3 * cost.seconds, cost.at_least ? "less than " : "",
                  speed < 100 ? fmt::format("{:.2g}", speed) : fmt::format("{:.0f}", speed));
  if (!cost.at_least) text += fmt::format(", {:.0f} % of it loads", 100 * cost.loads);
  if (speed < 1) text += "; " + keys_to_change(cost, spec);
  return text;
}

}  // namespace app

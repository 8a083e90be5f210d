#include "app/pictures/bodies_waves.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/motion/locks.h"

namespace app {
namespace {

/// What each body moves the water with; empty if nothing does.
std::vector<hydro::WaterBody> movers_of(const scene::Scene& scene,
                                         const engine::SimulationSpec& spec) {
  if (!scene.water || scene.water->simulated == scene::SimulatedWater::none || !spec.sea) return {};
  const bool water_flows = hydro::changes_with_time(*spec.sea) || !spec.sea->current.isZero(0);
  std::vector<hydro::WaterBody> movers;
  for (const engine::BodySpec& body : spec.bodies) {
    hydro::WaterBody& mover = movers.emplace_back();
    if (!body.wet || (engine::immovable(body.locked) && !water_flows)) continue;
    mover.mesh_B = &engine::outside_B(body);
    mover.radius = mover.mesh_B->vertices.colwise().norm().maxCoeff();
  }
  const bool none = std::all_of(movers.begin(), movers.end(),
                                [](const auto& mover) { return mover.mesh_B == nullptr; });
  return none ? std::vector<hydro::WaterBody>() : movers;
}

hydro::PeriodicSquare square_about(const std::vector<hydro::WaterBody>& movers,
                                   const engine::SimulationSpec& spec) {
  std::vector<hydro::BodyState> start;
  for (const engine::BodySpec& body : spec.bodies) start.push_back(body.initial);
  return hydro::square_about(movers, start, *spec.sea);
}

}  // namespace

std::optional<hydro::SimulatedWater> bodies_waves(const scene::Scene& scene,
                                             const engine::SimulationSpec& spec) {
  std::vector<hydro::WaterBody> movers = movers_of(scene, spec);
  if (movers.empty()) return std::nullopt;
  const hydro::PeriodicSquare square = square_about(movers, spec);
  return hydro::SimulatedWater(*spec.sea, std::move(movers), square);
}

double cell_of_waves(const scene::Scene& scene, const engine::SimulationSpec& spec) {
  const std::vector<hydro::WaterBody> movers = movers_of(scene, spec);
  return movers.empty() ? 0 : square_about(movers, spec).cell;
}

}  // namespace app

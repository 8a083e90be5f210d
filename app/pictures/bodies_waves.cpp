#include "app/pictures/bodies_waves.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/motion/water_coupling.h"

namespace app {
namespace {

/// Moving surface of each body that makes waves; empty if none does.
std::vector<hydro::WaterBody> movers_of(const scene::Scene& scene,
                                        const engine::SimulationSpec& spec) {
  using Kind = scene::SimulatedWater::Kind;
  if (!scene.water || scene.water->simulated.kind == Kind::none || !spec.sea) return {};
  std::vector<hydro::WaterBody> movers = engine::bodies_in_water(spec);
  const bool none = std::all_of(movers.begin(), movers.end(),
                                [](const auto& mover) { return mover.mesh_B == nullptr; });
  return none ? std::vector<hydro::WaterBody>() : movers;
}

hydro::PeriodicSquare square_about(const std::vector<hydro::WaterBody>& movers,
                                   const engine::SimulationSpec& spec) {
  if (spec.water) return spec.water->square;
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
  return hydro::SimulatedWater(*spec.sea, std::move(movers), square,
                               spec.water ? spec.water->edge : 0);
}

double cell_of_waves(const scene::Scene& scene, const engine::SimulationSpec& spec) {
  const std::vector<hydro::WaterBody> movers = movers_of(scene, spec);
  return movers.empty() ? 0 : square_about(movers, spec).cell;
}

}  // namespace app

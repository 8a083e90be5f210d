#include "app/assembly/build_water.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "app/assembly/build_radiation.h"
#include "app/base/wall_clock.h"
#include "hydro/water/hull_sources.h"
#include "hydro/water/simulated_water.h"

namespace assembly {
namespace {

/// Cells over the breadth of the narrowest hull: its waves are then within some per cent of theory.
constexpr double kCellsOverBreadth = 4;

/// Side of the grid over the mean radius of the largest hull [-], beside what the bodies are apart:
/// three of the longest waves that its motions send out, and an edge of one.
constexpr double kSideOverRadius = 60;

constexpr int kFewestCells = 64, kMostCells = 512;

/// Horizontal sides of the hull's box, the shorter one first [m].
std::array<double, 2> sides_of(const RadiationChoice& choice, const engine::BodySpec& body) {
  const Eigen::Matrix3Xd at =
      choice.pose->orientation.toRotationMatrix() * radiating_mesh(choice, body).vertices;
  const Eigen::Vector3d sides = at.rowwise().maxCoeff() - at.rowwise().minCoeff();
  return {std::min(sides.x(), sides.y()), std::max(sides.x(), sides.y())};
}

/// Largest horizontal distance of two bodies in water [m].
double distance_apart(const engine::SimulationSpec& spec) {
  Eigen::Array2d low = Eigen::Array2d::Constant(HUGE_VAL), high = -low;
  for (const engine::BodySpec& body : spec.bodies) {
    if (!body.wet) continue;
    low = low.min(body.initial.position.head<2>().array());
    high = high.max(body.initial.position.head<2>().array());
  }
  return (high - low).maxCoeff();
}

/// A hull and its model, which bodies with equal meshes and mean poses share.
struct Known {
  const hydro::TriMesh* mesh_B;
  std::shared_ptr<const hydro::HullSources> sources;
  std::shared_ptr<const hydro::FloatingBody> model;
  double seconds;

  bool suits(const hydro::TriMesh& mesh, const hydro::MeanPose& pose) const {
    return sources->pose == pose && hydro::same_mesh(*mesh_B, mesh);
  }
};

Known make_known(const hydro::TriMesh& mesh_B, const hydro::MeanPose& pose,
                 const engine::SimulationSpec& spec) {
  const app::WallClock clock;
  auto sources = std::make_shared<const hydro::HullSources>(
      hydro::make_hull_sources(mesh_B, pose, spec.water->square));
  auto model = hydro::floating_hull(*sources, mesh_B, *spec.sea);
  return {&mesh_B, std::move(sources), std::move(model), clock.seconds()};
}

}  // namespace

engine::WaterGrid water_grid(const scene::SimulatedWater& given, const engine::SimulationSpec& spec,
                             const std::vector<RadiationChoice>& choices) {
  double narrowest = HUGE_VAL, largest = 0, draught = 0;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (!choices[i].pose) continue;
    const auto [breadth, length] = sides_of(choices[i], spec.bodies[i]);
    narrowest = std::min(narrowest, breadth);
    largest = std::max(largest, std::sqrt(breadth * length) / 2);
    draught = std::max(draught, choices[i].draught);
  }
  const double shortest = hydro::smallest_cell(spec.step, spec.sea->gravity);
  const double side = distance_apart(spec) + kSideOverRadius * largest;
  engine::WaterGrid grid{.square = {.cells = kFewestCells,
                                    .deepest = draught,
                                    .layers = 5,
                                    .gravity = spec.sea->gravity,
                                    .depth = spec.sea->depth},
                         .edge = given.edge.value_or(0)};
  double cell = given.spacing.value_or(std::max(shortest, narrowest / kCellsOverBreadth));
  if (given.size)
    grid.square.cells = (*given.size)[0];
  else
    while (grid.square.cells < kMostCells && grid.square.cells * cell < side)
      grid.square.cells *= 2;
  if (!given.spacing) cell = std::max(cell, side / grid.square.cells);
  grid.square.cell = cell;
  return grid;
}

void add_simulated_water(const scene::Scene& scene, BuiltScene& built, app::Reporter& reporter) {
  engine::SimulationSpec& spec = built.spec;
  std::vector<RadiationChoice> choices;
  for (const RadiationReport& report : built.radiation) choices.push_back(report.choice);
  if (std::ranges::none_of(choices, [](const auto& choice) { return choice.simulated; })) return;
  spec.water = water_grid(scene.water->simulated, spec, choices);
  std::vector<Known> known;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    RadiationReport& report = built.radiation[i];
    if (!report.choice.simulated) continue;
    engine::BodySpec& body = spec.bodies[i];
    const hydro::TriMesh& mesh_B = radiating_mesh(report.choice, body);
    const double breadth = sides_of(report.choice, body)[0];
    if (breadth < spec.water->square.cell) {
      report.choice.reason = fmt::format(
          "its breadth of {:.3g} m is less than a cell of the water, {:.3g} m: "
          "water.simulated.spacing sets it",
          breadth, spec.water->square.cell);
      report.choice.pose.reset();
      report.choice.simulated = false;
      reporter.warning(
          fmt::format("{} makes waves and feels none: {}", body.name, report.choice.reason));
      continue;
    }
    auto found = std::ranges::find_if(
        known, [&](const Known& k) { return k.suits(mesh_B, *report.choice.pose); });
    if (found == known.end())
      found = known.insert(known.end(), make_known(mesh_B, *report.choice.pose, spec));
    body.sources = found->sources;
    body.radiation = report.model = found->model;
    body.added_mass = found->model;
    report.sources_seconds = found->seconds;
    built.added_mass[i] = added_mass_report(*found->model, *spec.sea);
  }
}

}  // namespace assembly

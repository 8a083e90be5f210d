#include "app/commands/probe.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/assembly/build.h"
#include "app/assembly/build_interior.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/json_rows.h"
#include "app/base/terminal_reporter.h"
#include "app/logs/rig_log.h"
#include "engine/motion/body.h"
#include "engine/simulation.h"
#include "hydro/interior/interior.h"
#include "hydro/mesh/mesh_check.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json to_json(const hydro::Wrench& w) {
  return {{"force", to_json(w.force)}, {"torque", to_json(w.moment)}};
}

/// Rotates a 6 × 6 matrix from body axes into world axes.
Json in_world_axes(const hydro::Matrix6d& matrix_B, const Eigen::Matrix3d& R_WB) {
  hydro::Matrix6d turn = hydro::Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R_WB;
  const hydro::Matrix6d matrix = turn * matrix_B * turn.transpose();
  return json_rows((matrix + matrix.transpose()) / 2);
}

/// The surface that the sea wets at the start.
hydro::Hull sea_hull(const engine::BodySpec& body, const hydro::Interior* interior) {
  if (interior) return interior->outside;
  return hydro::make_hull(engine::outside_B(body));
}

/// The load of the water inside.
hydro::Wrench interior_load(const engine::BodySpec& body, const hydro::Sea& sea) {
  hydro::Wrench sum;
  const Eigen::Matrix3d R_WB = body.initial.orientation.toRotationMatrix();
  for (const hydro::Tank& tank : assembly::tanks_of(body))
    sum += sea.density * sea.gravity * hydro::water_of(tank.hull, R_WB, tank.volume).push;
  return sum;
}

Json pockets_of(const engine::BodySpec& body, const hydro::Interior* interior) {
  Json pockets = Json::array();
  if (!interior) return pockets;
  for (const hydro::Pocket& pocket : interior->division.pockets) {
    Json spill;
    if (std::isfinite(pocket.spill)) spill = body.initial.position.z() + pocket.spill;
    pockets.push_back({{"capacity", pocket.capacity},
                       {"spill", spill},
                       {"floor", body.initial.position.z() + pocket.floor}});
  }
  return pockets;
}

/// @param moved   The same body as the engine has it.
Json probe_body(const engine::BodySpec& body, const engine::Body& moved,
                const std::optional<hydro::Sea>& sea) {
  hydro::Loads loads;
  std::shared_ptr<const hydro::Interior> interior;
  if (body.interior == engine::Interior::flooding)
    interior = engine::pockets_at(body, body.initial.orientation.toRotationMatrix().row(2));
  if (sea && (body.wet || hydro::check_mesh(body.mesh_B).closed())) {
    loads = hydro::compute_loads(sea_hull(body, interior.get()), body.initial, *sea, 0,
                                 body.coefficients, body.summation);
    loads.interior = interior_load(body, *sea);
  }
  if (sea && body.radiation)
    loads.diffraction = body.radiation->wave_load(body.initial, *sea, 0);
  else if (sea && body.added_mass)
    loads.wave_inertia = body.added_mass->wave_load(body.initial, *sea, 0);
  if (sea && (body.resistance || moved.hull_lift)) {
    const hydro::HullWater water = engine::water_about(moved, body.initial, 0);
    if (body.resistance)
      loads.resistance = hydro::resistance_load(*body.resistance, body.initial, water.velocity,
                                                loads.displaced_volume);
    if (moved.hull_lift) loads.hull_lift = moved.hull_lift->load(body.initial, water);
  }
  const Eigen::Matrix3d R = body.initial.orientation.toRotationMatrix();
  Json added_mass;
  if (body.added_mass) added_mass = in_world_axes(body.added_mass->at(body.initial, *sea, 0), R);
  return {{"com", to_json(body.initial.position)},
          {"mass", body.mass},
          {"inertia", json_rows(R * body.inertia_B * R.transpose())},
          {"displaced_volume", loads.displaced_volume},
          {"wetted_area", loads.wetted_area},
          {"buoyancy", to_json(loads.buoyancy)},
          {"pressure_drag", to_json(loads.pressure_drag)},
          {"viscous_drag", to_json(loads.viscous_drag)},
          {"lift", to_json(loads.lift)},
          {"wave_inertia", to_json(loads.wave_inertia)},
          {"diffraction", to_json(loads.diffraction)},
          {"hull_lift", to_json(loads.hull_lift)},
          {"wind", to_json(loads.wind)},
          {"interior", to_json(loads.interior)},
          {"pockets", pockets_of(body, interior.get())},
          {"added_mass", added_mass},
          {"resistance", to_json(loads.resistance)}};
}

/// Adds the first rows of the tables, by names and then by columns; a field that is empty in a log
/// has no key.
void add_tables(const engine::SimulationSpec& spec, Json& json) {
  const RigLog log(spec, true);
  const std::vector<LogTable> tables = log.tables();
  if (tables.empty()) return;
  const engine::Simulation simulation(spec);
  const auto numbers = log.numbers(simulation.rig(), simulation.states());
  for (std::size_t i = 0; i < tables.size(); ++i) {
    Json& things = json[std::filesystem::path(tables[i].layout.file).stem().string()];
    auto number = numbers[i].begin();
    for (const std::string& name : tables[i].names) {
      things[name] = Json::object();
      for (const TableSeries& series : tables[i].layout.series)
        for (const std::string& column : series.columns) {
          if (!std::isnan(*number)) things[name][column] = *number;
          ++number;
        }
    }
  }
}

}  // namespace

int probe(const std::filesystem::path& file, const std::vector<scene::Override>& overrides,
          scene::MeshFormats formats) {
  const scene::Scene scene = scene::read(file, overrides, formats);
  TerminalReporter reporter(false);
  assembly::AddedMassStore store(assembly::cache_folder());
  const assembly::BuiltScene built = assembly::build(scene, store, reporter);
  assembly::keep_solutions(built, store, reporter);
  Json bodies = Json::object();
  const std::vector<engine::Body> moved = engine::make_bodies(built.spec);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const engine::BodySpec& body = built.spec.bodies[i];
    bodies[body.name] = probe_body(body, moved[i], built.spec.sea);
  }
  Json json = {{"bodies", bodies}};
  add_tables(built.spec, json);
  print(fmt::format("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace)));
  return kDone;
}

}  // namespace app

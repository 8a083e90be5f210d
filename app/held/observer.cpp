#include "app/held/observer.h"

#include <cmath>
#include <iterator>

#include "app/assembly/build_control.h"
#include "app/base/words.h"
#include "app/held/units.h"
#include "app/logs/rig_log.h"
#include "app/scene/rig_names.h"
#include "engine/base/body_quantity.h"

namespace app {
namespace {

// Columns of trajectory.csv beside the place.
constexpr const char* kMotionColumns[] = {"qw", "qx", "qy", "qz", "vx",
                                          "vy", "vz", "wx", "wy", "wz"};

double motion_of(const hydro::BodyState& state, std::size_t column) {
  if (column == 0) return state.orientation.w();
  if (column < 4) return state.orientation.vec()[static_cast<Eigen::Index>(column - 1)];
  const Eigen::Vector3d& rate = column < 7 ? state.linear_velocity : state.angular_velocity;
  return rate[static_cast<Eigen::Index>((column - 4) % 3)];
}

/// Returns the unit of a column of a table.
/// @param row     Index of its row.
/// @param known   The set points of the scene.
std::string units_in(const LogTable& table, std::size_t row, const TableSeries& series,
                     const std::vector<scene::SetPoint>& known, const scene::Scene& scene,
                     const engine::SimulationSpec& spec) {
  if (table.layout.key == "joint") return units_of_joint(series.units, spec.joints[row]);
  if (table.layout.key != "set_point") return series.units;
  return units_of(*scene::find_named(known, table.names[row]), scene);
}

/// Returns what stands before the column in the name of an observable.
std::string owner_of(const LogTable& table, const std::string& row) {
  return table.layout.key == "joint" ? "joints[" + row + "]" : row;
}

}  // namespace

Observables::Observables(const scene::Scene& scene, const HeldSimulation& simulation) {
  add_bodies(scene);
  add_motions(simulation.engine());
  add_tables(scene, simulation.engine());
  add_joints(scene);
  add_probes(simulation);
}

std::vector<std::string> Observables::names() const { return scene::names_of(all_); }

std::vector<std::string> Observables::units() const {
  std::vector<std::string> units;
  for (const Observable& one : all_) units.push_back(one.units);
  return units;
}

void Observables::add_bodies(const scene::Scene& scene) {
  for (const scene::Measurable& one : scene::measurable(scene)) {
    if (one.of != scene::Measurable::Of::body) continue;
    const assembly::NamedMeasurement found = assembly::measurement_of(scene, one);
    all_.push_back({one.name, OfBody{found.of, found.unit}, units_of_motion(one.quantity)});
  }
}

void Observables::add_motions(const engine::Simulation& engine) {
  const std::vector<engine::BodySpec>& bodies = engine.spec().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t column = 0; column < std::size(kMotionColumns); ++column)
      all_.push_back({bodies[i].name + "." + kMotionColumns[column], OfMotion{i, column},
                      units_of_motion(kMotionColumns[column])});
}

void Observables::add_tables(const scene::Scene& scene, const engine::Simulation& engine) {
  const RigLog log(engine.spec(), true);
  const std::vector<LogTable> tables = log.tables();
  const std::vector<scene::SetPoint> known = scene::set_points(scene);
  const auto numbers = log.numbers(engine.rig(), engine.states());
  for (std::size_t t = 0; t < tables.size(); ++t) {
    const bool set_points = tables[t].layout.key == "set_point";
    std::size_t number = 0;
    const auto add = [&](const std::string& name, const std::string& units) {
      const bool is_reading = set_points && find(name) != nullptr;
      if (!std::isnan(numbers[t][number]) && !is_reading)
        all_.push_back({name, OfTable{t, number, 1}, units});
      ++number;
    };
    for (std::size_t i = 0; i < tables[t].names.size(); ++i)
      for (const TableSeries& series : tables[t].layout.series)
        for (const std::string& column : series.columns) {
          const std::string& row = tables[t].names[i];
          add(set_points ? row : owner_of(tables[t], row) + "." + column,
              units_in(tables[t], i, series, known, scene, engine.spec()));
        }
  }
}

/// The coordinates of joints under the names that controls have for them.
void Observables::add_joints(const scene::Scene& scene) {
  for (const scene::Measurable& one : scene::measurable(scene)) {
    if (one.of != scene::Measurable::Of::joint || find(one.name) != nullptr) continue;
    const std::string column = "joints[" + scene.joints[one.index].name + "].coordinate";
    OfTable source = std::get<OfTable>(find(column)->source);
    source.unit = assembly::measurement_of(scene, one).unit;
    all_.push_back({one.name, source, one.quantity.ends_with("_deg") ? "deg" : "m"});
  }
}

void Observables::add_probes(const HeldSimulation& simulation) {
  if (!simulation.sensors()) return;
  const Sensors& sensors = *simulation.sensors();
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    std::size_t number = 0;
    for (const std::string& column : sensors.columns(i))
      all_.push_back({"probes[" + sensors.name(i) + "]." + column, OfProbe{i, number++},
                      units_of_probe(column)});
  }
}

const Observables::Observable* Observables::find(const std::string& name) const {
  return scene::find_named(all_, name);
}

Observer::Observer(const Observables& observables, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto* const found = observables.find(name);
    if (found == nullptr)
      throw UnknownName("there is nothing to observe of the name '" + name + "'" +
                        did_you_mean(name, observables.names()));
    sources_.push_back(found->source);
    reads_tables_ |= std::holds_alternative<Observables::OfTable>(found->source);
    reads_probes_ |= std::holds_alternative<Observables::OfProbe>(found->source);
  }
}

void Observer::read(const HeldSimulation& simulation, double* numbers) const {
  const engine::Simulation& engine = simulation.engine();
  std::vector<std::vector<double>> tables, probes;
  if (reads_tables_) tables = RigLog(engine.spec(), true).numbers(engine.rig(), engine.states());
  if (reads_probes_) probes = simulation.sensors()->read(engine);
  const double level = engine.spec().sea ? engine.spec().sea->level : 0;
  for (const auto& source : sources_) {
    if (const auto* body = std::get_if<Observables::OfBody>(&source))
      *numbers = engine::body_quantity(body->of.quantity, engine.states()[body->of.index], level) /
                 body->unit;
    if (const auto* motion = std::get_if<Observables::OfMotion>(&source))
      *numbers = motion_of(engine.states()[motion->body], motion->column);
    if (const auto* table = std::get_if<Observables::OfTable>(&source))
      *numbers = tables[table->table][table->number] / table->unit;
    if (const auto* probe = std::get_if<Observables::OfProbe>(&source))
      *numbers = probes[probe->probe][probe->column];
    ++numbers;
  }
}

}  // namespace app

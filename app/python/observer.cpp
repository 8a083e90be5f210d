#include "app/python/observer.h"

#include <cmath>

#include "app/assembly/build_control.h"
#include "app/base/words.h"
#include "app/logs/rig_log.h"
#include "app/scene/rig_names.h"
#include "engine/base/body_quantity.h"

namespace python {
namespace {

/// Returns what stands before the column in the name of an observable.
std::string owner_of(const app::LogTable& table, const std::string& row) {
  return table.layout.key == "joint" ? "joints[" + row + "]" : row;
}

}  // namespace

Observables::Observables(const scene::Scene& scene, const HeldSimulation& simulation) {
  add_bodies(scene);
  add_tables(simulation.engine());
  add_joints(scene);
  add_probes(simulation);
}

std::vector<std::string> Observables::names() const { return scene::names_of(all_); }

void Observables::add_bodies(const scene::Scene& scene) {
  for (const scene::Measurable& one : scene::measurable(scene)) {
    if (one.of != scene::Measurable::Of::body) continue;
    const assembly::NamedMeasurement found = assembly::measurement_of(scene, one);
    all_.push_back({one.name, OfBody{found.of, found.unit}});
  }
}

void Observables::add_tables(const engine::Simulation& engine) {
  const app::RigLog log(engine.spec(), true);
  const std::vector<app::LogTable> tables = log.tables();
  const auto numbers = log.numbers(engine.rig(), engine.states());
  for (std::size_t t = 0; t < tables.size(); ++t) {
    const bool set_points = tables[t].layout.key == "set_point";
    std::size_t number = 0;
    const auto add = [&](const std::string& name) {
      const bool known = set_points && find(name) != nullptr;
      if (!std::isnan(numbers[t][number]) && !known) all_.push_back({name, OfTable{t, number, 1}});
      ++number;
    };
    for (const std::string& row : tables[t].names)
      for (const app::TableSeries& series : tables[t].layout.series)
        for (const std::string& column : series.columns)
          add(set_points ? row : owner_of(tables[t], row) + "." + column);
  }
}

/// The coordinates of joints under the names that controls have for them.
void Observables::add_joints(const scene::Scene& scene) {
  for (const scene::Measurable& one : scene::measurable(scene)) {
    if (one.of != scene::Measurable::Of::joint || find(one.name) != nullptr) continue;
    const std::string column = "joints[" + scene.joints[one.index].name + "].coordinate";
    OfTable source = std::get<OfTable>(find(column)->source);
    source.unit = assembly::measurement_of(scene, one).unit;
    all_.push_back({one.name, source});
  }
}

void Observables::add_probes(const HeldSimulation& simulation) {
  if (!simulation.sensors()) return;
  const Sensors& sensors = *simulation.sensors();
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    std::size_t number = 0;
    for (const std::string& column : sensors.columns(i))
      all_.push_back({"probes[" + sensors.name(i) + "]." + column, OfProbe{i, number++}});
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
                        app::did_you_mean(name, observables.names()));
    sources_.push_back(found->source);
    reads_tables_ |= std::holds_alternative<Observables::OfTable>(found->source);
    reads_probes_ |= std::holds_alternative<Observables::OfProbe>(found->source);
  }
}

void Observer::read(const HeldSimulation& simulation, double* numbers) const {
  const engine::Simulation& engine = simulation.engine();
  std::vector<std::vector<double>> tables, probes;
  if (reads_tables_)
    tables = app::RigLog(engine.spec(), true).numbers(engine.rig(), engine.states());
  if (reads_probes_) probes = simulation.sensors()->read(engine);
  const double level = engine.spec().sea ? engine.spec().sea->level : 0;
  for (const auto& source : sources_) {
    if (const auto* body = std::get_if<Observables::OfBody>(&source))
      *numbers = engine::body_quantity(body->of.quantity, engine.states()[body->of.index], level) /
                 body->unit;
    if (const auto* table = std::get_if<Observables::OfTable>(&source))
      *numbers = tables[table->table][table->number] / table->unit;
    if (const auto* probe = std::get_if<Observables::OfProbe>(&source))
      *numbers = probes[probe->probe][probe->column];
    ++numbers;
  }
}

}  // namespace python

#include "app/logs/force_log.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace app {
namespace {

/// A load and its name in the log.
struct NamedLoad {
  std::string_view name;
  hydro::Wrench load;
  double work = 0;  ///< [J]
};

std::array<NamedLoad, 9> named_loads(const engine::BodyForces& f) {
  const engine::Works& w = f.works;
  return {{{"buoyancy", f.water.buoyancy, w.buoyancy},
           {"pressure_drag", f.water.pressure_drag, w.pressure_drag},
           {"viscous_drag", f.water.viscous_drag, w.viscous_drag},
           {"lift", f.water.lift, w.lift},
           {"wave_inertia", f.water.wave_inertia, w.wave_inertia},
           {"added_mass", f.added_mass, w.added_mass},
           {"applied", f.applied, w.applied},
           {"weight", f.weight, w.weight},
           {"constraint", f.constraint, w.constraint}}};
}

/// Calls put(column, number) for the force and the torque of a load.
template <class Put>
void put_load(const NamedLoad& n, Put&& put) {
  for (int i = 0; i < 3; ++i) put(fmt::format("{}_f{}", n.name, "xyz"[i]), n.load.force[i]);
  for (int i = 0; i < 3; ++i) put(fmt::format("{}_t{}", n.name, "xyz"[i]), n.load.moment[i]);
}

/// Returns the numbers of a row, and fills in the names of their columns unless `columns` is null.
std::vector<double> row_of(const engine::BodyForces& forces, std::vector<std::string>* columns) {
  std::vector<double> row;
  const auto put = [&](const std::string& column, double number) {
    row.push_back(number == 0 ? 0 : number);  // no -0: equal loads would differ
    if (columns) columns->push_back(column);
  };
  const std::array<NamedLoad, 9> loads = named_loads(forces);
  for (const NamedLoad& n : loads) put_load(n, put);
  put("wetted_area", forces.water.wetted_area);
  put("displaced_volume", forces.water.displaced_volume);
  put("kinetic_energy", forces.kinetic_energy);
  put("added_kinetic_energy", forces.added_kinetic_energy);
  put("potential_energy", forces.potential_energy);
  for (const NamedLoad& n : loads) put(fmt::format("work_{}", n.name), n.work);
  put("work_brake", forces.works.brake);
  put_load({"wind", forces.water.wind}, put);
  put("work_wind", forces.works.wind);
  put_load({"diffraction", forces.water.diffraction}, put);
  put("work_diffraction", forces.works.diffraction);
  put_load({"radiation", forces.radiation}, put);
  put("work_radiation", forces.works.radiation);
  put_load({"interior", forces.water.interior}, put);
  put("work_interior", forces.works.interior);
  put_load({"lines", forces.lines}, put);
  put("work_lines", forces.works.lines);
  put_load({"machines", forces.machines}, put);
  put("work_machines", forces.works.machines);
  put_load({"resistance", forces.water.resistance}, put);
  put("work_resistance", forces.works.resistance);
  put_load({"hull_lift", forces.water.hull_lift}, put);
  put("work_hull_lift", forces.works.hull_lift);
  put_load({"water", forces.simulated_water}, put);
  put("work_water", forces.works.water);
  return row;
}

}  // namespace

std::vector<std::string> force_columns() {
  std::vector<std::string> columns;
  row_of({}, &columns);
  return columns;
}

std::vector<double> force_row(const engine::BodyForces& forces) { return row_of(forces, nullptr); }

}  // namespace app

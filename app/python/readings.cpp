#include "app/python/readings.h"

#include "app/logs/force_log.h"
#include "app/logs/hdf5_layout.h"
#include "app/logs/rig_log.h"
#include "app/python/arrays.h"

namespace python {
namespace {

/// Returns the numbers of a row by their columns, and moves on to those of the next row.
py::dict row_of(const std::vector<std::string>& columns, const double*& number) {
  py::dict row;
  for (const std::string& column : columns) row[py::str(column)] = *number++;
  return row;
}

std::vector<std::string> columns_of(const app::TableLayout& layout) {
  std::vector<std::string> columns;
  for (const app::TableSeries& series : layout.series)
    columns.insert(columns.end(), series.columns.begin(), series.columns.end());
  return columns;
}

py::dict probe_table(const app::Sensors& sensors, const engine::Simulation& engine) {
  const std::vector<std::vector<double>> numbers = sensors.read(engine);
  py::dict table;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const double* number = numbers[i].data();
    table[py::str(sensors.name(i))] = row_of(sensors.columns(i), number);
  }
  return table;
}

}  // namespace

py::dict readings_of(const app::HeldSimulation& simulation) {
  const engine::Simulation& engine = simulation.engine();
  const app::RigLog log(engine.spec(), true);
  const std::vector<app::LogTable> tables = log.tables();
  const auto numbers = log.numbers(engine.rig(), engine.states());
  py::dict all;
  for (std::size_t t = 0; t < tables.size(); ++t) {
    py::dict table;
    const double* number = numbers[t].data();
    const std::vector<std::string> columns = columns_of(tables[t].layout);
    for (const std::string& name : tables[t].names) table[py::str(name)] = row_of(columns, number);
    const std::string& file = tables[t].layout.file;
    all[py::str(file.substr(0, file.find('.')))] = table;
  }
  if (simulation.sensors()) all["probes"] = probe_table(*simulation.sensors(), engine);
  return all;
}

py::dict forces_of(const std::vector<double>& row) {
  py::dict forces;
  const double* number = row.data();
  for (const app::Hdf5Series& series : app::force_series(1)) {
    const std::size_t width = app::width_of(series);
    forces[py::str(series.name)] =
        width == 1 ? py::object(py::float_(*number))
                   : py::object(to_array(std::vector<double>(number, number + width)));
    number += width;
  }
  return forces;
}

}  // namespace python

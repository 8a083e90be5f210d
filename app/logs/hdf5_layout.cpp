#include "app/logs/hdf5_layout.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/logs/force_log.h"

namespace app {
namespace {

/// Describes a dataset of numbers of `bodies` bodies or names.
Hdf5Series series_of(std::string name, std::string units, std::vector<std::string> columns,
                     std::size_t bodies) {
  if (columns.size() == 1) return {std::move(name), std::move(units), {}, {bodies}};
  const std::size_t width = columns.size();
  return {std::move(name), std::move(units), std::move(columns), {bodies, width}};
}

/// Returns the units of a column of forces.csv that belongs to no load.
std::string units_of(const std::string& column) {
  if (column == "wetted_area") return "m^2";
  if (column == "displaced_volume") return "m^3";
  return "J";
}

}  // namespace

std::vector<Hdf5Series> state_series(std::size_t bodies) {
  return {series_of("position", "m", {"x", "y", "z"}, bodies),
          series_of("orientation", "1", {"qw", "qx", "qy", "qz"}, bodies),
          series_of("linear_velocity", "m/s", {"vx", "vy", "vz"}, bodies),
          series_of("angular_velocity", "rad/s", {"wx", "wy", "wz"}, bodies)};
}

std::vector<Hdf5Series> force_series(std::size_t bodies) {
  constexpr std::string_view kFirst = "_fx";
  constexpr std::size_t kLoad = 6;
  const std::vector<std::string> columns = force_columns();
  std::vector<Hdf5Series> all;
  for (auto column = columns.begin(); column != columns.end();) {
    const bool is_load = column->ends_with(kFirst);
    const auto end = column + (is_load ? kLoad : 1);
    const std::string name = column->substr(0, column->size() - (is_load ? kFirst.size() : 0));
    all.push_back(series_of(name, is_load ? "N, N m" : units_of(name), {column, end}, bodies));
    column = end;
  }
  return all;
}

std::vector<Hdf5Series> table_series(const TableLayout& layout, std::size_t names) {
  std::vector<Hdf5Series> all;
  for (const TableSeries& series : layout.series)
    all.push_back(series_of(layout.key + "_" + series.name, series.units, series.columns, names));
  return all;
}

std::size_t width_of(const Hdf5Series& series) {
  return std::max<std::size_t>(1, series.columns.size());
}

}  // namespace app

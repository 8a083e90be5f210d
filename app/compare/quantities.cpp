#include "app/compare/quantities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/base/words.h"
#include "app/logs/hdf5_layout.h"
#include "app/logs/table_layouts.h"

namespace app {
namespace {

using hydro::BodyState;

/// Returns the angle of the rotation between two attitudes [deg].
double angle_between(const BodyState& a, const BodyState& b) {
  const Eigen::Quaterniond d = a.orientation.conjugate() * b.orientation;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w())) * 180 / std::numbers::pi;
}

TableLayout forces_layout() {
  constexpr std::ptrdiff_t kLoad = 6;
  TableLayout layout{"forces.csv", "a log of forces", "body", {}};
  for (const Hdf5Series& series : force_series(1)) {
    if (series.columns.empty()) {
      layout.series.push_back({series.name, series.units, {series.name}});
      continue;
    }
    const auto first = series.columns.begin();
    layout.series.push_back({series.name, "N", {first, first + kLoad / 2}});
    layout.series.push_back(
        {series.name + "_torque", "N m", {first + kLoad / 2, series.columns.end()}});
  }
  return layout;
}

TableLayout interior_layout() {
  return {"interior.csv",
          "a log of the water inside",
          "pocket",
          {{"volume", "m^3", {"volume"}},
           {"level", "m", {"level"}},
           {"capacity", "m^3", {"capacity"}},
           {"spill", "m", {"spill"}},
           {"flooded", "1", {"flooded"}},
           {"inflow", "m^3", {"inflow"}},
           {"centroid", "m", {"x", "y", "z"}},
           {"air_pressure", "Pa", {"air_pressure"}}}};
}

std::vector<ComparedTable> make_tables() {
  constexpr std::size_t kSuffix = 4;  // ".csv"
  std::vector<TableLayout> layouts = {forces_layout(), interior_layout()};
  for (TableLayout& layout : all_table_layouts()) layouts.push_back(std::move(layout));
  std::vector<ComparedTable> tables;
  for (TableLayout& layout : layouts) {
    const std::string name = layout.file.substr(0, layout.file.size() - kSuffix);
    tables.push_back({name, std::move(layout)});
  }
  return tables;
}

}  // namespace

const std::array<ComparedQuantity, 4> kComparedQuantities = {{
    {"position", "m", true,
     [](const BodyState& a, const BodyState& b) { return (a.position - b.position).norm(); }},
    {"orientation_deg", "deg", true, angle_between},
    {"linear_velocity", "m/s", false,
     [](const BodyState& a, const BodyState& b) {
       return (a.linear_velocity - b.linear_velocity).norm();
     }},
    {"angular_velocity", "rad/s", false,
     [](const BodyState& a, const BodyState& b) {
       return (a.angular_velocity - b.angular_velocity).norm();
     }},
}};

const std::vector<ComparedTable>& compared_tables() {
  static const std::vector<ComparedTable> tables = make_tables();
  return tables;
}

std::string quantity_name(const ComparedTable& table, const TableSeries& series) {
  return table.name + "." + series.name;
}

std::string fault_of_quantity(const std::string& name) {
  std::vector<std::string> motion, of_table, all;
  for (const ComparedQuantity& quantity : kComparedQuantities) motion.emplace_back(quantity.name);
  all = motion;
  for (const ComparedTable& table : compared_tables()) {
    all.push_back(table.name);
    for (const TableSeries& series : table.layout.series) {
      all.push_back(quantity_name(table, series));
      if (name.starts_with(table.name + ".")) of_table.push_back(all.back());
    }
  }
  if (std::ranges::find(all, name) != all.end()) return "";
  std::string hint = did_you_mean(name, all);
  if (hint.empty() && !of_table.empty()) hint = "; there are " + enumerate(of_table, "and");
  if (hint.empty())
    hint = fmt::format("; there are {}, and those of tables, such as forces.buoyancy or lines",
                       enumerate(motion, "and"));
  return fmt::format("unknown quantity {}{}", name, hint);
}

}  // namespace app

#include <fmt/format.h>

#include <algorithm>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

/// The block `current`.
struct CurrentTable {
  std::vector<double> depths;
  std::vector<Eigen::Vector3d> velocities;
};

/// Reads the depths of a table: a list of numbers, each greater than the one before.
bool read_depths(const Value& value, const std::string& expected, std::vector<double>& depths) {
  if (!value.node.is(YamlNode::Kind::list)) return value.refuse(expected);
  if (value.node.items.empty()) return value.refuse("at least one depth");
  const NumberRule rule = not_negative("m");
  for (std::size_t i = 0; i < value.node.items.size(); ++i) {
    double depth = 0;
    if (!read_number(value.item(i), rule, expectation(rule, false, 0), depth)) return false;
    if (i > 0 && !(depth > depths.back())) {
      value.item(i).fault(
          fmt::format("found {:g} after {:g}, expected a greater depth", depth, depths.back()));
      return false;
    }
    depths.push_back(depth);
  }
  return true;
}

/// Reads the velocities of a table, which are horizontal.
bool read_velocities(const Value& value, const std::string& expected,
                     std::vector<Eigen::Vector3d>& velocities) {
  if (!value.node.is(YamlNode::Kind::list)) return value.refuse(expected);
  for (std::size_t i = 0; i < value.node.items.size(); ++i) {
    const Value row = value.item(i);
    Eigen::Vector3d velocity;
    if (!read_numbers(row, number("m/s"), {velocity.data(), 3})) return false;
    if (velocity.z() != 0) {
      row.item(2).fault(fmt::format("found {:g}, expected 0: the current of a table is horizontal",
                                    velocity.z()));
      return false;
    }
    velocities.push_back(velocity);
  }
  return true;
}

void read(MapReader& map, CurrentTable& table) {
  const std::string depths = "a list of rising numbers >= 0 [m]";
  const std::string velocities = "a list of lists of 3 numbers, the last 0 [m/s]";
  ValueShape list = list_shape(shape(not_negative("m"), false, 0), 0);
  list.least = 1;
  const auto first = map.find("depths", depths, "required", {list});
  list = list_shape(shape(number("m/s"), false, 3), 0);
  list.least = 1;
  const auto second = map.find("velocities", velocities, "required", {list});
  const bool sound = first && read_depths(*first, depths, table.depths);
  if (!second || !read_velocities(*second, velocities, table.velocities) || !sound) return;
  if (table.velocities.size() != table.depths.size())
    second->refuse(fmt::format("{}, one for each depth", table.depths.size()));
}

}  // namespace

void read_current(MapReader& map, Water& water) {
  CurrentTable table;
  const NumberRule rule = number("m/s");
  const auto value =
      map.find_unless_block("current", expectation(rule, false, 3) + ", or {depths, velocities}",
                            "[0, 0, 0]", table, {shape(rule, false, 3)});
  if (value) {
    read_numbers(*value, rule, {water.current.data(), 3});
    return;
  }
  const std::size_t rows = std::min(table.depths.size(), table.velocities.size());
  for (std::size_t i = 0; i < rows; ++i)
    water.current_profile.push_back({table.depths[i], table.velocities[i].head<2>()});
  if (rows > 0) water.current = table.velocities.front();
}

}  // namespace scene

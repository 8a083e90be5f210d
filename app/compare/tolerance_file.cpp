#include <fmt/format.h>

#include <algorithm>

#include "app/compare/quantities.h"
#include "app/compare/tolerances.h"
#include "app/scene/reader_map.h"
#include "app/scene/yaml_reader.h"
#include "app/scene/yaml_text.h"

namespace app {
namespace {

using scene::MapReader;
using scene::YamlNode;

const char* const kExpected = "a number, or a map of peak, rms and relative";
const char* const kExpectedTable = "a number, or a map of peak, rms, relative and quantities";

/// Reads the limits of a map. @return true if there is any
bool read_limits(MapReader& reader, const std::string& unit, Tolerance& tolerance) {
  const bool peak = reader.optional("peak", tolerance.peak, scene::not_negative(unit));
  const bool rms = reader.optional("rms", tolerance.rms, scene::not_negative(unit));
  const bool share = reader.optional("relative", tolerance.relative, scene::not_negative());
  return peak || rms || share;
}

/// Reads a number, which is the peak, from a value that is no map. @return false after a fault
bool read_peak(const scene::Value& value, const std::string& unit, const char* expected,
               Tolerance& tolerance) {
  if (!scene::plain_number(value.node)) return value.refuse(expected);
  return scene::Field<scene::NumberRule, double>::read(value, scene::not_negative(unit),
                                                       tolerance.peak);
}

void read_quantity(MapReader& reader, const std::string& key, const std::string& unit,
                   const std::string& name, Tolerances::Quantities& quantities) {
  const auto value = reader.find(key, kExpected, "");
  if (!value) return;
  Tolerance tolerance;
  if (!value->node.is(YamlNode::Kind::map)) {
    if (read_peak(*value, unit, kExpected, tolerance)) quantities[name] = tolerance;
    return;
  }
  MapReader limits(&value->node, value->path, value->reading);
  if (read_limits(limits, unit, tolerance)) quantities[name] = tolerance;
  limits.report_other_keys();
}

void read_table(MapReader& reader, const ComparedTable& table, Tolerances::Quantities& quantities) {
  const auto value = reader.find(table.name, kExpectedTable, "");
  if (!value) return;
  Tolerance tolerance;
  if (!value->node.is(YamlNode::Kind::map)) {
    if (read_peak(*value, "", kExpectedTable, tolerance)) quantities[table.name] = tolerance;
    return;
  }
  MapReader inner(&value->node, value->path, value->reading);
  if (read_limits(inner, "", tolerance)) quantities[table.name] = tolerance;
  for (const TableSeries& series : table.layout.series)
    read_quantity(inner, series.name, series.units, quantity_name(table, series), quantities);
  inner.report_other_keys();
}

void read_quantities(MapReader& reader, Tolerances::Quantities& quantities) {
  for (const ComparedQuantity& quantity : kComparedQuantities)
    read_quantity(reader, quantity.name, quantity.unit, quantity.name, quantities);
  for (const ComparedTable& table : compared_tables()) read_table(reader, table, quantities);
}

void read_bodies(const scene::Value& bodies, Tolerances& tolerances) {
  if (!bodies.node.is(YamlNode::Kind::map)) {
    bodies.refuse("a map of body names");
    return;
  }
  for (const scene::YamlEntry& entry : bodies.node.entries) {
    const std::string path = bodies.path + "." + entry.key;
    const scene::Value value{entry.value, path, bodies.reading};
    if (!entry.value.is(YamlNode::Kind::map)) {
      value.refuse("a map of tolerances");
      continue;
    }
    MapReader reader(&entry.value, path, bodies.reading);
    read_quantities(reader, tolerances.bodies[entry.key]);
    reader.report_other_keys();
  }
}

YamlNode scalar_of(const std::string& text) {
  YamlNode node;
  node.kind = YamlNode::Kind::scalar;
  node.text = text;
  return node;
}

/// Adds an entry to a map, which a node without one becomes.
YamlNode& put(const std::string& key, const YamlNode& value, YamlNode& map) {
  map.kind = YamlNode::Kind::map;
  scene::YamlEntry& entry = map.entries.emplace_back();
  entry.key = key;
  entry.value = value;
  return entry.value;
}

YamlNode node_of(const Tolerance& tolerance) {
  const auto text = [](double limit) { return fmt::format("{}", limit); };
  if (tolerance.rms == Tolerance::kNone && tolerance.relative == Tolerance::kNone)
    return scalar_of(text(tolerance.peak));
  YamlNode map;
  const auto add = [&](const char* key, double limit) {
    if (limit != Tolerance::kNone) put(key, scalar_of(text(limit)), map);
  };
  add("peak", tolerance.peak);
  add("rms", tolerance.rms);
  add("relative", tolerance.relative);
  return map;
}

/// Returns the map at a key, which is made if it is missing, from a number if there is one.
YamlNode& map_at(YamlNode& parent, const std::string& key) {
  const auto found = std::ranges::find(parent.entries, key, &scene::YamlEntry::key);
  if (found == parent.entries.end()) return put(key, {}, parent);
  if (found->value.is(YamlNode::Kind::scalar)) {
    YamlNode map;
    put("peak", found->value, map);
    found->value = map;
  }
  return found->value;
}

/// Adds the quantities to a map. A table comes before its quantities, as a map is ordered.
void put(const Tolerances::Quantities& quantities, YamlNode& to) {
  for (const auto& [name, tolerance] : quantities) {
    const std::size_t dot = name.find('.');
    YamlNode& map = dot == std::string::npos ? to : map_at(to, name.substr(0, dot));
    put(dot == std::string::npos ? name : name.substr(dot + 1), node_of(tolerance), map);
  }
}

}  // namespace

Tolerances read_tolerances(const std::filesystem::path& file) {
  const YamlNode root = scene::parse_yaml(scene::read_text(file), file);
  if (!root.is(YamlNode::Kind::map))
    throw scene::InputError(file, "expected tolerances, such as position: 1e-6");
  scene::Reading reading;
  reading.file = file;
  Tolerances tolerances;
  MapReader reader(&root, "", reading);
  read_quantities(reader, tolerances.all);
  if (const auto bodies = reader.find("bodies", "a map of body names", ""))
    read_bodies(*bodies, tolerances);
  reader.report_other_keys();
  for (const scene::UnknownKey& unknown : reading.unknown_keys)
    reading.faults.add(
        {unknown.place,
         unknown.block_path.empty() ? unknown.key : unknown.block_path + "." + unknown.key,
         "unknown key" + did_you_mean(unknown.key, unknown.known)});
  reading.faults.throw_if_any();
  return tolerances;
}

std::string yaml_of(const Tolerances& tolerances) {
  YamlNode root;
  put(tolerances.all, root);
  for (const auto& [name, quantities] : tolerances.bodies)
    put(quantities, put(name, {}, map_at(root, "bodies")));
  return scene::yaml_text(root);
}

}  // namespace app

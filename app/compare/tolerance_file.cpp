#include "app/compare/comparison.h"
#include "app/scene/reader_map.h"
#include "app/scene/yaml_reader.h"

namespace app {
namespace {

void read_quantities(MapReader& reader, std::map<std::string, double>& tolerances) {
  for (const ComparedQuantity& quantity : kComparedQuantities) {
    double tolerance = 0;
    if (reader.optional(quantity.name, tolerance, not_negative(quantity.unit)))
      tolerances[quantity.name] = tolerance;
  }
}

void read_bodies(const Value& bodies, Tolerances& tolerances) {
  if (!bodies.node.is(YamlNode::Kind::map)) {
    bodies.refuse("a map of body names");
    return;
  }
  for (const YamlEntry& entry : bodies.node.entries) {
    const std::string path = bodies.path + "." + entry.key;
    const Value value{entry.value, path, bodies.reading};
    if (!entry.value.is(YamlNode::Kind::map)) {
      value.refuse("a map of tolerances");
      continue;
    }
    MapReader reader(&entry.value, path, bodies.reading);
    read_quantities(reader, tolerances.bodies[entry.key]);
    reader.report_other_keys();
  }
}

}  // namespace

Tolerances read_tolerances(const std::filesystem::path& file) {
  const YamlNode root = parse_yaml(read_text(file), file);
  if (!root.is(YamlNode::Kind::map))
    throw InputError(file, "expected tolerances, such as position: 1e-6");
  Reading reading;
  reading.file = file;
  Tolerances tolerances;
  MapReader reader(&root, "", reading);
  read_quantities(reader, tolerances.all);
  if (const auto bodies = reader.find("bodies", "a map of body names", ""))
    read_bodies(*bodies, tolerances);
  reader.report_other_keys();
  for (const UnknownKey& unknown : reading.unknown_keys)
    reading.faults.add(
        {unknown.place,
         unknown.block_path.empty() ? unknown.key : unknown.block_path + "." + unknown.key,
         "unknown key" + did_you_mean(unknown.key, unknown.known)});
  reading.faults.throw_if_any();
  return tolerances;
}

}  // namespace app

#include "app/compare/comparison.h"
#include "app/scene/reader_map.h"
#include "app/scene/yaml_reader.h"

namespace app {
namespace {

void read_quantities(scene::MapReader& reader, std::map<std::string, double>& tolerances) {
  for (const ComparedQuantity& quantity : kComparedQuantities) {
    double tolerance = 0;
    if (reader.optional(quantity.name, tolerance, scene::not_negative(quantity.unit)))
      tolerances[quantity.name] = tolerance;
  }
}

void read_bodies(const scene::Value& bodies, Tolerances& tolerances) {
  if (!bodies.node.is(scene::YamlNode::Kind::map)) {
    bodies.refuse("a map of body names");
    return;
  }
  for (const scene::YamlEntry& entry : bodies.node.entries) {
    const std::string path = bodies.path + "." + entry.key;
    const scene::Value value{entry.value, path, bodies.reading};
    if (!entry.value.is(scene::YamlNode::Kind::map)) {
      value.refuse("a map of tolerances");
      continue;
    }
    scene::MapReader reader(&entry.value, path, bodies.reading);
    read_quantities(reader, tolerances.bodies[entry.key]);
    reader.report_other_keys();
  }
}

}  // namespace

Tolerances read_tolerances(const std::filesystem::path& file) {
  const scene::YamlNode root = scene::parse_yaml(scene::read_text(file), file);
  if (!root.is(scene::YamlNode::Kind::map))
    throw scene::InputError(file, "expected tolerances, such as position: 1e-6");
  scene::Reading reading;
  reading.file = file;
  Tolerances tolerances;
  scene::MapReader reader(&root, "", reading);
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

}  // namespace app

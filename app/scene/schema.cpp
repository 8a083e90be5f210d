#include "app/scene/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/scene/key_catalogue.h"
#include "app/scene/scene.h"
#include "app/scene/yaml_reader.h"

namespace scene {
namespace {

using Json = nlohmann::ordered_json;
using ShapeKind = ValueShape::Kind;

/// A text with a variable, which may stand for any number, word or truth value.
const char* const kVariable = "[$][{]";

/// `bodies[].mass` → `bodies[]`; empty for a key of the top level.
std::string block_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? "" : path.substr(0, dot);
}

std::string key_of(const std::string& path) { return path.substr(path.rfind('.') + 1); }

/// Converts an unquoted YAML scalar.
Json yaml_scalar(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  const char* const end = text.data() + text.size();
  long whole = 0;
  if (const auto read = std::from_chars(text.data(), end, whole);
      read.ec == std::errc() && read.ptr == end)
    return whole;
  double number = 0;
  if (const auto read = std::from_chars(text.data(), end, number);
      read.ec == std::errc() && read.ptr == end)
    return number;
  return text;
}

Json to_json(const YamlNode& node) {
  if (node.is(YamlNode::Kind::scalar)) return yaml_scalar(node.text);
  if (node.is(YamlNode::Kind::null)) return nullptr;
  Json json = node.is(YamlNode::Kind::list) ? Json::array() : Json::object();
  for (const YamlNode& item : node.items) json.push_back(to_json(item));
  for (const YamlEntry& entry : node.entries) json[entry.key] = to_json(entry.value);
  return json;
}

Json number_schema(const ValueShape& shape) {
  Json schema = {{"type", {shape.kind == ShapeKind::whole ? "integer" : "number", "string"}},
                 {"pattern", kVariable}};
  if (shape.lo == shape.hi) return {{"const", yaml_scalar(fmt::format("{:g}", shape.lo))}};
  const auto limit = [](double value) { return yaml_scalar(fmt::format("{:.17g}", value)); };
  if (std::isfinite(shape.lo))
    schema[shape.above_lo ? "exclusiveMinimum" : "minimum"] = limit(shape.lo);
  if (std::isfinite(shape.hi)) schema["maximum"] = limit(shape.hi);
  return schema;
}

/// Writes the schema of a catalogue, block by block.
class SchemaWriter {
 public:
  explicit SchemaWriter(KeyCatalogue catalogue) : catalogue_(std::move(catalogue)) {}

  /// Describes a map and its contents. @param path   `bodies[]`; empty: the whole scene.
  Json block(const std::string& path) const {
    Json schema = {{"type", "object"}, {"additionalProperties", false}};
    Json properties = Json::object();
    Json required = Json::array();
    for (const KeyDescription& key : catalogue_.keys) {
      if (block_of(key.path) != path) continue;
      if (key_of(key.path) == kAnyName) return named_entries(key);
      properties[key_of(key.path)] = property(key);
      if (key.fallback == "required") required.push_back(key_of(key.path));
    }
    schema["properties"] = properties;
    if (path.empty()) schema["patternProperties"] = {{"^x-", true}};
    if (path.ends_with("[]") && !properties.contains("repeat"))
      schema["properties"]["repeat"] = repetition();
    if (!required.empty()) schema["required"] = required;
    add_choices(path, schema);
    add_conditions(path, schema);
    return schema;
  }

 private:
  /// Describes the block that any map in a list may have.
  Json repetition() const {
    const auto key = std::ranges::find(catalogue_.keys, "bodies[].repeat", &KeyDescription::path);
    return {{"description", description(*key)},
            {"allOf", {{{"$ref", "#/properties/bodies/items/properties/repeat"}}}}};
  }

  /// Describes a map whose keys the user names.
  Json named_entries(const KeyDescription& entry) const {
    return {{"type", "object"},
            {"minProperties", 1},
            {"propertyNames",
             {{"pattern", fmt::format("^[A-Za-z0-9_-]{{1,{}}}$", kLongestCameraName)}}},
            {"additionalProperties", property(entry)}};
  }

  Json property(const KeyDescription& key) const {
    Json schema = {{"description", description(key)}};
    if (!key.fallback.empty() && key.fallback != "required")
      schema["default"] = to_json(parse_yaml(key.fallback, key.path));
    if (key.shapes.size() == 1) {
      schema.update(value(key.shapes.front(), key.path));
      return schema;
    }
    for (const ValueShape& shape : key.shapes) schema["anyOf"].push_back(value(shape, key.path));
    return schema;
  }

  static std::string description(const KeyDescription& key) {
    const std::string fallback = key.fallback.empty()         ? ""
                                 : key.fallback == "required" ? ", required"
                                                              : ", by default " + key.fallback;
    return fmt::format("{}\n\nValue: {}{}.", key_meaning(key.path), key.expected, fallback);
  }

  Json value(const ValueShape& shape, const std::string& path) const {
    switch (shape.kind) {
      case ShapeKind::number:
      case ShapeKind::whole:
        return number_schema(shape);
      case ShapeKind::word:
        return {{"anyOf", {{{"enum", shape.words}}, {{"type", "string"}, {"pattern", kVariable}}}}};
      case ShapeKind::truth:
        return {{"type", {"boolean", "string"}}, {"pattern", kVariable}};
      case ShapeKind::off:
        return {{"const", false}};
      case ShapeKind::text:
      case ShapeKind::file:
        // A name may look like a number or a truth value.
        return {{"type", {"string", "number", "boolean"}}, {"minLength", 1}};
      case ShapeKind::map:
        return block(path);
      case ShapeKind::list:
        return list(shape, path);
    }
    return true;
  }

  Json list(const ValueShape& shape, const std::string& path) const {
    Json schema = {{"type", "array"}, {"items", value(shape.item.front(), path + "[]")}};
    if (const std::size_t least = std::max(shape.count, shape.least); least > 0)
      schema["minItems"] = least;
    if (shape.count > 0) schema["maxItems"] = shape.count;
    if (shape.distinct) schema["uniqueItems"] = true;
    return schema;
  }

  void add_choices(const std::string& path, Json& schema) const {
    for (const KeyChoice& choice : catalogue_.choices) {
      if (choice.block != path) continue;
      Json options = Json::array();
      for (const std::string& key : choice.keys)
        options.push_back({{"required", Json::array({key})}});
      schema["allOf"].push_back({{"oneOf", options}});
    }
  }

  void add_conditions(const std::string& path, Json& schema) const {
    for (const KeyCondition& condition : catalogue_.conditions) {
      if (condition.block != path) continue;
      Json then = Json::object();
      if (!condition.needed.empty()) then["required"] = condition.needed;
      for (const std::string& refused : condition.refused) then["properties"][refused] = false;
      Json when = {{"required", Json::array({condition.key})}};
      if (!condition.word.empty()) when["properties"][condition.key] = {{"const", condition.word}};
      schema["allOf"].push_back({{"if", when}, {"then", then}});
    }
  }

  KeyCatalogue catalogue_;
};

/// Returns the name of the table that lists a key.
std::string key_table_of(const std::string& path) {
  const std::string first = path.substr(0, path.find_first_of(".["));
  return first == path || first == "integrator" ? "scene" : first;
}

}  // namespace

std::string json_schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "A scene of Plimsoll, format 1"}};
  schema.update(SchemaWriter(key_catalogue()).block(""));
  return schema.dump(2) + "\n";
}

std::string key_tables() {
  const KeyCatalogue catalogue = key_catalogue();
  std::string text;
  for (const char* table :
       {"scene", "water", "air", "ground", "hydro", "bodies", "joints", "contacts", "springs",
        "ropes", "moorings", "propellers", "rudders", "controls", "log", "render"}) {
    text += fmt::format(
        "<!-- keys of {}: begin -->\n"
        "| key | value | default | meaning |\n| --- | --- | --- | --- |\n",
        table);
    for (const KeyDescription& key : catalogue.keys)
      if (key_table_of(key.path) == table && described_path(key.path) == key.path)
        text += fmt::format("| `{}` | {} | {} | {} |\n", key.path, key.expected,
                            key.fallback.empty() ? "–" : key.fallback, key_meaning(key.path));
    text += fmt::format("<!-- keys of {}: end -->\n", table);
  }
  return text;
}

}  // namespace scene

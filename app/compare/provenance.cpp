#include "app/compare/provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "app/base/table.h"
#include "app/logs/run_source.h"
#include "app/scene/diagnostics.h"
#include "app/scene/reader.h"
#include "app/scene/reader_values.h"
#include "app/scene/yaml_reader.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;
using scene::YamlNode;

/// Key paths and their values, in the order of the file.
using KeyValues = std::vector<std::pair<std::string, std::string>>;

bool is_leaf(const YamlNode& node) {
  return node.is(YamlNode::Kind::scalar) || node.is(YamlNode::Kind::null);
}

/// Returns a plain value; numbers alike, however they are written.
std::string text_of_leaf(const YamlNode& node) {
  if (node.is(YamlNode::Kind::null)) return "null";
  if (const auto number = scene::plain_number(node)) return scene::exact_text(*number);
  return node.text.empty() ? "\"\"" : node.text;
}

/// Adds all values below a node. A list of plain values is one value.
void flatten(const YamlNode& node, const std::string& path, KeyValues& all) {
  if (is_leaf(node)) {
    all.emplace_back(path, text_of_leaf(node));
  } else if (node.is(YamlNode::Kind::map)) {
    for (const scene::YamlEntry& entry : node.entries)
      flatten(entry.value, path.empty() ? entry.key : path + "." + entry.key, all);
  } else if (std::ranges::all_of(node.items, is_leaf)) {
    std::string list;
    for (const YamlNode& item : node.items) list += (list.empty() ? "" : ", ") + text_of_leaf(item);
    all.emplace_back(path, "[" + list + "]");
  } else {
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const YamlNode* name = node.items[i].find("name");
      const std::string index =
          name != nullptr && is_leaf(*name) ? name->text : fmt::format("{}", i);
      flatten(node.items[i], fmt::format("{}[{}]", path, index), all);
    }
  }
}

/// Returns the keys of the scene that was run; none if the summary does not have it.
std::optional<KeyValues> keys_of(const Json& summary, const std::string& run,
                                 std::vector<std::string>& notes) {
  const std::string prefix = fmt::format("the scene of {} is not known", run);
  try {
    const std::optional<RunSource> source = source_in(summary, run);
    if (!source) {
      notes.push_back(prefix);
      return std::nullopt;
    }
    const std::string text =
        scene::resolved_text_of(source->text, source->file, overrides_of(*source));
    KeyValues all;
    flatten(scene::parse_yaml(text, source->file), "", all);
    return all;
  } catch (const scene::InputError& error) {
    notes.push_back(fmt::format("{}: {}", prefix, error.what()));
    return std::nullopt;
  }
}

/// Adds what differs between two lists of things and their descriptions.
void add_changes(const KeyValues& a, const KeyValues& b, std::vector<Change>& changes) {
  const std::map<std::string, std::string> of_b(b.begin(), b.end());
  const std::map<std::string, std::string> of_a(a.begin(), a.end());
  for (const auto& [what, value] : a) {
    const auto other = of_b.find(what);
    if (other == of_b.end())
      changes.push_back({what, value, ""});
    else if (other->second != value)
      changes.push_back({what, value, other->second});
  }
  for (const auto& [what, value] : b)
    if (!of_a.contains(what)) changes.push_back({what, "", value});
}

std::string text_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() || !found->is_string() ? "" : found->get<std::string>();
}

KeyValues programs_of(const Json& summary) {
  KeyValues programs;
  for (const auto& [name, key] :
       {std::pair("plimsoll", "version"), std::pair("moorings", "moorings")})
    if (const std::string text = text_at(summary, key); !text.empty())
      programs.emplace_back(name, text);
  return programs;
}

/// A mesh by its number of triangles, and by its digest where both summaries have one.
KeyValues meshes_of(const Json& summary, const Json& other) {
  KeyValues meshes;
  if (!summary.contains("bodies") || !summary["bodies"].is_object()) return meshes;
  for (const auto& [name, body] : summary["bodies"].items()) {
    if (!body.is_object() || !body.contains("triangles")) continue;
    std::string text = fmt::format("{} triangles", body["triangles"].dump());
    const Json* same = other.contains("bodies") && other["bodies"].contains(name)
                           ? &other["bodies"][name]
                           : nullptr;
    const std::string digest = text_at(body, "mesh_digest");
    if (same != nullptr && same->is_object() && !digest.empty() &&
        !text_at(*same, "mesh_digest").empty())
      text += ", digest " + digest;
    meshes.emplace_back(name, text);
  }
  return meshes;
}

std::string cell_of(const std::string& value) {
  constexpr std::size_t kMost = 40;
  if (value.empty()) return "-";
  return value.size() <= kMost ? value : value.substr(0, kMost - 2) + "..";
}

/// Adds a table of changes under a title.
void add_table(const std::string& title, const std::vector<Change>& changes, std::string& text) {
  constexpr std::size_t kMost = 30;
  if (changes.empty()) return;
  std::vector<Cells> rows = {{title, "A", "B"}};
  for (std::size_t i = 0; i < std::min(kMost, changes.size()); ++i)
    rows.push_back({changes[i].what, cell_of(changes[i].a), cell_of(changes[i].b)});
  for (const std::string& line : aligned_lines(rows)) text += line + "\n";
  if (changes.size() > kMost)
    text += fmt::format("  and {} more, which --json lists\n", changes.size() - kMost);
}

Json json_of(const std::vector<Change>& changes) {
  const auto text = [](const std::string& value) { return value.empty() ? Json() : Json(value); };
  Json all = Json::object();
  for (const Change& change : changes) all[change.what] = {text(change.a), text(change.b)};
  return all;
}

}  // namespace

std::optional<Provenance> provenance_of(const ComparedRun& run_a, const ComparedRun& run_b) {
  const Json& a = run_a.summary;
  const Json& b = run_b.summary;
  if (a.is_null() || b.is_null()) return std::nullopt;
  Provenance provenance;
  add_changes(programs_of(a), programs_of(b), provenance.programs);
  const auto keys_a = keys_of(a, "A", provenance.notes);
  const auto keys_b = keys_of(b, "B", provenance.notes);
  if (keys_a && keys_b) add_changes(*keys_a, *keys_b, provenance.keys);
  add_changes(meshes_of(a, b), meshes_of(b, a), provenance.meshes);
  return provenance;
}

std::string text_of(const Provenance& provenance) {
  std::string text;
  add_table("program", provenance.programs, text);
  add_table("scene key", provenance.keys, text);
  add_table("mesh of", provenance.meshes, text);
  for (const std::string& note : provenance.notes) text += "  " + note + "\n";
  if (provenance.alike() && provenance.notes.empty())
    text = "  program, scene and meshes are the same\n";
  return text;
}

Json json_of(const Provenance& provenance) {
  return {{"programs", json_of(provenance.programs)},
          {"keys", json_of(provenance.keys)},
          {"meshes", json_of(provenance.meshes)},
          {"notes", provenance.notes}};
}

}  // namespace app

#include "app/scene/yaml_text.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>

namespace scene {
namespace {

using Kind = YamlNode::Kind;

bool is_flat(const YamlNode& node) {
  const auto is_leaf = [](const YamlNode& n) { return n.is(Kind::scalar) || n.is(Kind::null); };
  return std::ranges::all_of(node.items, is_leaf) &&
         std::ranges::all_of(node.entries, is_leaf, &YamlEntry::value);
}

void emit(const YamlNode& node, bool in_list, YAML::Emitter& out) {
  switch (node.kind) {
    case Kind::null:
      out << YAML::Null;
      return;
    case Kind::scalar:
      if (node.quoted) out << YAML::DoubleQuoted;
      out << node.text;
      return;
    case Kind::list:
      if (is_flat(node)) out << YAML::Flow;
      out << YAML::BeginSeq;
      for (const YamlNode& item : node.items) emit(item, true, out);
      out << YAML::EndSeq;
      return;
    case Kind::map:
      if (in_list && is_flat(node)) out << YAML::Flow;
      out << YAML::BeginMap;
      for (const YamlEntry& entry : node.entries) {
        out << YAML::Key << entry.key << YAML::Value;
        emit(entry.value, false, out);
      }
      out << YAML::EndMap;
  }
}

}  // namespace

std::string yaml_text(const YamlNode& root) {
  YAML::Emitter out;
  emit(root, false, out);
  return std::string(out.c_str()) + "\n";
}

}  // namespace scene

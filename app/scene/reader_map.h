#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/reader_values.h"

namespace scene {

/// Reads one block of a scene, a YAML map, into a struct key by key. Faults are collected; a key
/// that no reader asks for is a fault.
///
/// Each struct has a `void read(MapReader&, Struct&)` that asks for its keys and then checks the
/// constraints between them. This function also lists the keys: a reader without a map finds no
/// value, enters every block, and adds the description of each key to the reading's catalogue.
class MapReader {
 public:
  /// @param map    The YAML map; null to list the keys.
  MapReader(const YamlNode* map, std::string path, Reading& reading);

  bool has(const std::string& key) const { return map_ != nullptr && map_->find(key) != nullptr; }

  /// Reads a required key. @return true if it is present and valid
  template <class T, class Rule>
  bool required(const std::string& key, T& target, const Rule& rule) {
    const auto value =
        find(key, Field<Rule, T>::expected(rule), "required", {Field<Rule, T>::shape(rule)});
    return value && Field<Rule, T>::read(*value, rule, target);
  }

  /// Reads an optional key; without it `target` is unchanged. @return true if it is present and
  /// valid
  template <class T, class Rule>
  bool optional(const std::string& key, T& target, const Rule& rule) {
    const auto value = find(key, Field<Rule, T>::expected(rule), Field<Rule, T>::text(rule, target),
                            {Field<Rule, T>::shape(rule)});
    return value && Field<Rule, T>::read(*value, rule, target);
  }

  /// Returns the value of a key that no rule covers; a missing one is a fault if `fallback` is
  /// `required`.
  /// @param shapes   Allowed shapes, for the list of keys.
  std::optional<Value> find(const std::string& key, const std::string& expected,
                            const std::string& fallback,
                            const std::vector<ValueShape>& shapes = {});

  /// Reads a key that may hold a block or something else. A block goes into `target`; any other
  /// value is returned.
  /// @param shapes   Allowed shapes besides the block.
  template <class T>
  std::optional<Value> find_unless_block(const std::string& key, const std::string& expected,
                                         const std::string& fallback, T& target,
                                         std::vector<ValueShape> shapes) {
    shapes.push_back({.kind = ValueShape::Kind::map});
    const auto value = find(key, expected, fallback, shapes);
    if (map_ == nullptr) enter(nullptr, child_path(key), target);
    if (!value || !value->node.is(YamlNode::Kind::map)) return value;
    enter(&value->node, value->path, target);
    return std::nullopt;
  }

  /// Reads an optional block. @return true if it is present and a map
  template <class T>
  bool block(const std::string& key, T& target) {
    const auto value = find(key, "a map", "", {{.kind = ValueShape::Kind::map}});
    if (map_ == nullptr) enter(nullptr, child_path(key), target);
    return value && enter_map(*value, target);
  }

  /// Reads an optional block into an optional target.
  template <class T>
  bool block(const std::string& key, std::optional<T>& target) {
    return alternative<T>(key, target);
  }

  /// Reads an optional block; if present, `target` holds a T.
  template <class T, class Holder>
  bool alternative(const std::string& key, Holder& target) {
    T alternative{};
    const bool found = block(key, alternative);
    if (found) target = std::move(alternative);
    return found;
  }

  /// Reads an optional list of blocks, each of which starts as a copy of `prototype`.
  /// @param least   Least length of a list that is present, for the list of keys; the caller checks
  ///     it.
  template <class T>
  bool blocks(const std::string& key, std::vector<T>& target, const T& prototype = {},
              std::size_t least = 0) {
    ValueShape list = list_shape({.kind = ValueShape::Kind::map}, 0);
    list.least = least;
    const auto value = find(key, "a list of maps", "[]", {list});
    if (map_ == nullptr) {
      T example = prototype;
      enter(nullptr, child_path(key) + "[]", example);
    }
    return value && enter_list(*value, target, prototype);
  }

  /// Reads an optional list of blocks, or one block of another kind in its place.
  template <class T, class Block>
  void blocks_or_block(const std::string& key, std::vector<T>& target,
                       std::optional<Block>& block) {
    const std::string expected = "a list of maps or a map";
    const auto value =
        find(key, expected, "[]",
             {list_shape({.kind = ValueShape::Kind::map}, 0), {.kind = ValueShape::Kind::map}});
    if (map_ == nullptr) {
      T example{};
      enter(nullptr, child_path(key) + "[]", example);
      enter(nullptr, child_path(key), block.emplace());
      block.reset();
    }
    if (value && value->node.is(YamlNode::Kind::map))
      enter(&value->node, value->path, block.emplace());
    else if (value && value->node.is(YamlNode::Kind::list))
      enter_list(*value, target, {});
    else if (value)
      value->refuse(expected);
  }

  /// Returns the keys of a block whose entries the user names, each once, in the order of the file.
  /// A reader without a map returns kAnyName.
  std::vector<std::string> names() const;

  /// Adds a fault unless exactly one of these keys is present. @return true if so
  bool exactly_one_of(const std::vector<std::string>& keys);
  /// Adds a fault if more than one of these keys is present. @return true if not
  bool at_most_one_of(const std::vector<std::string>& keys);
  /// Notes for the list of keys that a key needs or refuses others of its block; the caller checks
  /// this.
  /// @param word   Value of the key for which the condition holds; empty: any value.
  void note_condition(const std::string& key, const std::string& word,
                      const std::vector<std::string>& needed,
                      const std::vector<std::string>& refused);

  /// Refuses a key that an earlier version had, with the reason.
  void refuse_former(const std::string& key, const std::string& reason);

  /// Adds a fault of one key of this map, or of the whole map if `key` is empty.
  void fault(const std::string& key, const std::string& message);

  /// Adds faults for repeated keys and for keys that no reader asked for. This is the last call.
  void report_other_keys();

  const std::string& path() const { return path_; }
  Reading& reading() { return reading_; }

 private:
  std::string child_path(const std::string& key) const;
  /// Both functions add a fault if they return false.
  static bool is_list(const Value& value);
  static bool is_map(const Value& value);

  template <class T>
  void enter(const YamlNode* map, const std::string& path, T& target) {
    MapReader reader(map, path, reading_);
    read(reader, target);
    reader.report_other_keys();
  }

  template <class T>
  bool enter_list(const Value& value, std::vector<T>& target, const T& prototype) {
    if (!is_list(value)) return false;
    for (std::size_t i = 0; i < value.node.items.size(); ++i)
      enter_map(value.item(i), target.emplace_back(prototype));
    return true;
  }

  template <class T>
  bool enter_map(const Value& value, T& target) {
    if (!is_map(value)) return false;
    enter(&value.node, value.path, target);
    return true;
  }

  const YamlNode* map_;
  std::string path_;
  Reading& reading_;
  std::vector<std::string> known_;   ///< Keys that were asked for.
  std::vector<std::string> former_;  ///< Keys that an earlier version had.
};

}  // namespace scene

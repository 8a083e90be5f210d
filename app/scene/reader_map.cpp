#include "app/scene/reader_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace scene {

namespace {

std::string repetition(Mark first) {
  return first.line > 0 ? fmt::format("given twice, first in line {}", first.line) : "given twice";
}

}  // namespace

MapReader::MapReader(const YamlNode* map, std::string path, Reading& reading)
    : map_(map), path_(std::move(path)), reading_(reading) {}

std::string MapReader::child_path(const std::string& key) const {
  return path_.empty() || key.empty() ? path_ + key : path_ + "." + key;
}

std::optional<Value> MapReader::find(const std::string& key, const std::string& expected,
                                     const std::string& fallback,
                                     const std::vector<ValueShape>& shapes) {
  known_.push_back(key);
  if (map_ == nullptr) {
    reading_.catalogue.keys.push_back({child_path(key), expected, fallback, shapes});
    return std::nullopt;
  }
  const YamlNode* node = map_->find(key);
  if (node != nullptr) return Value{*node, child_path(key), reading_};
  if (fallback == "required") fault(key, "missing, expected " + expected);
  return std::nullopt;
}

void MapReader::refuse_former(const std::string& key, const std::string& reason) {
  former_.push_back(key);
  if (has(key)) fault(key, reason);
}

bool MapReader::is_list(const Value& value) {
  return value.node.is(YamlNode::Kind::list) || value.refuse("a list of maps");
}

bool MapReader::is_map(const Value& value) {
  if (value.node.is(YamlNode::Kind::null)) return value.refuse("a map, {} for all defaults");
  return value.node.is(YamlNode::Kind::map) || value.refuse("a map");
}

std::vector<std::string> MapReader::names() const {
  if (map_ == nullptr) return {kAnyName};
  std::vector<std::string> names;
  for (const YamlEntry& entry : map_->entries)
    if (std::find(names.begin(), names.end(), entry.key) == names.end()) names.push_back(entry.key);
  return names;
}

bool MapReader::exactly_one_of(const std::vector<std::string>& keys) {
  if (map_ == nullptr) {
    reading_.catalogue.choices.push_back({path_, keys});
    return true;
  }
  if (std::any_of(keys.begin(), keys.end(), [&](const auto& key) { return has(key); }))
    return at_most_one_of(keys);
  fault("", fmt::format("missing, expected exactly one of {}", app::enumerate(keys, "and")));
  return false;
}

bool MapReader::at_most_one_of(const std::vector<std::string>& keys) {
  std::string first;
  bool one = true;
  for (const std::string& key : keys) {
    if (!has(key)) continue;
    if (!first.empty()) {
      fault(key, fmt::format("given beside {}, expected only one of {}", first,
                             app::enumerate(keys, "and")));
      one = false;
    }
    if (first.empty()) first = key;
  }
  return one;
}

void MapReader::note_condition(const std::string& key, const std::string& word,
                               const std::vector<std::string>& needed,
                               const std::vector<std::string>& refused) {
  if (map_ == nullptr) reading_.catalogue.conditions.push_back({path_, key, word, needed, refused});
}

void MapReader::fault(const std::string& key, const std::string& message) {
  reading_.fault(child_path(key), message);
}

void MapReader::report_other_keys() {
  if (map_ == nullptr) return;
  std::map<std::string, Mark> first_marks;
  for (const YamlEntry& entry : map_->entries) {
    const auto [first, is_new] = first_marks.emplace(entry.key, entry.mark);
    const Place place = reading_.place(entry.mark);
    if (!is_new)
      reading_.faults.add({place, child_path(entry.key), repetition(first->second)});
    else if (std::find(known_.begin(), known_.end(), entry.key) == known_.end() &&
             std::find(former_.begin(), former_.end(), entry.key) == former_.end())
      reading_.unknown_keys.push_back({place, path_, entry.key, known_});
  }
}

}  // namespace scene

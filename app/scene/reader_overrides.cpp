#include "app/scene/reader_overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <utility>

#include "app/base/words.h"

namespace scene {

namespace {

/// The reason why an override cannot be applied.
struct Obstacle {
  std::string message;
};

/// Stands in brackets for a new entry at the end of a list.
constexpr const char* kNewEntry = "+";

/// One step of a key path: a key, or an entry of a list by index or name.
struct Step {
  std::string text;
  bool in_brackets = false;
};

/// Removes the next step from the front of `rest`. If `first`, no dot precedes a key.
Step take_step(std::string& rest, bool first) {
  Step step;
  step.in_brackets = rest.front() == '[';
  const bool after_dot = rest.front() == '.';
  if (!step.in_brackets && after_dot == first) throw Obstacle{"not a key path: expected a key"};
  if (step.in_brackets || after_dot) rest.erase(0, 1);
  const std::size_t end = rest.find_first_of(step.in_brackets ? "]" : ".[");
  if (step.in_brackets && end == std::string::npos)
    throw Obstacle{"not a key path: expected a ] after the ["};
  step.text = rest.substr(0, end);
  if (step.text.empty()) throw Obstacle{"not a key path: a key or index is empty"};
  rest = end == std::string::npos ? "" : rest.substr(step.in_brackets ? end + 1 : end);
  return step;
}

std::vector<Step> split(std::string key_path) {
  std::vector<Step> steps;
  if (key_path.empty()) throw Obstacle{"names no key"};
  while (!key_path.empty()) steps.push_back(take_step(key_path, steps.empty()));
  return steps;
}

/// Returns the value of a key, which is created if it is missing.
YamlNode& enter_key(YamlNode& node, const std::string& key, const std::string& path) {
  if (node.is(YamlNode::Kind::null)) node.kind = YamlNode::Kind::map;
  if (!node.is(YamlNode::Kind::map))
    throw Obstacle{fmt::format("{} is no map, so it has no key {}", path, key)};
  for (YamlEntry& entry : node.entries)
    if (entry.key == key) return entry.value;
  return node.entries.emplace_back(YamlEntry{key, {}, {}}).value;
}

std::optional<std::size_t> parse_index(const std::string& text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return index;
}

/// Returns the names of a list's entries; empty for an entry without a name.
std::vector<std::string> names_in(const YamlNode& list) {
  std::vector<std::string> names;
  for (const YamlNode& item : list.items) {
    const YamlNode* name = item.find("name");
    names.push_back(name == nullptr ? "" : name->text);
  }
  return names;
}

/// Returns the index that the brackets mean: the entry of that name, else the number.
std::size_t resolve_index(const YamlNode& list, const std::string& text, const std::string& path) {
  const std::vector<std::string> names = names_in(list);
  const auto named = std::find(names.begin(), names.end(), text);
  if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
  const std::optional<std::size_t> index = parse_index(text);
  const std::size_t size = list.items.size();
  if (!index)
    throw Obstacle{
        fmt::format("{} has no entry named {}{}", path, text, app::did_you_mean(text, names))};
  if (*index >= size)
    throw Obstacle{size == 0 ? fmt::format("{} has no entries", path)
                             : fmt::format("{} has {} entr{}, the last is {}[{}]", path, size,
                                           size == 1 ? "y" : "ies", path, size - 1)};
  return *index;
}

/// A value of the tree and its key path.
struct Found {
  YamlNode* node;
  std::string path;
};

/// Follows one step from a value; a missing key and the entry of `[+]` are created.
Found enter(const Found& from, const Step& step) {
  YamlNode& node = *from.node;
  if (!step.in_brackets)
    return {&enter_key(node, step.text, from.path),
            from.path + (from.path.empty() ? "" : ".") + step.text};
  if (!node.is(YamlNode::Kind::list) && !node.is(YamlNode::Kind::null))
    throw Obstacle{fmt::format("{} is no list, so it has no entry {}", from.path, step.text)};
  if (step.text == kNewEntry) {
    node.kind = YamlNode::Kind::list;
    node.items.emplace_back();
    return {&node.items.back(), fmt::format("{}[{}]", from.path, node.items.size() - 1)};
  }
  const std::size_t index = resolve_index(node, step.text, from.path);
  return {&node.items[index], fmt::format("{}[{}]", from.path, index)};
}

/// Follows the steps from the root and returns the last value.
Found follow(YamlNode& root, std::span<const Step> steps) {
  Found found = {&root, ""};
  for (const Step& step : steps) found = enter(found, step);
  return found;
}

/// Removes a key or a list entry.
void remove(YamlNode& root, const std::vector<Step>& steps) {
  const Step& last = steps.back();
  const Found home = follow(root, std::span(steps).first(steps.size() - 1));
  YamlNode& node = *home.node;
  if (last.in_brackets && node.is(YamlNode::Kind::list)) {
    const std::size_t index = resolve_index(node, last.text, home.path);
    node.items.erase(node.items.begin() + static_cast<std::ptrdiff_t>(index));
  } else if (std::erase_if(node.entries, [&](const YamlEntry& e) { return e.key == last.text; }) ==
             0) {
    throw Obstacle{"does not exist, so it cannot be removed"};
  }
}

/// Marks a value as given on the command line.
void clear_marks(YamlNode& node) {
  node.mark = {};
  for (YamlNode& item : node.items) clear_marks(item);
  for (YamlEntry& entry : node.entries) {
    entry.mark = {};
    clear_marks(entry.value);
  }
}

YamlNode parse_value(const std::string& value) {
  try {
    YamlNode node = parse_yaml(value, kOverridePlace);
    clear_marks(node);
    return node;
  } catch (const InputError& error) {
    throw Obstacle{fmt::format("found {}: {}", value, error.faults().front().message)};
  }
}

}  // namespace

void apply_override(const Override& override, YamlNode& root, Faults& faults) {
  try {
    const std::vector<Step> steps = split(override.key_path);
    YamlNode value = parse_value(override.value);
    // An empty value may be a typing error, so it is kept and becomes a fault.
    if (value.is(YamlNode::Kind::null) && !override.value.empty()) return remove(root, steps);
    *follow(root, steps).node = std::move(value);
  } catch (const Obstacle& obstacle) {
    faults.add({{kOverridePlace}, override.key_path, obstacle.message});
  }
}

}  // namespace scene

#include "app/scene/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "app/base/quoting.h"

namespace scene {

namespace {

std::string joined(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + to_string(fault);
  return text;
}

/// `bodies[7].mass` → `bodies[].mass`
std::string without_indices(const std::string& key_path) {
  std::string path;
  bool inside = false;
  for (const char c : key_path) {
    inside = inside && c != ']';
    if (!inside) path += c;
    inside = inside || c == '[';
  }
  return path;
}

/// Returns the path without its last part; empty for a key of the top level.
std::string parent_path(const std::string& key_path) {
  const std::size_t end = key_path.find_last_of(".[");
  return end == std::string::npos ? "" : key_path.substr(0, end);
}

}  // namespace

std::string to_string(const Fault& fault) {
  const Place& place = fault.place;
  std::string text = place.file.string();
  if (place.line > 0) text += fmt::format(":{}", place.line);
  if (place.line > 0 && place.column > 0) text += fmt::format(":{}", place.column);
  if (!text.empty()) text += text == kOverridePlace ? " " : ": ";
  if (!fault.key_path.empty()) text += fault.key_path + ": ";
  text += fault.message;
  // A text quoted from the file may hold line breaks, but a fault is one line.
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return app::shown(text, "\t");
}

InputError::InputError(std::vector<Fault> faults)
    : std::runtime_error(joined(faults)), faults_(std::move(faults)) {}

InputError::InputError(const std::filesystem::path& file, const std::string& message)
    : InputError({Fault{{file}, "", message}}) {}

Place place_of(const Places& places, std::string key_path) {
  while (true) {
    if (const auto found = places.find(key_path); found != places.end()) return found->second;
    if (key_path.empty()) return {};
    key_path = parent_path(key_path);
  }
}

void Faults::add(const Places& places, const std::string& key_path, const std::string& message) {
  add({place_of(places, key_path), key_path, message});
}

void Faults::throw_if_any() const {
  if (faults_.empty()) return;
  std::vector<Fault> sorted = faults_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Fault& a, const Fault& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  // The copies of a repeated entry have the same faults at the same place.
  std::set<std::tuple<std::filesystem::path, int, int, std::string, std::string>> seen;
  std::erase_if(sorted, [&](const Fault& f) {
    return f.place.line > 0 && !seen.emplace(f.place.file, f.place.line, f.place.column,
                                             without_indices(f.key_path), f.message)
                                    .second;
  });
  throw InputError(std::move(sorted));
}

}  // namespace scene

#include "engine/rig/moordyn/moordyn_input.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace engine {
namespace {

std::string in_small(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

std::string in_capitals(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return word;
}

bool is_head(const std::string& line) { return line.find("---") != std::string::npos; }

bool names(const std::string& line, const std::string& word) {
  return is_head(line) && in_capitals(line).find(word) != std::string::npos;
}

/// The name and the value in a line of the section OPTIONS; none of both in another line.
std::optional<std::pair<std::string, std::string>> option_in(const std::string& line) {
  std::istringstream words(line);
  std::string value, name;
  if (!(words >> value >> name)) return std::nullopt;
  return std::pair(in_small(name), value);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Calls a function with each line and whether it is an option.
template <class F>
void for_each_line(const std::string& text, const F& f) {
  bool inside = false;
  for (const std::string& line : lines_of(text)) {
    if (is_head(line)) inside = false;
    f(line, inside);
    if (names(line, "OPTIONS")) inside = true;
  }
}

bool is_one_of(const std::string& name, const std::vector<MoorDynOption>& options) {
  return std::ranges::any_of(options, [&](const MoorDynOption& option) {
    return name == in_small(option.name) ||
           std::ranges::find(option.others, name) != option.others.end();
  });
}

}  // namespace

std::string with_options(const std::string& text, const std::vector<MoorDynOption>& options) {
  std::string given;
  for (const MoorDynOption& option : options) given += option.value + ' ' + option.name + '\n';
  std::string result;
  bool was_inside = false, added = false;
  for_each_line(text, [&](const std::string& line, bool inside) {
    if (was_inside && !inside) {
      result += given;
      added = true;
    }
    was_inside = inside || names(line, "OPTIONS");
    const auto option = inside ? option_in(line) : std::nullopt;
    if (!option || !is_one_of(option->first, options)) result += line + '\n';
  });
  if (!added) result += (was_inside ? "" : "--- OPTIONS ---\n") + given;
  // MoorDyn reads on to the next head.
  return result + "--- need this line ---\n";
}

std::optional<std::string> option_of(const std::string& text, const std::string& name) {
  std::optional<std::string> value;
  for_each_line(text, [&](const std::string& line, bool inside) {
    const auto option = inside ? option_in(line) : std::nullopt;
    if (option && option->first == in_small(name)) value = option->second;
  });
  return value;
}

bool has_section(const std::string& text, const std::string& word) {
  return std::ranges::any_of(lines_of(text),
                             [&](const std::string& line) { return names(line, word); });
}

}  // namespace engine

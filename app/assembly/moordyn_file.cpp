#include "app/assembly/moordyn_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <sstream>

namespace assembly {
namespace {

std::string in_capitals(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return word;
}

/// A row of a table, split into words.
struct Row {
  int number;  ///< Of the line in the file, from 1.
  std::vector<std::string> words;

  [[noreturn]] void refuse(const std::string& message) const {
    throw MoorDynFault(fmt::format("line {}: {}", number, message));
  }
  const std::string& word(std::size_t i, const char* what) const {
    if (i >= words.size()) refuse(fmt::format("it has no {} in column {}", what, i + 1));
    return words[i];
  }
  double value(std::size_t i, const char* what) const {
    const std::string& text = word(i, what);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      refuse(fmt::format("found {} for {}, expected a number", text, what));
    return value;
  }
  double positive(std::size_t i, const char* what) const {
    const double found = value(i, what);
    if (!(found > 0)) refuse(fmt::format("found {:g} for {}, expected more than 0", found, what));
    return found;
  }
};

enum class Section { none, types, points, lines, options, unsupported };

/// The section that a line of dashes begins.
Section section_of(const std::string& head) {
  const std::string text = in_capitals(head);
  const auto names = [&](const char* word) { return text.find(word) != std::string::npos; };
  for (const char* word : {"ROD", "BODIES", "BODY", "FAILURE"})
    if (names(word)) return Section::unsupported;
  if (names("LINE TYPES") || names("LINE DICTIONARY")) return Section::types;
  if (names("POINT") || names("CONNECTION")) return Section::points;
  if (names("OPTIONS")) return Section::options;
  if (names("LINES") || names("LINE PROPERTIES")) return Section::lines;
  return Section::none;
}

class Reader {
 public:
  void read(const std::string& text) {
    std::istringstream stream(text);
    Row row{.number = 0};
    int heading = 0;  // lines of names and units that are left
    for (std::string line; std::getline(stream, line);) {
      ++row.number;
      if (line.find("---") != std::string::npos) {
        section_ = section_of(line);
        heading = section_ == Section::options ? 0 : 2;
        continue;
      }
      std::istringstream words(line);
      row.words = {std::istream_iterator<std::string>(words), {}};
      if (row.words.empty() || heading-- > 0) continue;
      read(row);
    }
    if (file.lines.empty()) throw MoorDynFault("it has no section LINES with a line");
  }

  MoorDynFile file;

 private:
  void read(const Row& row) {
    switch (section_) {
      case Section::types:
        return read_type(row);
      case Section::points:
        return read_point(row);
      case Section::lines:
        return read_line(row);
      case Section::unsupported:
        row.refuse("rods, bodies and failures are not supported");
      case Section::options:
      case Section::none:
        return;
    }
  }

  void leave_out(const std::string& what) {
    if (std::ranges::find(file.left_out, what) == file.left_out.end())
      file.left_out.push_back(what);
  }

  void read_type(const Row& row) {
    MoorDynLine type{.diameter = row.positive(1, "Diam"),
                     .mass = row.positive(2, "Mass/m"),
                     .stiffness = row.positive(3, "EA"),
                     .drag = row.value(6, "Cd"),
                     .drag_along = row.value(8, "CdAx"),
                     .added_mass = row.value(7, "Ca")};
    if (row.value(5, "EI") != 0) leave_out("the bending stiffness EI");
    if (row.words.size() > 9 && row.value(9, "CaAx") != 0) leave_out("the added mass CaAx");
    types_[row.word(0, "name")] = type;
  }

  void read_point(const Row& row) {
    const std::string kind = in_capitals(row.word(1, "type"));
    const auto is = [&](std::initializer_list<const char*> words) {
      return std::ranges::any_of(words, [&](const char* word) { return kind == word; });
    };
    const bool coupled = is({"COUPLED", "VESSEL", "FAIRLEAD"});
    if (!coupled && !is({"FIXED", "FIX", "ANCHOR"}))
      row.refuse(fmt::format("found a point of the type {}, expected Fixed or Coupled",
                             row.word(1, "type")));
    places_[row.word(0, "ID")] = static_cast<int>(file.points.size());
    file.points.push_back({coupled, {row.value(2, "X"), row.value(3, "Y"), row.value(4, "Z")}});
  }

  int point_of(const Row& row, std::size_t column) const {
    const auto place = places_.find(row.word(column, "point"));
    if (place == places_.end()) row.refuse(fmt::format("there is no point {}", row.words[column]));
    return place->second;
  }

  void read_line(const Row& row) {
    const auto type = types_.find(row.word(1, "LineType"));
    if (type == types_.end()) row.refuse(fmt::format("there is no line type {}", row.words[1]));
    MoorDynLine line = type->second;
    line.id = row.word(0, "ID");
    line.first = point_of(row, 2);
    line.second = point_of(row, 3);
    line.length = row.positive(4, "UnstrLen");
    line.segments = static_cast<int>(row.positive(5, "NumSegs"));
    if (!file.points[static_cast<std::size_t>(line.first)].coupled &&
        !file.points[static_cast<std::size_t>(line.second)].coupled)
      row.refuse("both points of the line are fixed");
    file.lines.push_back(line);
  }

  Section section_ = Section::none;
  std::map<std::string, MoorDynLine> types_;
  std::map<std::string, int> places_;
};

}  // namespace

MoorDynFile read_moordyn(const std::string& text) {
  Reader reader;
  reader.read(text);
  return std::move(reader.file);
}

}  // namespace assembly

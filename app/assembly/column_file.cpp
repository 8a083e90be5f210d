#include "app/assembly/column_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "app/scene/diagnostics.h"
#include "app/scene/table_line.h"

namespace assembly {
namespace {

using scene::TableLine;

void check_names(const std::vector<std::string>& names, const std::vector<std::string>& known,
                 const std::string& usage, const TableLine& line) {
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (!known.empty() && std::find(known.begin(), known.end(), *name) == known.end())
      line.fail(fmt::format("found '{}' in the header, {}", *name, usage));
    if (std::find(names.begin(), name, *name) != name)
      line.fail(fmt::format("the column {} is given twice, {}", *name, usage));
  }
}

}  // namespace

const std::vector<double>* ColumnFile::find(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

void ColumnFile::refuse(const std::filesystem::path& file, std::size_t row,
                        const std::string& message) const {
  throw scene::InputError({scene::Fault{{file, lines[row], 1}, "", message}});
}

ColumnFile read_columns(const std::filesystem::path& file, const std::vector<std::string>& known,
                        const std::string& usage) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw scene::InputError(file, "the file cannot be opened");
  ColumnFile table;
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    const bool marked = number == 1 && text.starts_with("\xEF\xBB\xBF");  // byte order mark
    TableLine line(file, number, std::string_view(text).substr(marked ? 3 : 0), "a finite number");
    if (table.names.empty()) {
      table.names = line.words();
      check_names(table.names, known, usage, line);
      table.columns.resize(table.names.size());
      continue;
    }
    const std::vector<double> row = line.values();
    if (row.empty()) continue;
    if (row.size() != table.names.size())
      line.fail(fmt::format("the row has {} numbers, expected {} as the header has names",
                            row.size(), table.names.size()));
    for (std::size_t i = 0; i < row.size(); ++i) table.columns[i].push_back(row[i]);
    table.lines.push_back(number);
  }
  if (in.bad()) throw scene::InputError(file, "the file cannot be read");
  if (table.names.empty()) throw scene::InputError(file, "the file is empty, " + usage);
  return table;
}

}  // namespace assembly

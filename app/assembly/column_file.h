#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace assembly {

/// A table with a line of names above its columns of numbers.
struct ColumnFile {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< In the order of the names.
  std::vector<int> lines;                    ///< Line of each row in the file, from 1.

  std::size_t rows() const { return lines.size(); }
  /// Returns the column of a name; null if there is none.
  const std::vector<double>* find(const std::string& name) const;
  /// Refuses a row. @throws InputError always.
  [[noreturn]] void refuse(const std::filesystem::path& file, std::size_t row,
                           const std::string& message) const;
};

/// Reads a table. Fields are separated by commas, semicolons or white space; empty lines and text
/// after a # are skipped.
/// @param known   Names that columns may have; none: any.
/// @param usage   Description of the columns for faults: `expected the columns …`.
/// @throws InputError if the file cannot be read, has a name that is unknown or given twice, or a
///     row without as many finite numbers as there are names (with line and column).
ColumnFile read_columns(const std::filesystem::path& file, const std::vector<std::string>& known,
                        const std::string& usage);

}  // namespace assembly

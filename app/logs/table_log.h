#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/logs/row_file.h"

/// @file
/// Tables over time: `time`, a name, and numbers, with one row per name and time. As CSV each table
/// is a file of its own; a number that a name does not have is an empty field. In an HDF5 log
/// (hdf5_layout.h) each series is a dataset, in which such a number is NaN.

namespace app {

/// Columns of a table that belong together.
struct TableSeries {
  std::string name;                  ///< `force`.
  std::string units;                 ///< `N`.
  std::vector<std::string> columns;  ///< `fx`, `fy`, `fz`.
};

/// Names and columns of a table.
struct TableLayout {
  std::string file;  ///< `lines.csv`.
  std::string kind;  ///< Name of the file in faults: `a log of lines`.
  std::string key;   ///< Title of the column of names: `line`.
  std::vector<TableSeries> series;

  std::size_t width() const;   ///< Numbers in a row.
  std::string header() const;  ///< Header of the CSV file.
  /// Index of a column among the numbers of a row; it must exist.
  std::size_t column(const std::string& name) const;
};

/// A table of given names. Its numbers at a time are the rows of all names, one after the other.
struct LogTable {
  TableLayout layout;
  std::vector<std::string> names;
};

/// Writes a table as CSV during a run. Rows are in the file when `add` returns.
class TableWriter {
 public:
  /// Replaces the file in the folder, or keeps its rows up to a position (row_file.h).
  /// @throws InputError
  TableWriter(const std::filesystem::path& folder, const LogTable& table,
              const std::optional<FilePosition>& kept = {});

  /// Adds one row per name, with digits that read back to the same numbers.
  /// @param numbers   Numbers of all names; NaN: there is none. @throws OutputError if the disk is
  ///     full.
  void add(double time, std::span<const double> numbers);

  /// See RowFile::save.
  FilePosition save() { return file_.save(); }
  /// See RowFile::check_place.
  void check_place() const { file_.check_place(); }

 private:
  std::vector<std::string> names_;
  std::size_t width_;
  RowFile file_;
};

/// The rows of one name. Numbers that it does not have are NaN.
struct TableTrack {
  std::vector<double> times;                 ///< Ascending [s].
  std::vector<std::vector<double>> columns;  ///< In the order of the layout.
};

/// A table read back.
struct TableRows {
  TableLayout layout;
  std::vector<std::string> names;  ///< In the order of their first rows.
  std::map<std::string, TableTrack> tracks;
};

/// Reads a file of TableWriter. A last line without an end is dropped.
/// @throws InputError with the line at fault, also if the times of a name do not ascend.
TableRows read_table_csv(const std::filesystem::path& file, const TableLayout& layout);

}  // namespace app

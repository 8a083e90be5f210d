#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/logs/force_log.h"
#include "app/logs/row_file.h"

/// @file
/// The log of forces as CSV: `time,body` and the columns of force_log.h, with one row per body and
/// time.

namespace app {

/// Returns the header line.
std::string force_header();

/// Writes forces during a run. Rows are in the file when `add` returns.
class ForceWriter {
 public:
  /// Replaces the file, or keeps its rows up to a position (row_file.h). @throws InputError
  ForceWriter(const std::filesystem::path& file, std::vector<std::string> names,
              const std::optional<FilePosition>& kept = {});

  /// Adds one row per body, in the order of the names, with digits that read back to the same
  /// numbers. @throws OutputError if the disk is full.
  void add(double time, const std::vector<engine::BodyForces>& forces);

  /// See RowFile::save.
  FilePosition save() { return file_.save(); }
  /// See RowFile::check_place.
  void check_place() const { file_.check_place(); }

 private:
  std::vector<std::string> names_;
  RowFile file_;
};

/// Reads a file of ForceWriter; columns that one of an older version lacks at the end are 0.
/// @throws InputError with the line at fault.
ForceLog read_force_csv(const std::filesystem::path& file);

}  // namespace app

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/logs/row_file.h"
#include "engine/hollows/interior_water.h"

/// @file
/// The log of the water in the pockets of bodies as CSV, in runs of either format:
/// `time,body,pocket` and the fields of engine/hollows/interior_water.h, with a row per pocket and
/// time. `pocket` is its id. `level`, `x`, `y` and `z` are empty without water, `spill` in a void.
/// `flooded` is 1 or 0.

namespace app {

/// Writes the pockets of bodies during a run. The file is made with its first row, so a run without
/// pockets has none.
class InteriorWriter {
 public:
  /// Removes the file, or keeps its rows up to a position (row_file.h). @throws InputError
  InteriorWriter(std::filesystem::path file, std::vector<std::string> names,
                 const std::optional<FilePosition>& kept = {});

  /// @param interiors   Interior of each body, in the order of the names. @throws OutputError
  void add(double time, const std::vector<engine::InteriorState>& interiors);

  /// See RowFile::save; nothing without a file.
  FilePosition save() { return rows_ ? rows_->save() : FilePosition(); }
  /// See RowFile::check_place.
  void check_place() const {
    if (rows_) rows_->check_place();
  }

 private:
  std::filesystem::path file_;
  std::vector<std::string> names_;
  std::optional<RowFile> rows_;
};

/// A pocket in the log; numbers that it lacks are NaN.
struct PocketRow {
  int id = 0;
  double volume = 0, level = 0, capacity = 0, spill = 0;
  bool flooded = false;
  double inflow = 0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double air = 0;  ///< Pressure of the air [Pa].
};

/// The pockets of one body at a time.
struct InteriorRows {
  double time = 0;
  std::vector<PocketRow> pockets;
};

using InteriorLog = std::map<std::string, std::vector<InteriorRows>>;  ///< The key is the body.

/// Reads a file of InteriorWriter. @throws InputError with the line at fault.
InteriorLog read_interior_csv(const std::filesystem::path& file);

}  // namespace app

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/logs/row_file.h"
#include "engine/body_forces.h"

/// @file
/// The log of forces as CSV: one row a body a time.
///
/// Columns: `time,body`; of each load `<load>_fx` … `_fz` [N] and `<load>_tx` … `_tz` [N m], about
/// the centre of mass, in W; `wetted_area` [m^2], `displaced_volume` [m^3]; `kinetic_energy`,
/// `added_kinetic_energy`, `potential_energy` [J]; `work_<load>` [J] since the start, `work_brake`
/// last. The loads are buoyancy, pressure_drag, viscous_drag, lift, added_mass, applied, weight and
/// constraint. What each means: engine/body_forces.h.

namespace app {

/// The header line.
std::string force_header();

/// The columns but time and body, and their numbers of one body at one time.
std::vector<std::string> force_columns();
std::vector<double> force_row(const engine::BodyForces& forces);

/// Writes forces while they are found. What was added is in the file when `add` returns.
class ForceWriter {
 public:
  /// Replaces the file. @throws InputError if it cannot be written.
  ForceWriter(const std::filesystem::path& file, std::vector<std::string> names);

  /// One row a body, in the order of the names, with digits that read back to the same numbers.
  /// @throws OutputError if the disk is full.
  void add(double time, const std::vector<engine::BodyForces>& forces);

 private:
  std::vector<std::string> names_;
  RowFile file_;
};

}  // namespace app

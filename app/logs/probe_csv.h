#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/logs/probes.h"
#include "app/logs/row_file.h"

/// @file
/// The log of probes as CSV: `time,probe` and the columns of probes.h, with one row per probe and
/// time. A number that is not measured is an empty field.

namespace app {

/// Writes the readings of probes during a run. Rows are in the file when `add` returns.
class ProbeWriter {
 public:
  /// Replaces the file, or keeps the first `kept` bytes of it (row_file.h). @throws InputError
  ProbeWriter(const std::filesystem::path& file, std::vector<std::string> names,
              const std::optional<std::uint64_t>& kept = {});

  /// Adds one row per probe, in the order of the names, with digits that read back to the same
  /// numbers. @throws OutputError if the disk is full.
  void add(double time, const std::vector<ProbeReading>& readings);

  /// See RowFile::save.
  std::uint64_t save() { return file_.save(); }

 private:
  std::vector<std::string> names_;
  RowFile file_;
};

}  // namespace app

#include "app/logs/read_log.h"

#include <cstdint>
#include <system_error>

#include "app/base/machine.h"
#include "app/logs/force_csv.h"
#include "app/logs/hdf5_log_reader.h"
#include "app/logs/run_files.h"
#include "app/logs/trajectory_csv.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// Refuses a log that is too large for the memory. The rows of a CSV take 1.05 bytes per byte of
/// the file; those of HDF5 are compressed and pass through another process.
void require_memory(const std::filesystem::path& file, double bytes_per_byte) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return;
  const auto verdict = judged_need(bytes_per_byte * static_cast<double>(size), available_memory());
  if (verdict && verdict->fault)
    throw scene::InputError(file, "to be read it " + verdict->text + "; log.every thins a log");
}

constexpr double kOfCsv = 1, kOfHdf5 = 4;

}  // namespace

std::filesystem::path trajectory_of(const std::filesystem::path& given) {
  if (!std::filesystem::is_directory(given)) return given;
  const bool hdf5 = std::filesystem::exists(given / kHdf5Log);
  return given / (hdf5 ? kHdf5Log : kTrajectoryLog);
}

Trajectory read_trajectory(const std::filesystem::path& file) {
  require_memory(file, is_hdf5(file) ? kOfHdf5 : kOfCsv);
  Trajectory trajectory = is_hdf5(file) ? read_hdf5_trajectory(file) : read_trajectory_csv(file);
  if (trajectory.names.empty()) throw scene::InputError(file, "has no rows");
  return trajectory;
}

std::filesystem::path forces_beside(const std::filesystem::path& trajectory) {
  if (is_hdf5(trajectory)) return trajectory;
  const std::filesystem::path file = trajectory.parent_path() / kForceLog;
  return std::filesystem::exists(file) ? file : "";
}

std::optional<ForceLog> read_forces(const std::filesystem::path& file) {
  require_memory(file, is_hdf5(file) ? kOfHdf5 : kOfCsv);
  return is_hdf5(file) ? read_hdf5_forces(file) : read_force_csv(file);
}

std::optional<TableRows> read_table(const std::filesystem::path& trajectory,
                                    const TableLayout& layout) {
  if (is_hdf5(trajectory)) return read_hdf5_table(trajectory, layout);
  const std::filesystem::path file = trajectory.parent_path() / layout.file;
  if (!std::filesystem::exists(file)) return std::nullopt;
  return read_table_csv(file, layout);
}

}  // namespace app

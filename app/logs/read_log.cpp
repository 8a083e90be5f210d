#include "app/logs/read_log.h"

#include "app/logs/force_csv.h"
#include "app/logs/hdf5_log_reader.h"
#include "app/logs/run_files.h"
#include "app/logs/trajectory_csv.h"
#include "app/scene/diagnostics.h"

namespace app {

std::filesystem::path trajectory_of(const std::filesystem::path& given) {
  if (!std::filesystem::is_directory(given)) return given;
  const bool hdf5 = std::filesystem::exists(given / kHdf5Log);
  return given / (hdf5 ? kHdf5Log : kTrajectoryLog);
}

Trajectory read_trajectory(const std::filesystem::path& file) {
  Trajectory trajectory = is_hdf5(file) ? read_hdf5_trajectory(file) : read_trajectory_csv(file);
  if (trajectory.names.empty()) throw scene::InputError(file, "has no rows");
  return trajectory;
}

std::optional<ForceLog> read_forces(const std::filesystem::path& file) {
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

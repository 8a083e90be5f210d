#include "app/report/logged_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "app/assembly/build.h"
#include "app/logs/hdf5_log_reader.h"
#include "app/logs/read_log.h"
#include "app/logs/rig_log.h"
#include "app/logs/run_files.h"
#include "app/logs/run_source.h"
#include "app/logs/trajectory_match.h"
#include "app/scene/diagnostics.h"
#include "app/scene/reader.h"

namespace app {
namespace {

namespace fs = std::filesystem;

/// Reads the scene that was run and the meshes it names.
void read_scene_of_run(const fs::path& moved_to, scene::MeshFormats formats, LoggedRun& run) {
  const fs::path summary = run.path / kSummaryFile;
  std::optional<RunSource> source = source_in(run.summary, summary);
  if (source && formats == scene::MeshFormats::any) source->mesh_formats = formats;
  if (!source && moved_to.empty())
    throw scene::InputError(
        summary, run.summary.is_null()
                     ? "is missing: the run was stopped; name its scene by report --scene"
                     : "does not name its scene; name it by report --scene");
  if (!source) {
    run.scene = scene::read(moved_to, {}, formats);
    run.built = assembly::build_without_added_mass(run.scene);
    return;
  }
  run.overrides = source->overrides;
  const fs::path file = moved_to.empty() ? source->file : moved_to;
  if (!moved_to.empty() && !fs::exists(moved_to))
    throw scene::InputError(moved_to, "there is no such file");
  try {
    run.scene = read_again(*source, file);
    run.built = assembly::build_without_added_mass(run.scene);
  } catch (const scene::InputError&) {
    if (fs::exists(file)) throw;
    throw scene::InputError(summary,
                            fmt::format("the scene {} and the files it names no longer exist; name "
                                        "the present place of the scene by report --scene",
                                        file.string()));
  }
}

/// Checks that forces and trajectory have the same times, and counts the rows that both have.
void check_forces(const fs::path& file, LoggedRun& run) {
  for (const auto& [name, track] : run.trajectory.tracks) {
    const auto found = run.forces->find(name);
    if (found == run.forces->end())
      throw scene::InputError(file, fmt::format("has no rows of body {}", name));
    const std::vector<double>& times = found->second.times;
    run.rows = std::min(run.rows, times.size());
    for (std::size_t i = 0; i < run.rows; ++i)
      if (times[i] != track.times[i])
        throw scene::InputError(file, fmt::format("row {} of body {} has the time {} s and that of "
                                                  "trajectory.csv {} s; expected both of one run",
                                                  i + 1, name, times[i], track.times[i]));
  }
}

/// Refuses a table without rows of a name, or with other times than the trajectory, and counts the
/// rows that both have.
void check_table(const fs::path& file, const LogTable& expected, const TableRows& table,
                 const std::vector<double>& times, std::size_t& rows) {
  for (const std::string& name : expected.names) {
    const auto found = table.tracks.find(name);
    if (found == table.tracks.end())
      throw scene::InputError(
          file, fmt::format("has no rows of {} {}, which the scene has", table.layout.key, name));
    const std::vector<double>& own = found->second.times;
    rows = std::min(rows, own.size());
    for (std::size_t i = 0; i < rows; ++i)
      if (own[i] != times[i])
        throw scene::InputError(
            file, fmt::format("row {} of {} {} has the time {} s and that of the trajectory {} s; "
                              "expected both of one run",
                              i + 1, table.layout.key, name, own[i], times[i]));
  }
}

/// Reads the tables of a run and checks that they have a row of each of its things at the times of
/// `times`; `rows` becomes the number of rows that all of them have.
/// @param trajectory   Its file (read_log.h).
std::vector<TableRows> read_rig(const fs::path& trajectory, const engine::SimulationSpec& spec,
                                const std::vector<double>& times, std::size_t& rows) {
  std::vector<TableRows> tables;
  for (const LogTable& expected : RigLog(spec, true).tables()) {
    auto table = read_table(trajectory, expected.layout);
    if (!table) continue;
    const bool own_file = !is_hdf5(trajectory);
    const fs::path file = own_file ? trajectory.parent_path() / expected.layout.file : trajectory;
    check_table(file, expected, *table, times, rows);
    tables.push_back(std::move(*table));
  }
  return tables;
}

/// Removes the rows that a killed run wrote for some bodies or logs only.
void keep_common_rows(LoggedRun& run) {
  for (auto& [name, track] : run.trajectory.tracks) {
    track.times.resize(run.rows);
    track.states.resize(run.rows);
  }
  const auto shorten = [&](auto& tracks) {
    for (auto& [name, track] : tracks) {
      track.times.resize(run.rows);
      for (std::vector<double>& column : track.columns) column.resize(run.rows);
    }
  };
  if (run.forces) shorten(*run.forces);
  for (TableRows& table : run.tables) shorten(table.tracks);
}

}  // namespace

LoggedRun read_run(const fs::path& folder, const fs::path& scene, scene::MeshFormats formats) {
  if (!fs::is_directory(folder))
    throw scene::InputError(folder,
                            "there is no such folder; expected one that plimsoll run has written");
  LoggedRun run{.path = folder};
  const fs::path log = trajectory_of(folder);
  run.trajectory = read_trajectory(log);
  run.rows = common_rows(run.trajectory, log);
  run.summary = read_summary(folder / kSummaryFile);
  read_scene_of_run(scene, formats, run);
  check_same_bodies(run.trajectory, run.built.spec, log);
  const fs::path forces = forces_beside(log);
  if (!forces.empty()) run.forces = read_forces(forces);
  if (run.forces) check_forces(forces, run);
  if (!run.trajectory.tracks.empty())
    run.tables =
        read_rig(log, run.built.spec, run.trajectory.tracks.begin()->second.times, run.rows);
  keep_common_rows(run);
  const fs::path interiors = folder / kInteriorLog;
  if (fs::exists(interiors)) run.interiors = read_interior_csv(interiors);
  return run;
}

}  // namespace app

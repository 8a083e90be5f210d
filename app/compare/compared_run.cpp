#include "app/compare/compared_run.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "app/compare/quantities.h"
#include "app/logs/hdf5_log_reader.h"
#include "app/logs/interior_csv.h"
#include "app/logs/read_log.h"
#include "app/logs/run_files.h"
#include "app/logs/run_source.h"
#include "app/logs/table_layouts.h"

namespace app {
namespace {

namespace fs = std::filesystem;

/// Returns the forces as a table. @param layout   Layout of the forces in compared_tables().
TableRows table_of(const ForceLog& forces, const TableLayout& layout) {
  TableRows table{.layout = layout, .names = {}, .tracks = {}};
  for (const auto& [name, track] : forces) {
    table.names.push_back(name);
    table.tracks[name] = {track.times, track.columns};
  }
  return table;
}

/// Returns the pockets as a table, whose names are `BODY.POCKET`.
TableRows table_of(const InteriorLog& interiors, const TableLayout& layout) {
  TableRows table{.layout = layout, .names = {}, .tracks = {}};
  for (const auto& [body, times] : interiors)
    for (const InteriorRows& rows : times)
      for (const PocketRow& p : rows.pockets) {
        const std::string name = fmt::format("{}.{}", body, p.id);
        const auto [entry, is_new] = table.tracks.try_emplace(name);
        TableTrack& track = entry->second;
        if (is_new) {
          table.names.push_back(name);
          track.columns.resize(layout.width());
        }
        track.times.push_back(rows.time);
        const std::array<double, 10> numbers = {
            p.volume, p.level,        p.capacity,     p.spill,        p.flooded ? 1.0 : 0.0,
            p.inflow, p.centroid.x(), p.centroid.y(), p.centroid.z(), p.air};
        for (std::size_t i = 0; i < numbers.size(); ++i) track.columns[i].push_back(numbers[i]);
      }
  return table;
}

/// Returns the layout of forces.csv or interior.csv as it is compared.
const TableLayout& layout_of(const std::string& file) {
  for (const ComparedTable& table : compared_tables())
    if (table.layout.file == file) return table.layout;
  throw std::logic_error("no table " + file);
}

void add_table(TableRows table, ComparedRun& run) {
  if (table.names.empty()) return;
  const std::string name = fs::path(table.layout.file).stem().string();
  run.tables.emplace(name, std::move(table));
}

void read_tables(const fs::path& trajectory, ComparedRun& run) {
  if (const fs::path file = forces_beside(trajectory); !file.empty())
    if (const auto forces = read_forces(file))
      add_table(table_of(*forces, layout_of(kForceLog)), run);
  for (const TableLayout& layout : all_table_layouts())
    if (auto table = read_table(trajectory, layout)) add_table(std::move(*table), run);
}

}  // namespace

ComparedRun read_compared(const fs::path& path) {
  const bool is_folder = fs::is_directory(path);
  const fs::path file = trajectory_of(path);
  ComparedRun run{.trajectory = read_trajectory(file), .tables = {}, .summary = {}};
  if (is_folder || is_hdf5(file)) read_tables(file, run);
  if (!is_folder) return run;
  run.summary = read_summary(path / kSummaryFile);
  if (const fs::path interiors = path / kInteriorLog; fs::exists(interiors))
    add_table(table_of(read_interior_csv(interiors), layout_of(kInteriorLog)), run);
  return run;
}

}  // namespace app

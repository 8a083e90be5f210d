#include "app/report/runs_page.h"

#include <algorithm>
#include <set>

#include "app/logs/motion_columns.h"
#include "app/logs/read_log.h"
#include "app/pages/packed_rows.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;
using SeriesOfRun = std::vector<std::vector<double>>;

constexpr std::size_t kLeastOverlaidRows = 16;  ///< Fewer rows do not show a motion.

/// Indices of the columns of forces.csv that are plotted: loads and the wet part of a body, without
/// energies and works.
std::vector<std::size_t> load_columns() {
  const std::vector<std::string> names = force_columns();
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i].starts_with("work_") && !names[i].ends_with("_energy")) kept.push_back(i);
  return kept;
}

std::vector<std::string> load_names() {
  std::vector<std::string> names;
  for (const std::size_t i : load_columns()) names.push_back(force_columns()[i]);
  return names;
}

/// Returns the loads on a body in a run; null if it has none.
Json loads_of(const PageRun& run, const std::string& body, std::size_t most) {
  if (!run.forces) return nullptr;
  const auto found = run.forces->find(body);
  if (found == run.forces->end()) return nullptr;
  SeriesOfRun columns;
  for (const std::size_t i : load_columns()) columns.push_back(found->second.columns[i]);
  return packed_rows(found->second.times, columns, most);
}

/// Returns the motion of a body in each run, with angles that start alike, and its loads.
Json body_in_runs(const std::vector<PageRun>& runs, const std::string& body, std::size_t most) {
  Json all = Json::array();
  SeriesOfRun first;
  for (const PageRun& run : runs) {
    const auto track = run.trajectory.tracks.find(body);
    if (track == run.trajectory.tracks.end()) {
      all.push_back(nullptr);
      continue;
    }
    SeriesOfRun motion = motion_of(track->second);
    if (first.empty())
      first = motion;
    else
      start_alike(first, motion);
    all.push_back({{"motion", packed_rows(track->second.times, motion, most)},
                   {"loads", loads_of(run, body, most)}});
  }
  return all;
}

}  // namespace

PageRun read_page_run(const std::filesystem::path& path) {
  const std::filesystem::path file = trajectory_of(path);
  PageRun run{.name = path.string(), .trajectory = read_trajectory(file), .forces = {}};
  if (const std::filesystem::path forces = forces_beside(file); !forces.empty())
    run.forces = read_forces(forces);
  return run;
}

Json runs_data(const std::vector<PageRun>& runs, const RunsLimits& limits) {
  std::set<std::string> bodies;
  Json names = Json::array();
  for (const PageRun& run : runs) {
    names.push_back(run.name);
    for (const auto& [body, track] : run.trajectory.tracks) bodies.insert(body);
  }
  const std::size_t columns = motion_columns().size() + load_columns().size();
  const std::size_t series = std::max<std::size_t>(1, columns * bodies.size() * runs.size());
  const std::size_t most = std::max(kLeastOverlaidRows, limits.numbers / series);
  Json all = Json::array();
  for (const std::string& body : bodies)
    all.push_back({{"name", body}, {"runs", body_in_runs(runs, body, most)}});
  return {{"program", PLIMSOLL_VERSION},
          {"runs", names},
          {"motion", motion_columns()},
          {"loads", load_names()},
          {"bodies", all}};
}

}  // namespace app

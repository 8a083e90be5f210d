#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/logs/force_csv.h"
#include "app/logs/motion_columns.h"
#include "app/pages/packing.h"
#include "app/pages/thinning.h"
#include "app/report/page_data.h"
#include "app/report/page_rig.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPoseNumbers = 7;  ///< Position and quaternion.
constexpr std::size_t kLeastRows = 16;   ///< Fewer rows would not show a motion.

bool varies(const std::vector<double>& column) {
  return std::any_of(column.begin(), column.end(), [&](double v) { return v != column.front(); });
}

/// Largest number of hollows of a body that are plotted, those with the lowest numbers.
constexpr int kMostHollows = 8;

/// Number of hollows in the plots of any body.
int plotted_hollows(const LoggedRun& run) {
  int most = 0;
  for (const auto& [name, times] : run.interiors)
    for (const InteriorRows& rows : times)
      for (const PocketRow& pocket : rows.pockets) most = std::max(most, pocket.id + 1);
  return std::min(most, kMostHollows);
}

std::vector<std::string> hollow_columns(const LoggedRun& run) {
  std::vector<std::string> names;
  for (int i = 0; i < plotted_hollows(run); ++i)
    for (const char* quantity : {"volume", "level"})
      names.push_back(fmt::format("hollow_{}_{}", quantity, i));
  return names;
}

/// Volume and level of the water in each hollow of a body, over the logged times. Where a hollow is
/// dry, its level is the last one that it had.
std::vector<std::vector<double>> hollow_series(const LoggedRun& run, const std::string& body) {
  const std::vector<double>& times = run.trajectory.tracks.at(body).times;
  std::vector<std::vector<double>> columns(hollow_columns(run).size(),
                                           std::vector<double>(times.size(), 0));
  const auto log = run.interiors.find(body);
  if (log == run.interiors.end()) return columns;
  auto rows = log->second.begin();
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (std::size_t k = 1; i > 0 && k < columns.size(); k += 2) columns[k][i] = columns[k][i - 1];
    while (rows != log->second.end() && rows->time < times[i]) ++rows;
    if (rows == log->second.end() || rows->time != times[i]) continue;
    for (const PocketRow& pocket : rows->pockets) {
      if (pocket.id < 0 || 2 * pocket.id + 1 >= static_cast<int>(columns.size())) continue;
      columns[2 * pocket.id][i] = pocket.volume;
      if (!std::isnan(pocket.level)) columns[2 * pocket.id + 1][i] = pocket.level;
    }
  }
  return columns;
}

/// Visits all plotted columns of a body.
using EachColumn = std::function<void(const std::vector<double>& column)>;
void each_column(const LoggedRun& run, const std::string& body, const EachColumn& visit) {
  for (const std::vector<double>& column : motion_of(run.trajectory.tracks.at(body))) visit(column);
  for (const std::vector<double>& column : hollow_series(run, body)) visit(column);
  if (!run.forces) return;
  for (const std::vector<double>& column : run.forces->at(body).columns) visit(column);
}

}  // namespace

Json page_poses(const LoggedRun& run, const Eigen::Vector3d& origin, const PageLimits& limits) {
  const std::size_t bodies = std::max<std::size_t>(run.scene.bodies.size(), 1);
  const std::vector<std::size_t> kept =
      spread_rows(run.rows, std::max(kLeastRows, limits.poses / (kPoseNumbers * bodies)));
  std::vector<double> times;
  for (const std::size_t row : kept)
    times.push_back(run.trajectory.tracks.begin()->second.times[row]);
  Json tracks = Json::array();
  for (const scene::Body& body : run.scene.bodies) {
    std::vector<float> numbers;
    for (const std::size_t row : kept) {
      const hydro::BodyState& s = run.trajectory.tracks.at(body.name).states[row];
      const Eigen::Vector3f p = (s.position - origin).cast<float>();
      const Eigen::Quaternionf q = s.orientation.cast<float>();
      numbers.insert(numbers.end(), {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()});
    }
    tracks.push_back(packed<float>(numbers));
  }
  return {{"times", packed<double>(times)}, {"bodies", tracks}};
}

Json page_series(const LoggedRun& run, const PageLimits& limits) {
  std::size_t varying = 1;
  for (const scene::Body& body : run.scene.bodies)
    each_column(run, body.name, [&](const std::vector<double>& c) { varying += varies(c); });
  varying += rig_columns(run);
  const Thinning thinning(run.rows, std::max(kLeastRows, limits.series / varying));
  std::vector<std::string> names = motion_columns();
  const std::vector<std::string> hollows = hollow_columns(run);
  names.insert(names.end(), hollows.begin(), hollows.end());
  if (run.forces) {
    const std::vector<std::string> forces = force_columns();
    names.insert(names.end(), forces.begin(), forces.end());
  }
  Json tracks = Json::array();
  for (const scene::Body& body : run.scene.bodies) {
    tracks.push_back(Json::array());
    each_column(run, body.name, [&](const std::vector<double>& column) {
      tracks.back().push_back(packed_column(thinning.values(column)));
    });
  }
  const std::vector<double>& times = run.trajectory.tracks.begin()->second.times;
  return {{"columns", names},
          {"forces", run.forces.has_value()},
          {"hollows", hollows.size() / 2},
          {"thinned", thinning.thins()},
          {"times", packed<double>(thinning.times(times))},
          {"bodies", tracks},
          {"rig", page_rig(run, thinning)}};
}

}  // namespace app

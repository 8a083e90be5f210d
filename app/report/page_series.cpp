#include <algorithm>
#include <functional>

#include "app/logs/force_csv.h"
#include "app/pages/motion_columns.h"
#include "app/pages/packing.h"
#include "app/pages/thinning.h"
#include "app/report/page_data.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPoseNumbers = 7;  ///< Position and quaternion.
constexpr std::size_t kLeastRows = 16;   ///< Fewer rows would not show a motion.

bool varies(const std::vector<double>& column) {
  return std::any_of(column.begin(), column.end(), [&](double v) { return v != column.front(); });
}

/// Visits all plotted columns of a body.
using EachColumn = std::function<void(const std::vector<double>& column)>;
void each_column(const LoggedRun& run, const std::string& body, const EachColumn& visit) {
  for (const std::vector<double>& column : motion_of(run.trajectory.tracks.at(body))) visit(column);
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
  const Thinning thinning(run.rows, std::max(kLeastRows, limits.series / varying));
  std::vector<std::string> names = motion_columns();
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
          {"thinned", thinning.thins()},
          {"times", packed<double>(thinning.times(times))},
          {"bodies", tracks}};
}

}  // namespace app

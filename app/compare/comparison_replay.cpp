#include "app/compare/comparison_replay.h"

#include <fmt/format.h>

#include "app/report/logged_run.h"
#include "app/report/page_data.h"
#include "app/scene/diagnostics.h"

namespace app {

nlohmann::ordered_json comparison_replay(const std::filesystem::path& a,
                                         const std::filesystem::path& b) {
  // Half of a report's each, so that the page is no larger than a report.
  PageLimits limits;
  limits.poses /= 2;
  limits.faces /= 2;
  limits.rigging /= 2;
  try {
    for (const std::filesystem::path& path : {a, b})
      if (!std::filesystem::is_directory(path))
        return {{"note", fmt::format("{} is a log and not the folder of a run", path.string())}};
    const LoggedRun run_a = read_run(a, {}), run_b = read_run(b, {});
    const Eigen::Vector3d origin = replay_origin(run_a);
    nlohmann::ordered_json b_of = replay_data(run_b, origin, limits);
    // These are drawn once.
    for (const char* shared : {"water", "ground", "camera"}) b_of.erase(shared);
    return {{"a", replay_data(run_a, origin, limits)}, {"b", b_of}};
  } catch (const scene::InputError& error) {
    return {{"note", error.what()}};
  }
}

}  // namespace app

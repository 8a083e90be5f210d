#include "app/pictures/logged_shots.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "app/assembly/built_scene.h"
#include "app/logs/interior_csv.h"
#include "app/logs/read_log.h"
#include "app/logs/run_files.h"
#include "app/logs/run_source.h"
#include "app/logs/trajectory_match.h"
#include "app/pictures/bodies_waves.h"
#include "app/pictures/interiors.h"
#include "app/pictures/rig_history.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// The log of the water inside beside a trajectory; empty if there is none.
InteriorLog interiors_beside(const std::filesystem::path& trajectory) {
  const std::filesystem::path file = trajectory.parent_path() / kInteriorLog;
  return std::filesystem::exists(file) ? read_interior_csv(file) : InteriorLog();
}

}  // namespace

scene::Scene logged_scene(const std::filesystem::path& run, const std::filesystem::path& scene,
                          const std::vector<scene::Override>& overrides,
                          scene::MeshFormats formats) {
  if (!scene.empty()) return scene::read(scene, overrides, formats);
  const std::filesystem::path summary = trajectory_of(run).parent_path() / kSummaryFile;
  std::optional<RunSource> source = source_in(read_summary(summary), summary);
  if (!source)
    throw scene::InputError(run,
                            "has no summary.json beside it that names the scene; name it by "
                            "--scene");
  if (formats == scene::MeshFormats::any) source->mesh_formats = formats;
  for (const scene::Override& override : overrides)
    source->overrides.push_back(override.key_path + "=" + override.value);
  return read_again(*source, source->file);
}

ShotSelector logged_shots(const std::filesystem::path& run, const scene::Scene& scene,
                          const assembly::BuiltScene& built, int fps) {
  const engine::SimulationSpec& spec = built.spec;
  const std::filesystem::path file = trajectory_of(run);
  const Trajectory trajectory = read_trajectory(file);
  check_same_bodies(trajectory, spec, file);
  const std::size_t rows = common_rows(trajectory, file);
  const InteriorLog interiors = interiors_beside(file);
  const RigHistory rig(spec, file);
  const std::vector<double>& times = trajectory.tracks.begin()->second.times;
  ShotSelector shots(scene.render->every, times[rows - 1], fps);
  shots.show_waves(bodies_waves(scene, spec));
  for (std::size_t i = 0; i < rows; ++i) {
    const std::vector<hydro::BodyState> states = states_at(trajectory, spec, i);
    shots.add(
        times[i], states, [&] { return drawn_interiors(interiors, spec, times[i]); },
        [&] { return rig.at(times[i], states); });
  }
  return shots;
}

}  // namespace app

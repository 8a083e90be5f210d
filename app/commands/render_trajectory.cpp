#include "app/commands/render_trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/assembly/build.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/base/progress.h"
#include "app/base/thread_count.h"
#include "app/logs/interior_csv.h"
#include "app/logs/output_folder.h"
#include "app/logs/read_log.h"
#include "app/logs/run_files.h"
#include "app/logs/run_source.h"
#include "app/logs/trajectory_match.h"
#include "app/pictures/bodies_waves.h"
#include "app/pictures/interiors.h"
#include "app/pictures/pictures.h"
#include "app/pictures/rig_history.h"
#include "app/pictures/shot_selector.h"
#include "app/pictures/video_check.h"
#include "app/run/run_need.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// Selects the logged states that a run of the scene would have drawn.
ShotSelector choose_shots(const Trajectory& trajectory, std::size_t rows,
                          const InteriorLog& interiors, const RigHistory& rig,
                          const scene::Scene& scene, const engine::SimulationSpec& spec,
                          const VideoOptions& video) {
  const std::vector<double>& times = trajectory.tracks.begin()->second.times;
  ShotSelector shots(scene.render->every, times[rows - 1], video.pictures_a_second());
  shots.show_waves(bodies_waves(scene, spec));
  for (std::size_t i = 0; i < rows; ++i) {
    const std::vector<hydro::BodyState> states = states_at(trajectory, spec, i);
    shots.add(
        times[i], states, [&] { return drawn_interiors(interiors, spec, times[i]); },
        [&] { return rig.at(times[i], states); });
  }
  return shots;
}

/// The log of the water inside beside a trajectory; empty if there is none.
InteriorLog interiors_beside(const std::filesystem::path& trajectory) {
  const std::filesystem::path file = trajectory.parent_path() / kInteriorLog;
  return std::filesystem::exists(file) ? read_interior_csv(file) : InteriorLog();
}

void say_what_was_drawn(const PictureReport& report, const ShotSpool& shots,
                        const std::filesystem::path& folder) {
  const std::size_t cameras = std::max<std::size_t>(1, report.cameras.size());
  say(fmt::format(
      "{}: {} of {} pictures and {}, drawn on {}", folder.string(), report.frames,
      shots.frames() * cameras,
      cameras == 1 ? "sheet.png" : fmt::format("a sheet for each of {} cameras", cameras),
      report.device));
  for (const std::string& line : videos_made(report)) say(line);
}

/// Reads the scene of the options, or else that of the run.
scene::Scene scene_of(const RenderOptions& options) {
  if (!options.scene.empty()) return scene::read(options.scene, options.overrides, options.formats);
  const std::filesystem::path summary =
      trajectory_of(options.trajectory).parent_path() / kSummaryFile;
  std::optional<RunSource> source = source_in(read_summary(summary), summary);
  if (!source)
    throw scene::InputError(options.trajectory,
                            "has no summary.json beside it that names the scene; name it by "
                            "--scene");
  for (const scene::Override& override : options.overrides)
    source->overrides.push_back(override.key_path + "=" + override.value);
  return read_again(*source, source->file);
}

}  // namespace

int render_trajectory(const RenderOptions& options) {
  scene::Scene scene = scene_of(options);
  if (!scene.render) scene.render.emplace();
  check_video(options.video, *scene.render, options.out, thread_count(0));
  assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  built.spec.threads = thread_count(0);
  if (const auto warning = picture_warning(scene))
    say(fmt::format("{}: warning: {}", scene.file.string(), *warning));
  const std::filesystem::path file = trajectory_of(options.trajectory);
  const Trajectory trajectory = read_trajectory(file);
  check_same_bodies(trajectory, built.spec, file);
  const ShotSelector list =
      choose_shots(trajectory, common_rows(trajectory, file), interiors_beside(file),
                   RigHistory(built.spec, file), scene, built.spec, options.video);
  const ShotSpool& shots = list.shots();
  const OutputFolder folder(options.out);
  const InterruptGuard interrupt;
  ProgressLine progress(options.quiet);
  const PictureReport report =
      draw_pictures(scene, built, shots, {folder.path(), options.video}, [&](int done, int all) {
        if (progress.due()) progress.show(fmt::format("picture {} of {}", done, all));
        return !interrupt.interrupted();
      });
  progress.clear();
  if (!options.quiet) say_what_was_drawn(report, shots, folder.path());
  return report.complete ? kDone : kInterrupted;
}

}  // namespace app

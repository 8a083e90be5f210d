#include <fmt/format.h>

#include <algorithm>

#include "app/assemble.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/faults.h"
#include "app/interrupt.h"
#include "app/output_folder.h"
#include "app/pictures.h"
#include "app/progress.h"
#include "app/schedule.h"
#include "app/thread_count.h"
#include "app/trajectory.h"
#include "app/trajectory_match.h"

namespace app {
namespace {

/// The logged states that `every` asks for, as a run of the scene would have drawn them.
std::vector<Shot> choose_shots(const Trajectory& trajectory, std::size_t rows, const Scene& scene) {
  const std::vector<double>& times = trajectory.tracks.begin()->second.times;
  const double end = std::max(scene.duration, times[rows - 1]);
  std::vector<Shot> shots;
  FrameSchedule frames(scene.render->every, end);
  for (std::size_t i = 0; i < rows; ++i) {
    if (!frames.due(times[i])) continue;
    Shot shot{.time = times[i]};
    for (const BodyScene& body : scene.bodies)
      shot.states.push_back(trajectory.tracks.at(body.name).states[i]);
    shots.push_back(std::move(shot));
  }
  return shots;
}

}  // namespace

int render_trajectory(const RenderOptions& options) {
  Scene scene = read_scene(options.scene, options.overrides);
  if (!scene.render) scene.render.emplace();
  Assembly assembly = assemble(scene);
  assembly.spec.threads = thread_count(0);
  const std::filesystem::path file = trajectory_of(options.trajectory);
  const Trajectory trajectory = read_trajectory(file);
  check_same_bodies(trajectory, assembly.spec, file);
  const std::vector<Shot> shots = choose_shots(trajectory, common_rows(trajectory, file), scene);
  const OutputFolder folder(options.out);
  const InterruptGuard interrupt;
  ProgressLine progress(options.quiet);
  const PictureReport report =
      draw_pictures(scene, assembly, shots, folder.path(), [&](int done, int all) {
        if (progress.due()) progress.show(fmt::format("picture {} of {}", done, all));
        return !interrupt.interrupted();
      });
  progress.clear();
  if (!options.quiet)
    say(fmt::format("{}: {} of {} pictures and sheet.png, drawn on {}", folder.path().string(),
                    report.frames, shots.size(), report.device));
  return report.frames == static_cast<int>(shots.size()) ? kDone : kInterrupted;
}

}  // namespace app

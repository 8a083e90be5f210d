#include "app/commands/render_trajectory.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/assembly/build.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/base/progress.h"
#include "app/base/thread_count.h"
#include "app/logs/output_folder.h"
#include "app/pictures/logged_shots.h"
#include "app/pictures/pictures.h"
#include "app/pictures/video_check.h"
#include "app/run/run_need.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

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

}  // namespace

int render_trajectory(const RenderOptions& options) {
  scene::Scene scene =
      logged_scene(options.trajectory, options.scene, options.overrides, options.formats);
  if (!scene.render) scene.render.emplace();
  check_video(options.video, *scene.render, options.out, thread_count(0));
  assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  built.spec.threads = thread_count(0);
  if (const auto warning = picture_warning(scene))
    say(fmt::format("{}: warning: {}", scene.file.string(), *warning));
  const ShotSelector list =
      logged_shots(options.trajectory, scene, built, options.video.pictures_a_second());
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
  for (const std::string& warning : report.warnings)
    say(fmt::format("{}: warning: {}", scene.file.string(), warning));
  if (!options.quiet) say_what_was_drawn(report, shots, folder.path());
  return report.complete ? kDone : kInterrupted;
}

}  // namespace app

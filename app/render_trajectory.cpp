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

namespace app {
namespace {

void check_same_bodies(const Trajectory& trajectory, const engine::SimulationSpec& spec,
                       const std::filesystem::path& file) {
  std::vector<Fault> faults;
  const auto add = [&](const std::string& message) {
    faults.push_back({.place = {.file = file}, .message = message});
  };
  for (const engine::BodySpec& body : spec.bodies)
    if (!trajectory.tracks.contains(body.name))
      add(fmt::format("has no body {}, which the scene has", body.name));
  for (const std::string& name : trajectory.names)
    if (std::none_of(spec.bodies.begin(), spec.bodies.end(),
                     [&](const engine::BodySpec& body) { return body.name == name; }))
      add(fmt::format("has a body {}, which the scene does not have", name));
  if (!faults.empty()) throw InputError(faults);
}

/// The rows that every body has: fewer than the longest track's if the log was cut off.
std::size_t common_rows(const Trajectory& trajectory, const std::filesystem::path& file) {
  const auto& [first, times] = *trajectory.tracks.begin();
  std::size_t rows = times.times.size();
  for (const auto& [name, track] : trajectory.tracks) rows = std::min(rows, track.times.size());
  for (const auto& [name, track] : trajectory.tracks)
    for (std::size_t i = 0; i < rows; ++i)
      if (track.times[i] != times.times[i])
        throw InputError(file,
                         fmt::format("row {} of body {} is of {} s and that of body {} of {} s; "
                                     "expected rows of all bodies at the same times",
                                     i + 1, first, times.times[i], name, track.times[i]));
  return rows;
}

/// The logged states that `every` asks for, as a run of the scene would have drawn them.
std::vector<Shot> choose_shots(const Trajectory& trajectory, std::size_t rows, const Scene& scene) {
  const std::vector<double>& times = trajectory.tracks.begin()->second.times;
  const double end = std::max(scene.duration, times[rows - 1]);
  std::vector<Shot> shots;
  Schedule due(scene.render->every);
  for (std::size_t i = 0; i < rows; ++i) {
    if (!is_frame_time(times[i], end) || !due.due(times[i])) continue;
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
  const Trajectory trajectory = read_trajectory(options.trajectory);
  check_same_bodies(trajectory, assembly.spec, options.trajectory);
  const std::vector<Shot> shots =
      choose_shots(trajectory, common_rows(trajectory, options.trajectory), scene);
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

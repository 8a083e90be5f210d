#include <fmt/format.h>

#include <algorithm>

#include "app/assemble.h"
#include "app/commands.h"
#include "app/faults.h"
#include "app/output_folder.h"
#include "app/pictures.h"
#include "app/progress.h"
#include "app/schedule.h"
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

/// The logged states that `every` asks for, as a run of the scene would have drawn them.
std::vector<Shot> choose_shots(const Trajectory& trajectory, const engine::SimulationSpec& spec,
                               double every) {
  const std::vector<double>& times = trajectory.tracks.at(spec.bodies.front().name).times;
  std::size_t rows = times.size();
  for (const auto& [name, track] : trajectory.tracks) rows = std::min(rows, track.times.size());
  std::vector<Shot> shots;
  Schedule due(every);
  for (std::size_t i = 0; i < rows; ++i) {
    if (i > 0 && !is_frame_time(times[i], times[rows - 1])) break;
    if (!due.due(times[i])) continue;
    Shot shot{.time = times[i]};
    for (const engine::BodySpec& body : spec.bodies)
      shot.states.push_back(trajectory.tracks.at(body.name).states[i]);
    shots.push_back(std::move(shot));
  }
  return shots;
}

}  // namespace

int render_trajectory(const RenderOptions& options) {
  Scene scene = read_scene(options.scene, options.overrides);
  if (!scene.render) scene.render.emplace();
  const Assembly assembly = assemble(scene);
  const Trajectory trajectory = read_trajectory(options.trajectory);
  check_same_bodies(trajectory, assembly.spec, options.trajectory);
  const std::vector<Shot> shots = choose_shots(trajectory, assembly.spec, scene.render->every);
  const OutputFolder folder(options.out);
  ProgressLine progress(options.quiet);
  const PictureReport report =
      draw_pictures(scene, assembly, shots, folder.path(), [&](int done, int all) {
        progress.show(fmt::format("picture {} of {}", done, all));
        return true;
      });
  progress.clear();
  if (!options.quiet)
    fmt::print(stderr, "{}: {} pictures and sheet.png, drawn on {}\n", folder.path().string(),
               report.frames, report.device);
  return kDone;
}

}  // namespace app

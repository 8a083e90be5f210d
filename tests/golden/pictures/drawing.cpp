#include "tests/golden/pictures/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "app/assembly/build.h"
#include "app/base/program_files.h"
#include "app/logs/read_log.h"
#include "app/logs/trajectory_match.h"
#include "app/pictures/bodies_waves.h"
#include "app/pictures/cameras.h"
#include "app/pictures/expected_pressure.h"
#include "app/pictures/paints.h"
#include "app/pictures/pictures.h"
#include "app/pictures/pressure_range.h"
#include "app/pictures/rigging.h"
#include "app/scene/reader.h"

namespace golden {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = PLIMSOLL_SOURCE_DIR;

fs::path folder_of(const std::string& scene) { return kSource / "tests" / "golden" / scene; }

scene::Scene scene_of(const KeptPicture& picture) {
  std::vector<scene::Override> overrides;
  for (const std::string& set : picture.sets) overrides.push_back(scene::parse_override(set));
  return scene::read(kSource / "scenes" / (picture.scene + ".yaml"), overrides);
}

/// The shot of the kept trajectory, which also moves the bodies' waves.
app::Shot shot_of(const KeptPicture& picture, const scene::Scene& scene,
                  const engine::SimulationSpec& spec) {
  const fs::path file = folder_of(picture.scene) / "trajectory.csv";
  const app::Trajectory trajectory = app::read_trajectory(file);
  app::check_same_bodies(trajectory, spec, file);
  const std::vector<double>& times = trajectory.tracks.begin()->second.times;
  const auto found = std::find(times.begin(), times.end(), picture.time);
  if (found == times.end())
    throw std::invalid_argument(fmt::format("{} has no row of {} s", file.string(), picture.time));
  std::optional<hydro::SimulatedWater> waves = app::bodies_waves(scene, spec);
  app::Shot shot = {.time = picture.time, .states = {}};
  for (std::size_t row = 0; row <= static_cast<std::size_t>(found - times.begin()); ++row) {
    shot.states = app::states_at(trajectory, spec, row);
    if (waves) waves->follow(times[row], shot.states);
  }
  if (waves) shot.water = waves->patch(picture.time);
  shot.rig = app::rig_at_rest(spec, shot.states, shot.time);
  return shot;
}

}  // namespace

const std::vector<KeptPicture>& kept_pictures() {
  static const std::vector<KeptPicture> pictures = {
      {"teapot_drop", 0.63, {"render.size=[480,360]"}},
      {"barge_in_swell", 9.12, {"render.size=[480,270]", "render.show=[waterline]"}},
      {"crates_afloat", 1.8, {"render.size=[480,360]", "render.show=[wireframe]"}},
      {"crane_lowering", 7.2, {"render.size=[480,360]", "render.pressure.colors=viridis"}}};
  return pictures;
}

fs::path kept_file(const KeptPicture& picture) { return folder_of(picture.scene) / "picture.png"; }

render::Image draw(const KeptPicture& picture) {
  const scene::Scene scene = scene_of(picture);
  const assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  const app::Shot shot = shot_of(picture, scene, built.spec);
  const scene::Render& look = *scene.render;
  render::SceneDescription bare =
      app::picture_of(scene, built,
                      app::pressure_scale(look, app::expected_pressure(built.spec, look.shows),
                                          app::pressure_range(built.spec, shot, look.shows)),
                      app::shown_paints(scene, built));
  bare.camera = app::camera_at(app::cameras_of(look).front(), built, shot);
  app::RigPictures rig(built.spec, look.show.joints);
  rig.include(shot);
  return render::Renderer(std::move(bare), app::program_files("shaders"))
      .draw(shot.states, shot.time, {}, rig.of(shot), shot.water ? &*shot.water : nullptr);
}

}  // namespace golden

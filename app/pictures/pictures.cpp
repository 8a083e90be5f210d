#include "app/pictures/pictures.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "app/base/background.h"
#include "app/base/program_files.h"
#include "app/pictures/bodies_waves.h"
#include "app/pictures/cameras.h"
#include "app/pictures/expected_pressure.h"
#include "app/pictures/force_annotations.h"
#include "app/pictures/interiors.h"
#include "app/pictures/paints.h"
#include "app/pictures/picture_files.h"
#include "app/pictures/pressure_range.h"
#include "app/pictures/rigging.h"
#include "app/pictures/trail.h"
#include "app/pictures/video_check.h"
#include "app/render/annotation.h"
#include "app/render/overlay.h"
#include "app/render/png.h"
#include "app/render/renderer.h"
#include "app/render/sheet.h"

namespace app {
namespace {

namespace fs = std::filesystem;

/// Largest number of pictures that wait to be annotated and written; each takes width · height · 3
/// bytes.
constexpr std::size_t kMostWaiting = 2;

/// The pictures of a scene, drawn by one camera after the other.
class Drawing {
 public:
  Drawing(const scene::Scene& scene, const assembly::BuiltScene& built, const ShotSpool& shots,
          const PictureTarget& target, const PictureProgress& progress)
      : look_(*scene.render),
        built_(built),
        spec_(built.spec),
        shots_(shots),
        target_(target),
        progress_(progress),
        cameras_(cameras_of(look_)),
        scale_(scale_of_all()),
        paints_(shown_paints(scene, built)),
        renderer_(first_picture(scene), program_files("shaders")),
        notes_(look_, spec_),
        rig_(spec_, look_.show.joints) {
    if (shows_pressures(look_, spec_)) shown_scale_ = scale_;
    if (look_.show.forces || rig_.has_lines())
      for (std::size_t i = 0; i < shots.size(); ++i) include(shots.at(i));
  }

  PictureReport draw() {
    make_folders();
    report_ = {.device = renderer_.device(), .complete = true, .warnings = paints_.warnings};
    if (shown_scale_) report_.pressure_max = scale_.max;
    for (const scene::Camera& camera : cameras_) {
      if (!camera.name.empty()) report_.cameras.push_back(camera.name);
      if (report_.complete) draw(camera);
    }
    return report_;
  }

 private:
  /// Returns the scale for all shots; that of no pressures if pictures show none.
  render::PressureScale scale_of_all() const {
    if (!shows_pressures(look_, spec_)) return pressure_scale(look_, {}, {});
    return pressure_scale(look_, expected_pressure(spec_, look_.shows),
                          pressure_range(spec_, shots_, look_.shows));
  }

  void include(const Shot& shot) {
    notes_.include(shot);
    rig_.include(shot);
  }

  render::Annotations notes_of(const Shot& shot) const {
    render::Annotations notes = notes_.of(shot, render::picture_size(renderer_.view()));
    rig_.explain(notes);
    return notes;
  }

  render::SceneDescription first_picture(const scene::Scene& scene) const {
    render::SceneDescription first = picture_of(scene, built_, scale_, paints_);
    if (shots_.size() > 0) first.camera = camera_at(cameras_.front(), built_, shots_.at(0));
    return first;
  }

  /// Makes an empty folder for the frames of each camera.
  void make_folders() const {
    remove_pictures(target_.folder);
    for (const scene::Camera& camera : cameras_) {
      const fs::path frames = frame_file(target_.folder, camera.name, 0).parent_path();
      std::error_code error;
      fs::create_directories(frames, error);
      if (error) throw render::Error(fmt::format("{}: {}", frames.string(), error.message()));
    }
  }

  void draw(const scene::Camera& camera) {
    std::optional<Video> video = video_of(camera);
    render::Annotations lines;
    rig_.explain(lines);
    render::ContactSheet sheet(shown_scale_, look_.sheet_columns, lines.ramp);
    std::size_t frames = 0;
    Trail trail(spec_, camera.follow);
    Background finishing(spec_.threads, kMostWaiting);
    for (std::size_t i = 0; i < shots_.size(); ++i) {
      const Shot shot = shots_.at(i);
      const bool of_video = shot.video && video;
      if (look_.show.trail) trail.add(shot);
      if (shot.frame || of_video) {
        renderer_.look(camera_at(camera, built_, shot));
        render::Rigging rigging = rig_.of(shot);
        if (look_.show.trail) trail.draw(rigging);
        const fs::path file =
            shot.frame ? frame_file(target_.folder, camera.name, frames++) : fs::path();
        finishing.put([this, &sheet, &video, time = shot.time, of_video, file,
                       view = renderer_.view(), grid = renderer_.grid(), notes = notes_of(shot),
                       image = renderer_.draw(shot.states, shot.time, shot.interiors, rigging,
                                              shot.water ? &*shot.water : nullptr)]() mutable {
          render::annotate(image, view, notes);
          if (!file.empty()) sheet.add(image, time);
          if (look_.overlay) {
            render::add_legend(image, view, notes);
            render::add_overlay(image, shown_scale_, time, grid);
          }
          if (!file.empty()) render::write_png(image, file);
          if (of_video) video->add(image);
        });
      }
      report_.frames += shot.frame;
      if (of_video) ++report_.videos.back().pictures;
      const int all = static_cast<int>(shots_.size() * cameras_.size());
      report_.complete = progress_(++drawn_, all) || drawn_ == all;
      if (!report_.complete) break;
    }
    if (frames > 0)
      finishing.put(
          [&] { render::write_png(sheet.image(), sheet_file(target_.folder, camera.name)); });
    if (video) finishing.put([&video] { video->finish(); });
    finishing.finish();
  }

  /// Starts the video of a camera; none if no shot belongs to a video, or if it is another's.
  std::optional<Video> video_of(const scene::Camera& camera) {
    const VideoOptions& wanted = target_.video;
    const std::optional<fs::path> file = video_by(wanted, camera, cameras_.size());
    if (shots_.of_video() == 0 || !file) return std::nullopt;
    const VideoShape shape = {.width = look_.size[0],
                              .height = look_.size[1],
                              .fps = wanted.fps,
                              .threads = spec_.threads};
    report_.videos.push_back({.file = *file, .pictures = 0, .fps = shape.fps});
    return std::optional<Video>(std::in_place, *file, shape);
  }

  const scene::Render& look_;
  const assembly::BuiltScene& built_;
  const engine::SimulationSpec& spec_;
  const ShotSpool& shots_;
  const PictureTarget& target_;
  const PictureProgress& progress_;
  const std::vector<scene::Camera> cameras_;
  const render::PressureScale scale_;
  const Paints paints_;
  std::optional<render::PressureScale> shown_scale_;  ///< None if pictures show no pressures.
  render::Renderer renderer_;
  ForceAnnotations notes_;
  RigPictures rig_;
  PictureReport report_;
  int drawn_ = 0;
};

}  // namespace

render::SceneDescription picture_of(const scene::Scene& scene, const assembly::BuiltScene& built,
                                    const render::PressureScale& scale, const Paints& paints) {
  const scene::Render& look = *scene.render;
  const engine::SimulationSpec& spec = built.spec;
  render::SceneDescription picture{.width = look.size[0],
                                   .height = look.size[1],
                                   .pressure = scale,
                                   .sea = spec.sea,
                                   .ripple = cell_of_waves(scene, spec),
                                   .grid_visible = look.grid,
                                   .pressure_visible = look.pressure_shown,
                                   .bold_waterline = look.show.waterline,
                                   .wireframe = look.show.wireframe};
  for (std::size_t i = 0; i < spec.bodies.size(); ++i)
    picture.bodies.push_back(
        {.mesh_B = spec.bodies[i].mesh_B,
         .color = scene.bodies[i].color,
         .paint = paints.of_bodies[i],
         .coefficients = spec.bodies[i].coefficients,
         .hollows = hollows_of(spec.bodies[i]),
         .up_B = spec.bodies[i].initial.orientation.conjugate() * Eigen::Vector3d::UnitZ()});
  if (const auto* plane = std::get_if<engine::PlaneGround>(&spec.ground))
    picture.ground_z = plane->z;
  if (const auto* mesh = std::get_if<engine::MeshGround>(&spec.ground))
    picture.ground_W = mesh->mesh_W;
  return picture;
}

bool shows_pressures(const scene::Render& look, const engine::SimulationSpec& spec) {
  return look.pressure_shown && spec.sea;
}

std::vector<std::string> videos_made(const PictureReport& report) {
  std::vector<std::string> lines;
  for (const VideoReport& video : report.videos)
    lines.push_back(fmt::format("{}: {:g} s, {} pictures at {} a second", video.file.string(),
                                static_cast<double>(video.pictures) / video.fps, video.pictures,
                                video.fps));
  return lines;
}

PictureReport draw_pictures(const scene::Scene& scene, const assembly::BuiltScene& built,
                            const ShotSpool& shots, const PictureTarget& target,
                            const PictureProgress& progress) {
  return Drawing(scene, built, shots, target, progress).draw();
}

}  // namespace app

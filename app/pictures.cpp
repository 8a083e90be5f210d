#include "app/pictures.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <system_error>
#include <utility>

#include "app/background.h"
#include "app/force_notes.h"
#include "app/pressure_range.h"
#include "app/program_files.h"
#include "app/render/annotation.h"
#include "app/render/overlay.h"
#include "app/render/png.h"
#include "app/render/renderer.h"
#include "app/render/sheet.h"

namespace app {
namespace {

/// Pictures that may wait to be labelled and written; each takes width · height · 3 bytes.
constexpr std::size_t kMostWaiting = 2;

const char* const kFramesFolder = "frames";  ///< Their folder in that of the run.

}  // namespace

render::Picture picture_of(const Scene& scene, const engine::SimulationSpec& spec,
                           const render::PressureScale& scale) {
  const RenderScene& look = *scene.render;
  render::Picture picture{.width = look.size[0],
                          .height = look.size[1],
                          .camera = {look.camera.from, look.camera.to, look.camera.field_of_view},
                          .pressure = scale,
                          .sea = spec.sea,
                          .bold_waterline = look.show.waterline,
                          .wireframe = look.show.wireframe};
  for (std::size_t i = 0; i < spec.bodies.size(); ++i)
    picture.bodies.push_back({.mesh_B = spec.bodies[i].mesh_B,
                              .color = scene.bodies[i].color,
                              .coefficients = spec.bodies[i].coefficients});
  if (const auto* plane = std::get_if<engine::PlaneGround>(&spec.ground))
    picture.ground_z = plane->z;
  if (const auto* mesh = std::get_if<engine::MeshGround>(&spec.ground))
    picture.ground_W = mesh->mesh_W;
  return picture;
}

namespace {

/// Makes an empty folder for the frames.
void make_fresh_frames(const std::filesystem::path& folder) {
  remove_pictures(folder);
  const std::filesystem::path frames = folder / kFramesFolder;
  std::error_code error;
  std::filesystem::create_directories(frames, error);
  if (error) throw render::Error(fmt::format("{}: {}", frames.string(), error.message()));
}

bool is_frame(const std::filesystem::path& file) {
  return file.filename().string().starts_with("frame_") && file.extension() == ".png";
}

}  // namespace

std::filesystem::path frame_file(const std::filesystem::path& folder, std::size_t number) {
  return folder / kFramesFolder / fmt::format("frame_{:04}.png", number);
}

void remove_pictures(const std::filesystem::path& folder) {
  const std::filesystem::path frames = folder / kFramesFolder;
  std::filesystem::remove(folder / "sheet.png");
  if (!std::filesystem::is_directory(frames)) return;
  std::vector<std::filesystem::path> old;
  for (const auto& entry : std::filesystem::directory_iterator(frames))
    if (is_frame(entry.path())) old.push_back(entry.path());
  for (const std::filesystem::path& file : old) std::filesystem::remove(file);
  if (std::filesystem::is_empty(frames)) std::filesystem::remove(frames);
}

PictureReport draw_pictures(const Scene& scene, const Assembly& assembly,
                            const std::vector<Shot>& shots, const std::filesystem::path& folder,
                            const PictureProgress& progress) {
  const render::PressureScale scale = pressure_scale(*scene.render, assembly.spec, shots);
  render::Renderer renderer(picture_of(scene, assembly.spec, scale), program_files("shaders"));
  make_fresh_frames(folder);
  std::optional<render::PressureScale> shown;
  if (assembly.spec.sea) shown = scale;
  const render::View view = renderer.view();
  const double grid = renderer.grid();
  const ForceNotes notes(*scene.render, assembly.spec, shots, render::picture_size(view));
  render::ContactSheet sheet(shown);
  PictureReport report{.device = renderer.device(), .pressure_max = scale.max};
  Background finishing(assembly.spec.threads, kMostWaiting);
  for (const Shot& shot : shots) {
    const auto number = static_cast<std::size_t>(report.frames++);
    const std::filesystem::path file = frame_file(folder, number);
    render::Image image = renderer.draw(shot.states, shot.time);
    finishing.put(
        [&, time = shot.time, note = notes.of(shot), file, image = std::move(image)]() mutable {
          render::annotate(image, view, note);
          sheet.add(image, time);
          render::add_legend(image, view, note);
          render::add_overlay(image, shown, time, grid);
          render::write_png(image, file);
        });
    if (!progress(report.frames, static_cast<int>(shots.size()))) break;
  }
  if (report.frames > 0)
    finishing.put([&] { render::write_png(sheet.image(), folder / "sheet.png"); });
  finishing.finish();
  return report;
}

}  // namespace app

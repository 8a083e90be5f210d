#include "app/pictures.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "app/background.h"
#include "app/program_files.h"
#include "app/render/overlay.h"
#include "app/render/png.h"
#include "app/render/renderer.h"
#include "app/render/sheet.h"

namespace app {
namespace {

/// Pictures that may wait to be labelled and written; each takes width · height · 3 bytes.
constexpr std::size_t kMostWaiting = 2;

const char* const kFramesFolder = "frames";  ///< Their folder in that of the run.

/// Pressure drag counts with each face's own normal, so that flat sides show one pressure.
double highest_pressure(const engine::BodySpec& body, const hydro::BodyState& state,
                        const hydro::Sea& sea, double time) {
  const Eigen::Matrix3d R = state.orientation.toRotationMatrix();
  const Eigen::Matrix3Xd r = R * body.mesh_B.vertices;
  const hydro::Twist motion{state.linear_velocity - sea.current, state.angular_velocity};
  const hydro::PressureDrag& drag = body.coefficients.pressure_drag;
  const double scale = hydro::drag_scale(body.coefficients, state, sea.current);
  double highest = 0;
  for (Eigen::Index face = 0; face < body.mesh_B.face_count(); ++face) {
    const Eigen::Vector3d n = R * hydro::area_vector(body.mesh_B, face).normalized();
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d p = r.col(body.mesh_B.faces(i, face));
      const Eigen::Vector3d p_W = state.position + p;
      const double depth = hydro::surface_height(sea, p_W.x(), p_W.y(), time) - p_W.z();
      if (depth <= 0) continue;
      const double u = motion.at(p).dot(n);
      const double c_p = u > 0 ? drag.front : drag.back;
      highest = std::max(highest,
                         sea.density * (sea.gravity * depth + 0.5 * scale * c_p * u * std::abs(u)));
    }
  }
  return highest;
}

/// The next of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten: an end for a scale.
double rounded_up(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (value <= step * decade * (1 + 1e-9)) return step * decade;
  return 10 * decade;
}

render::PressureScale pressure_scale(const RenderScene& look, const engine::SimulationSpec& spec,
                                     const std::vector<Shot>& shots) {
  render::PressureScale scale{look.pressure_min, look.pressure_max.value_or(0)};
  if (look.pressure_max) return scale;
  double highest = 0;
  for (const Shot& shot : shots) highest = std::max(highest, highest_pressure(spec, shot));
  constexpr double kLeastSpan = 1;  // [Pa], for scenes in which nothing gets wet
  scale.max = highest > scale.min + kLeastSpan ? rounded_up(highest) : scale.min + 1000;
  return scale;
}

render::Picture picture(const Scene& scene, const engine::SimulationSpec& spec,
                        const render::PressureScale& scale) {
  const RenderScene& look = *scene.render;
  render::Picture picture{.width = look.size[0],
                          .height = look.size[1],
                          .camera = {look.camera.from, look.camera.to, look.camera.field_of_view},
                          .pressure = scale,
                          .sea = spec.sea};
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

double highest_pressure(const engine::SimulationSpec& spec, const Shot& shot) {
  double highest = 0;
  if (!spec.sea) return highest;
  for (std::size_t i = 0; i < spec.bodies.size(); ++i)
    highest =
        std::max(highest, highest_pressure(spec.bodies[i], shot.states[i], *spec.sea, shot.time));
  return highest;
}

PictureReport draw_pictures(const Scene& scene, const Assembly& assembly,
                            const std::vector<Shot>& shots, const std::filesystem::path& folder,
                            const PictureProgress& progress) {
  const render::PressureScale scale = pressure_scale(*scene.render, assembly.spec, shots);
  render::Renderer renderer(picture(scene, assembly.spec, scale), program_files("shaders"));
  make_fresh_frames(folder);
  std::optional<render::PressureScale> shown;
  if (assembly.spec.sea) shown = scale;
  render::ContactSheet sheet(shown);
  PictureReport report{.device = renderer.device(), .pressure_max = scale.max};
  Background finishing(assembly.spec.threads, kMostWaiting);
  for (const Shot& shot : shots) {
    const auto number = static_cast<std::size_t>(report.frames++);
    const std::filesystem::path file = frame_file(folder, number);
    render::Image image = renderer.draw(shot.states, shot.time);
    finishing.put([&sheet, &shown, time = shot.time, file, image = std::move(image)]() mutable {
      sheet.add(image, time);
      render::add_overlay(image, shown, time);
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

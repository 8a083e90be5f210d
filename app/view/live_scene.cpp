#include "app/view/live_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/base/console.h"
#include "app/base/program_files.h"
#include "app/pictures/bodies_waves.h"
#include "app/pictures/expected_pressure.h"
#include "app/pictures/interiors.h"
#include "app/pictures/paints.h"
#include "app/pictures/pictures.h"
#include "app/render/overlay.h"

namespace app {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

LiveScene::LiveScene(const scene::Scene& scene, const assembly::BuiltScene& built)
    : scene_(scene),
      built_(built),
      spec_(built.spec),
      simulation_(built.spec),
      notes_(*scene.render, built.spec),
      rig_(built.spec, scene.render->show.joints),
      waves_(unfelt_waves()),
      expected_(expected_pressure(spec_, scene.render->shows)),
      scale_(pressure_scale(*scene.render, expected_, range_)) {}

std::optional<hydro::SimulatedWater> LiveScene::unfelt_waves() const {
  if (simulation_.water()) return std::nullopt;
  return bodies_waves(scene_, spec_);
}

void LiveScene::restart() {
  simulation_.reset();
  waves_ = unfelt_waves();
  held_.reset();
}

void LiveScene::hold(const std::optional<Controls::Held>& held) {
  if (held_ && (!held || held->body != *held_)) simulation_.pull(*held_, std::nullopt);
  held_.reset();
  if (!held) return;
  simulation_.pull(held->body, held->pull);
  held_ = held->body;
}

long LiveScene::advance(long steps, double longest) {
  const auto end = Clock::now() + std::chrono::duration<double>(longest);
  long taken = 0;
  while (taken < steps && (taken == 0 || Clock::now() < end)) {
    simulation_.step();
    if (waves_) waves_->follow(simulation_.time(), simulation_.states());
    ++taken;
  }
  return taken;
}

Shot LiveScene::now() const {
  const hydro::SimulatedWater* water = waves_ ? &*waves_ : simulation_.water();
  return {.time = simulation_.time(),
          .states = simulation_.states(),
          .interiors = drawn_interiors(simulation_.interiors()),
          .rig = drawn_rig(simulation_.rig()),
          .water = water ? water->patch(simulation_.time()) : std::nullopt};
}

void LiveScene::grow_scale(const Shot& now) {
  if (!shows_pressures(*scene_.render, spec_)) return;
  range_.include(pressure_range(spec_, now, scene_.render->shows));
  scale_ = pressure_scale(*scene_.render, expected_, range_);
}

void LiveScene::make_ready(const Shot& now, const render::Camera& camera, int width, int height) {
  grow_scale(now);
  notes_.include(now);
  rig_.include(now);
  if (!renderer_) {
    const Paints paints = shown_paints(scene_, built_);
    for (const std::string& warning : paints.warnings) say("warning: " + warning);
    render::SceneDescription look = picture_of(scene_, built_, scale_, paints);
    look.width = width;
    look.height = height;
    look.camera = camera;
    renderer_.emplace(std::move(look), program_files("shaders"));
  }
  renderer_->show_pressures(scale_);
  renderer_->resize(width, height);
  renderer_->look(camera);
}

render::Image LiveScene::picture(const render::Camera& camera, int width, int height,
                                 const std::string& note) {
  const Shot shot = now();
  make_ready(shot, camera, width, height);
  const render::View& view = renderer_->view();
  render::Annotations notes = notes_.of(shot, render::picture_size(view));
  rig_.explain(notes);
  render::Image image = renderer_->draw(shot.states, shot.time, shot.interiors, rig_.of(shot),
                                        shot.water ? &*shot.water : nullptr);
  render::annotate(image, view, notes);
  if (!scene_.render->overlay) return image;
  render::add_legend(image, view, notes);
  std::vector<std::string> more;
  if (!note.empty()) more.push_back(note);
  std::optional<render::PressureScale> shown;
  if (shows_pressures(*scene_.render, spec_)) shown = scale_;
  render::add_overlay(image, shown, shot.time, renderer_->grid(), more);
  return image;
}

}  // namespace app

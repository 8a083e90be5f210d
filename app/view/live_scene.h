#pragma once

#include <optional>
#include <string>

#include "app/assembly/built_scene.h"
#include "app/pictures/force_annotations.h"
#include "app/pictures/pressure_range.h"
#include "app/render/renderer.h"
#include "app/scene/scene.h"
#include "app/view/controls.h"
#include "engine/simulation.h"

namespace app {

/// A camera from which all bodies are seen where they start.
render::Camera framing(const engine::SimulationSpec& spec);

/// A scene that is played: its simulation, and pictures of where it has come to.
class LiveScene {
 public:
  /// Both must outlive it.
  /// @param scene   With a render block.
  LiveScene(const scene::Scene& scene, const assembly::BuiltScene& built);

  const engine::Simulation& simulation() const { return simulation_; }

  /// From the start again, nothing held.
  void restart();
  /// Draws a body by hand from now on, none of the others.
  void hold(const std::optional<Controls::Held>& held);
  /// Takes so many steps, fewer if they take longer than that on the clock [s], but at least one.
  /// @return how many it took. @throws engine::SimulationError
  long advance(long steps, double longest);

  /// With what a picture of the scene has, and a note below the time, unless it is empty. Automatic
  /// scales grow with the highest pressures and forces so far.
  /// @throws render::Error
  render::Image picture(const render::Camera& camera, int width, int height,
                        const std::string& note);

 private:
  Shot now() const;
  void grow_scale(const Shot& now);
  void make_ready(const Shot& now, const render::Camera& camera, int width, int height);

  const scene::Scene& scene_;
  const engine::SimulationSpec& spec_;
  engine::Simulation simulation_;
  std::optional<engine::BodyId> held_;
  ForceAnnotations notes_;
  PressureRange range_;  ///< Of the pressures so far.
  render::PressureScale scale_;
  std::optional<render::Renderer> renderer_;  ///< None before the first picture.
};

}  // namespace app

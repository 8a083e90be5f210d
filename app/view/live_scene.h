#pragma once

#include <optional>
#include <string>

#include "app/assembly/built_scene.h"
#include "app/pictures/force_annotations.h"
#include "app/pictures/pressure_range.h"
#include "app/pictures/rigging.h"
#include "app/render/renderer.h"
#include "app/scene/scene.h"
#include "app/view/controls.h"
#include "engine/simulation.h"
#include "hydro/water/simulated_water.h"

namespace app {

/// A scene that is played: its simulation and pictures of its present state.
class LiveScene {
 public:
  /// Both arguments must outlive the object.
  /// @param scene   Scene with a render block.
  LiveScene(const scene::Scene& scene, const assembly::BuiltScene& built);

  const engine::Simulation& simulation() const { return simulation_; }

  /// Restarts the simulation and releases the held body.
  void restart();
  /// Pulls the held body from now on, and no other.
  void hold(const std::optional<Controls::Held>& held);
  /// Takes up to `steps` steps, and stops early, after at least one, when `longest` clock time [s]
  /// has passed.
  /// @return the number of steps taken. @throws engine::SimulationError
  long advance(long steps, double longest);

  /// Draws a picture with all the annotations that the scene asks for, and a note below the time
  /// unless it is empty. Automatic scales grow with the largest pressures, forces and tensions so
  /// far.
  /// @throws render::Error
  render::Image picture(const render::Camera& camera, int width, int height,
                        const std::string& note);

 private:
  std::optional<hydro::SimulatedWater> unfelt_waves() const;
  Shot now() const;
  void grow_scale(const Shot& now);
  void make_ready(const Shot& now, const render::Camera& camera, int width, int height);

  const scene::Scene& scene_;
  const assembly::BuiltScene& built_;
  const engine::SimulationSpec& spec_;
  engine::Simulation simulation_;
  std::optional<engine::BodyId> held_;
  ForceAnnotations notes_;
  RigPictures rig_;
  /// Waves that the bodies make and do not feel; none if they are not drawn.
  std::optional<hydro::SimulatedWater> waves_;
  PressureRange expected_;  ///< From the scene alone.
  PressureRange range_;     ///< Range of the pressures so far.
  render::PressureScale scale_;
  std::optional<render::Renderer> renderer_;  ///< Made for the first picture.
};

}  // namespace app

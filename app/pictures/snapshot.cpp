#include "app/pictures/snapshot.h"

#include <utility>

#include "app/base/program_files.h"
#include "app/pictures/cameras.h"
#include "app/pictures/expected_pressure.h"
#include "app/pictures/interiors.h"
#include "app/pictures/paints.h"
#include "app/pictures/pictures.h"
#include "app/pictures/pressure_range.h"
#include "app/pictures/rigging.h"
#include "app/render/annotation.h"
#include "app/render/overlay.h"

namespace app {
namespace {

/// Returns the scene with a render block.
scene::Scene with_look(scene::Scene scene) {
  if (!scene.render) scene.render.emplace();
  return scene;
}

/// Returns the look of pictures without waves of bodies: they follow from a motion, and a snapshot
/// has one state.
render::SceneDescription still_look(const scene::Scene& scene, const assembly::BuiltScene& built,
                                    const render::PressureScale& scale, const Paints& paints) {
  render::SceneDescription look = picture_of(scene, built, scale, paints);
  look.ripple = 0;
  return look;
}

}  // namespace

struct Snapshots::Impl {
  Impl(const scene::Scene& given, const assembly::BuiltScene& from)
      : scene(with_look(given)),
        built(from),
        spec(from.spec),
        expected(expected_pressure(spec, scene.render->shows)),
        paints(shown_paints(scene, built)),
        renderer(still_look(scene, built, pressure_scale(*scene.render, expected, range), paints),
                 program_files("shaders")),
        rig(spec, scene.render->show.joints) {}

  const scene::Scene scene;
  const assembly::BuiltScene& built;
  const engine::SimulationSpec& spec;
  const PressureRange expected;
  PressureRange range;  ///< Range of the pictures so far.
  const Paints paints;
  render::Renderer renderer;
  RigPictures rig;
};

Snapshots::Snapshots(const scene::Scene& scene, const assembly::BuiltScene& built)
    : impl_(std::make_unique<Impl>(scene, built)) {}
Snapshots::~Snapshots() = default;
Snapshots::Snapshots(Snapshots&&) noexcept = default;

const std::vector<std::string>& Snapshots::warnings() const { return impl_->paints.warnings; }

render::Image Snapshots::draw(const engine::Simulation& simulation, const scene::Camera& camera,
                              const std::array<int, 2>& size, bool overlay) {
  Impl& impl = *impl_;
  const scene::Render& look = *impl.scene.render;
  const Shot shot{.time = simulation.time(),
                  .states = simulation.states(),
                  .interiors = drawn_interiors(simulation.interiors()),
                  .rig = drawn_rig(simulation.rig())};
  impl.rig.include(shot);
  std::optional<render::PressureScale> scale;
  if (shows_pressures(look, impl.spec)) {
    impl.range.include(pressure_range(impl.spec, shot, look.shows));
    scale = pressure_scale(look, impl.expected, impl.range);
    impl.renderer.show_pressures(*scale);
  }
  impl.renderer.resize(size[0], size[1]);
  impl.renderer.look(camera_at(camera, impl.built, shot));
  render::Image image =
      impl.renderer.draw(shot.states, shot.time, shot.interiors, impl.rig.of(shot));
  if (!overlay) return image;
  render::Annotations notes;
  impl.rig.explain(notes);
  render::add_legend(image, impl.renderer.view(), notes);
  render::add_overlay(image, scale, shot.time, impl.renderer.grid());
  return image;
}

}  // namespace app

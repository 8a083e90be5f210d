#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/scene/scene.h"
#include "engine/simulation.h"

namespace render {
struct Image;
}

namespace app {

/// Draws single pictures of a simulation as it goes on, with time and colour scale. Ends
/// of the scale that are found from the pictures enclose the states drawn so far. One thread uses
/// it at a time.
class Snapshots {
 public:
  /// @param scene   It may lack a render block. It and what is built from it must outlive this.
  /// @throws render::Error without graphics
  Snapshots(const scene::Scene& scene, const assembly::BuiltScene& built);
  ~Snapshots();
  Snapshots(Snapshots&&) noexcept;

  /// Tells of textures that cannot be read.
  const std::vector<std::string>& warnings() const;

  /// @param size   [px]
  /// @param overlay   False: without text, scales and legends. @throws render::Error if the device
  /// cannot draw this size
  render::Image draw(const engine::Simulation& simulation, const scene::Camera& camera,
                     const std::array<int, 2>& size, bool overlay);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace app

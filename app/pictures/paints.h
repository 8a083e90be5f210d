#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/render/body_appearance.h"
#include "app/scene/scene.h"

namespace app {

/// The colours and textures of the bodies' mesh files.
struct Paints {
  /// For each body; null for one whose scene gives it a `color`, or whose shape is no mesh file
  /// with colours.
  std::vector<std::shared_ptr<const render::Paint>> of_bodies;
  std::vector<std::string> warnings;  ///< Of textures that cannot be read.
};

/// Reads the colours of the mesh files (mesh_paint.h) and decodes their textures. Faces with a
/// texture have its mean as their colour.
Paints read_paints(const scene::Scene& scene, const assembly::BuiltScene& built);

/// Reads them if the pictures of a scene with a render block show them; else returns null for each
/// body and reads nothing.
Paints shown_paints(const scene::Scene& scene, const assembly::BuiltScene& built);

}  // namespace app

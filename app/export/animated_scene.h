#pragma once

#include "app/export/glb.h"
#include "app/pictures/shot_spool.h"

namespace assembly {
struct BuiltScene;
}
namespace scene {
struct Scene;
}

namespace app {

struct Paints;

struct AnimationOptions {
  int water_cells = 64;  ///< Cells of the water along a side; 0: no water.
};

/// Returns a run as an animated scene in glTF, in metres with y up.
///
/// A node stands for each body, and for each propeller, foil, anchor and fixed end of a line; its
/// place and attitude are animated at the times of the shots, linear between them. The water's
/// surface and lines change their shape: they are sampled at up to kMostSamples of these times, as
/// morph targets whose weights are linear between them. The water is a square about the paths of
/// the bodies. The ground stands still, and each of the scene's cameras moves as in its pictures.
/// Colours are those of the scene, or of mesh files where a body has no `color`, with the means of
/// textures over faces; they show no pressure, and the water in hollows is left out.
///
/// @param scene   It has a render block.
/// @param paints  The colours of mesh files (paints.h).
/// @param shots   At least one; those of its video and the last are exported, or all if it has
/// none.
Glb animated_scene(const scene::Scene& scene, const assembly::BuiltScene& built,
                   const Paints& paints, const ShotSpool& shots, const AnimationOptions& options);

}  // namespace app

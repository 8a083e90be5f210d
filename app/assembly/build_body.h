#pragma once

#include "app/assembly/build_shape.h"
#include "app/assembly/built_scene.h"

namespace assembly {

/// Adds the bodies of a scene in their places, with their meshes, masses, hollows and coefficients.
/// Bodies that differ in name, place, contact and loads alone are made once, and copied.
void build_bodies(BuiltScene& built, BuildLog& log);

}  // namespace assembly

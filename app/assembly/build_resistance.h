#pragma once

#include <filesystem>
#include <optional>

#include "app/assembly/build_shape.h"
#include "app/assembly/built_scene.h"
#include "app/assembly/radiation_choice.h"
#include "app/base/reporter.h"
#include "app/scene/scene.h"

/// @file
/// The resistance of hulls along their motion, by `hydro.resistance`.
///
/// A table is that of its body. The waves are those of all bodies that fixed joints hold together;
/// the first with the key has them, and the others none.

namespace assembly {

/// Reads the tables, and makes thin ships of the hulls in their poses at rest. A body that cannot
/// have what its key asks for is a fault at the key; so is one whose waves simulated water has.
/// @param radiation   Per body.
/// @param built       With bodies, sea, ground, joints and lines.
void choose_resistances(const scene::Scene& scene, const std::vector<RadiationChoice>& radiation,
                        BuiltScene& built, BuildLog& log);

/// Gives the bodies with thin ships the resistance of their waves, solved or from the store. Equal
/// hulls share it.
/// @param folder   Folder of the store; none: nothing is kept.
void solve_resistances(BuiltScene& built, const std::optional<std::filesystem::path>& folder,
                       app::Reporter& reporter);

}  // namespace assembly

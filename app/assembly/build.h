#pragma once

#include "app/assembly/added_mass_store.h"
#include "app/assembly/built_scene.h"
#include "app/base/reporter.h"
#include "app/scene/scene.h"

namespace assembly {

/// Loads the meshes and height fields that a scene names, checks them, finds masses, centres of
/// mass and inertias, and gives each body its model of added mass. A solution of added mass that
/// the store lacks is solved for, which may take minutes, and kept there.
/// @param reporter   Is told the notes of the scene, what takes time, and warnings of the store.
/// @throws InputError with every fault found, at the place of its key in the scene
BuiltScene build(const scene::Scene& scene, AddedMassStore& store,
                 app::Reporter& reporter = app::quiet());

/// The same on so many threads, which the simulation will use too.
BuiltScene build_on_threads(int threads, const scene::Scene& scene, AddedMassStore& store,
                            app::Reporter& reporter = app::quiet());

/// The same but for the added mass, which no body has then: for those who only look at the scene.
BuiltScene build_without_added_mass(const scene::Scene& scene);

/// Keeps what the models of `surface` have solved for while the scene was simulated.
void keep_solutions(const BuiltScene& built, const AddedMassStore& store,
                    app::Reporter& reporter = app::quiet());

}  // namespace assembly

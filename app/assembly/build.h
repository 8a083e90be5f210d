#pragma once

#include "app/assembly/added_mass_store.h"
#include "app/assembly/built_scene.h"
#include "app/base/reporter.h"
#include "app/scene/scene.h"

/// @file
/// Makes a simulation of a scene.

namespace assembly {

/// Loads and checks the meshes and height fields that a scene names, computes masses, centres of
/// mass and inertias, and gives each body its model of added mass, and the waves that it makes. A
/// solution that the store lacks is computed, which may take minutes, and stored; those of
/// radiation lie in the same folder.
/// @param reporter   Receives notes on the scene, long computations and warnings of the store.
/// @throws InputError with every fault found, at the place of its key in the scene
BuiltScene build(const scene::Scene& scene, AddedMassStore& store,
                 app::Reporter& reporter = app::quiet());

/// Does as `build` on `threads` threads, which the simulation will use too.
BuiltScene build_on_threads(int threads, const scene::Scene& scene, AddedMassStore& store,
                            app::Reporter& reporter = app::quiet());

/// Does as `build` but gives no body added mass or radiation, for callers that run no simulation.
BuiltScene build_without_added_mass(const scene::Scene& scene);

/// Stores the nodes that the `surface` models have solved during the simulation.
void keep_solutions(const BuiltScene& built, const AddedMassStore& store,
                    app::Reporter& reporter = app::quiet());

}  // namespace assembly

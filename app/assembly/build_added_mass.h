#pragma once

#include <string>

#include "app/assembly/added_mass_store.h"
#include "app/assembly/built_scene.h"
#include "app/base/reporter.h"
#include "app/scene/scene.h"

/// @file
/// From what a scene says of added mass to the models that the simulation asks.

namespace assembly {

/// The solution of a mesh, from the store or else found now and kept there. Of several processes
/// that look for it at once one solves, and the others wait.
/// @param name   Of the body, for what is told.
/// @throws std::invalid_argument if the mesh encloses nothing
StoredAddedMass solved_added_mass(const std::string& name, const hydro::TriMesh& mesh,
                                  const hydro::AddedMassOptions& options, AddedMassStore& store,
                                  app::Reporter& reporter);

/// Gives its model of added mass to each body that needs one: it is to have added mass, feels the
/// water, and is not held in all six degrees of freedom. Bodies of one mesh share a solution.
/// @throws InputError for a mesh of which none can be found
void add_added_mass(const scene::Scene& scene, BuiltScene& built, AddedMassStore& store,
                    app::Reporter& reporter);

}  // namespace assembly

#pragma once

#include <string>

#include "app/assembly/added_mass_store.h"
#include "app/assembly/built_scene.h"
#include "app/base/reporter.h"
#include "app/scene/scene.h"

/// @file
/// Builds the models of added mass that a scene asks for.

namespace assembly {

/// Returns the solution of a mesh, which is computed and stored if the store lacks it. If several
/// processes need it at once, one computes it and the others wait.
/// @param name   Name of the body in messages.
/// @throws std::invalid_argument if the mesh encloses nothing
StoredAddedMass solved_added_mass(const std::string& name, const hydro::TriMesh& mesh,
                                  const hydro::AddedMassOptions& options, AddedMassStore& store,
                                  app::Reporter& reporter);

/// Returns the model of a body, `deep` in the place of `automatic`; `none` for one with radiation
/// or in a hull with it, on which the water does not act, or which is locked in all six degrees of
/// freedom while forces are not logged.
scene::AddedMass::Model added_mass_model(const scene::Scene& scene, const BuiltScene& built,
                                         std::size_t body);

/// Sets the model of added mass of each body, by added_mass_model; the method `ode` has none.
/// Bodies with equal meshes share a solution.
/// @throws InputError for a mesh that has no solution
void add_added_mass(const scene::Scene& scene, BuiltScene& built, AddedMassStore& store,
                    app::Reporter& reporter);

}  // namespace assembly

#pragma once

#include "app/assembly/assemble.h"

/// @file
/// From what a scene says of added mass to the models that the simulation asks.

namespace app {

/// The solution of a mesh from the store, or else found now and kept there. Of several processes
/// that look for it at once one solves, and the others wait. On a terminal it is said what takes
/// the time, unless quiet.
/// @param name   Of the body, for what is said.
/// @throws std::invalid_argument if the mesh encloses nothing
StoredAddedMass solved_added_mass(const std::string& name, const hydro::TriMesh& mesh,
                                  const hydro::AddedMassOptions& options, AddedMassStore& store,
                                  bool quiet);

/// Gives its model of added mass to each body that needs one: it is to have added mass, feels the
/// water, and is not held in all six degrees of freedom. Bodies of one mesh share a solution.
/// @throws InputError for a mesh of which none can be found
void add_added_mass(const Scene& scene, Assembly& assembly, AddedMassStore& store, bool quiet);

/// Keeps what the models of `surface` have solved in a run.
void keep_surface_nodes(const Assembly& assembly, const AddedMassStore& store);

}  // namespace app

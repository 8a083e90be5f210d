#pragma once

#include "hydro/added_mass/added_mass.h"
#include "hydro/sea.h"

namespace hydro {

/// The added mass of WettedAddedMass::at, summed face by face without a tree or vector lanes: the
/// reference with which tests compare the fast sum. Slow.
/// @param mesh_B     Closed; its origin is the centre of mass.
/// @param solution   The solution for this mesh, about the same origin.
Matrix6d plain_wetted_added_mass(const TriMesh& mesh_B, const AddedMassSolution& solution,
                                 const BodyState& state, const Sea& sea, double time);

/// The load of WettedAddedMass::wave_load, in the same plain way.
Wrench plain_wave_load(const TriMesh& mesh_B, const AddedMassSolution& solution,
                       const BodyState& state, const Sea& sea, double time);

}  // namespace hydro

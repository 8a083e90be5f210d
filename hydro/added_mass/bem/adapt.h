#pragma once

#include <vector>

#include "hydro/added_mass/bem/galerkin.h"

/// @file
/// Which panels resolve the flow too little.

namespace hydro::bem {

/// Edges to halve. The bubble of an edge of length l with coefficient b counts for l b² of the
/// added mass: what halving the edge would gain. The edges with the largest bubbles, over all
/// motions, that together hold a good part of it are chosen; equal ones go together, whatever
/// round-off says. Panels come out thin along an edge of the body, where the flow changes across it
/// only.
///
/// @param weight   For the motions: the inverse of what their added mass, for ρ = 1, is compared
/// to.
std::vector<bool> edges_to_halve(const Surface& surface, const Potential& psi,
                                 const Matrix6d& weight);

}  // namespace hydro::bem

#pragma once

#include <vector>

#include "hydro/added_mass/bem/galerkin.h"

/// @file
/// Choice of the edges to refine.

namespace hydro::bem {

/// Returns for each edge whether to halve it. The bubble of an edge of length l with coefficient b
/// is worth l b² of added mass: the gain from halving the edge. The edges with the largest gains
/// over all motions are chosen until they hold a good part of the total; equal edges are chosen
/// together, whatever their round-off. Panels become thin along an edge of the body, where the flow
/// varies only across it.
/// @param weight   Weights of the motions: inverse of a reference added mass for ρ = 1.
std::vector<bool> edges_to_halve(const Surface& surface, const Potential& psi,
                                 const Matrix6d& weight);

}  // namespace hydro::bem

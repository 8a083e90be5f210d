#pragma once

#include "hydro/added_mass/bem/galerkin.h"

/// @file
/// The plain method: ψ constant on each face, its equation met at the centroids,
/// ½ψ + (1/4π) Σ ψ_T Ω_T = (1/4π) Σ N_T ∫_T 1/r, with solid angles Ω and N at the centroids.

namespace hydro::bem {

/// A row a face. A cavity's ψ, of which the equation leaves a constant free, has a mean of 0.
Potential collocate(const Surface& surface);

}  // namespace hydro::bem

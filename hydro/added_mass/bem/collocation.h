#pragma once

#include "hydro/added_mass/bem/galerkin.h"

/// @file
/// The collocation method: ψ is constant on each face and satisfies ½ψ + (1/4π) Σ ψ_T Ω_T = (1/4π)
/// Σ N_T ∫_T 1/r at the centroids, with solid angles Ω and N at the centroids.

namespace hydro::bem {

/// Returns ψ, one row per face. The equation leaves a constant of a cavity's ψ free; its mean is
/// set to 0.
Potential collocate(const Surface& surface);

}  // namespace hydro::bem

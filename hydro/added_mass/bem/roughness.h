#pragma once

#include "hydro/added_mass/bem/galerkin.h"

/// @file
/// What continuous functions cannot see of a body's motion.
///
/// Water is pushed by N = (n, r × n), which jumps from facet to facet. What is left of N after the
/// best continuous function drives flows no wider than a panel, of a wavelength h: they hold an
/// added mass of N²/k per area with k ≥ 2π/h. A round body meshed with facets has hardly any other
/// when it turns about its axis, and no solution on its own facets finds it.

namespace hydro::bem {

/// (1/2π) Σ_T h ∫_T N' N'ᵀ dS: N' is N less the quadratic function through its mean at each node, h
/// the width of a panel. What the added mass for ρ = 1 may lack.
Matrix6d roughness(const Surface& surface);

}  // namespace hydro::bem

#pragma once

#include "hydro/added_mass/bem/galerkin.h"

/// @file
/// The part of a body's motion that continuous functions cannot represent.
///
/// The flow is driven by N = (n, r × n), which jumps from facet to facet. The remainder of N after
/// its best continuous approximation drives flows no wider than a panel, of wavelength h, with an
/// added mass of N²/k per area, k ≥ 2π/h. A faceted round body that rotates about its axis has
/// hardly any other added mass, and no solution on its own facets finds it.

namespace hydro::bem {

/// (1/2π) Σ_T h ∫_T N' N'ᵀ dS: the possible deficit of the added mass for ρ = 1. N' is N minus the
/// quadratic function through its mean at each node, h the width of a panel.
Matrix6d facet_error(const Surface& surface);

}  // namespace hydro::bem

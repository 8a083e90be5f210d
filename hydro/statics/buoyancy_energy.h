#pragma once

#include "hydro/loads/loads.h"

namespace hydro {

/// Work needed to push the hull into still water at its present pose [J]: the potential energy of
/// buoyancy. With the depth d over the wet panels,
///
///     U = ρ g ∫ d dV = −ρ g ∫ d²/2 n_z dS.
///
/// The result is exact to round-off. The surface is taken as z = level, whatever the surface of
/// `sea`.
double buoyancy_energy(const Hull& hull, const BodyState& state, const Sea& sea);

}  // namespace hydro

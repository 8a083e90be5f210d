#pragma once

#include "hydro/loads/loads.h"

namespace hydro {

/// Work that it takes to push the hull into still water, as it lies [J]: the potential energy of
/// the buoyancy, with depth d over the wet panels,
///
///     U = ρ g ∫ d dV = −ρ g ∫ d²/2 n_z dS.
///
/// Exact to round-off. The surface is taken as z = level, whatever the sea's.
double buoyancy_energy(const Hull& hull, const BodyState& state, const Sea& sea);

}  // namespace hydro

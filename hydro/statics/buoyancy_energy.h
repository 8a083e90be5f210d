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

/// ∫ d²/2 n_z dS over the faces of a hull below a level, with their depths d under it [m^4]. Of a
/// pocket (hydro/interior) it is ∫ d dV over the water up to that level.
/// @param R_WB    Orientation of the hull.
/// @param level   Height above the centre of mass [m].
double depth_moment(const Hull& hull, const Eigen::Matrix3d& R_WB, double level);

}  // namespace hydro

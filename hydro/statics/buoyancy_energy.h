#pragma once

#include "hydro/loads/loads.h"

namespace hydro {

/// Work needed to push the hull into still water at its present pose [J]: the potential energy of
/// buoyancy. With the depth d below the local surface over the wet panels,
///
///     U = ρ g ∫ d dV = −ρ g ∫ d²/2 n_z dS.
///
/// It is exact to round-off under a flat surface, and under a height field to what the loads are,
/// whose panels are split in the same way (refine.h). Waves are taken as flat: they have no such
/// energy.
double buoyancy_energy(const Hull& hull, const BodyState& state, const Sea& sea);

/// Error of changes of U by the splitting of panels, per volume of the hull [J/m^3]: ρ g
/// kSagTolerance times the deviation of a height field, and 0 under a flat surface.
double energy_error_per_volume(const Sea& sea);

/// ∫ d²/2 n_z dS over the faces of a hull below a level, with their depths d under it [m^4]. For a
/// pocket (hydro/interior) it is ∫ d dV over the water up to that level.
/// @param R_WB    Orientation of the hull.
/// @param level   Height above the centre of mass [m].
double depth_moment(const Hull& hull, const Eigen::Matrix3d& R_WB, double level);

}  // namespace hydro

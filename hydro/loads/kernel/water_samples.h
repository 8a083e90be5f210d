#pragma once

#include <Eigen/Core>

#include "hydro/loads/kernel/load_inputs.h"
#include "hydro/loads/kernel/tree.h"

/// @file
/// The water at many places of a body at once, by the best vector unit that the processor has.

namespace hydro::kernel {

/// Elevation of the surface over places above the still water level [m].
/// @param in    Its surface is that of waves.
/// @param box   The branch that the places are in.
/// @param r     The places in body axes about the centre of mass, in columns [m].
Eigen::VectorXd sample_elevation(const LoadInputs& in, const Node& box, const Eigen::Matrix3Xd& r);

/// Velocity of the water at places relative to `Sea::current`, in body axes [m/s]; above the
/// surface it is that at the surface. The parameters are those of `sample_elevation`.
Eigen::Matrix3Xd sample_velocity(const LoadInputs& in, const Node& box, const Eigen::Matrix3Xd& r);

}  // namespace hydro::kernel

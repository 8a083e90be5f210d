#pragma once

#include "hydro/loads/kernel/load_inputs.h"

/// @file
/// The kernel's way back to the plain viscous drag, for triangles that fit none of its rules.

namespace hydro::kernel {

/// Triangles in body axes about the centre of mass, lane by lane.
struct alignas(64) PlainPanels {
  double r[3][3][kMostLanes];  ///< Vertex, axis, lane [m].
  double n[3][kMostLanes];     ///< Unit normals.
  double linear[3]
               [kMostLanes];  ///< Velocity in the plane relative to the water: linear + spin n × r.
  double spin[kMostLanes];    ///< [rad/s]
  double counts[kMostLanes];  ///< 0 for a lane that is not wanted.
};

/// Adds `viscous_drag_load` of each wanted lane.
void add_plain_viscous(const LoadInputs& in, const PlainPanels& panels, int lanes, Sums& sums);

}  // namespace hydro::kernel

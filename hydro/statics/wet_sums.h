#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/loads/clip.h"
#include "hydro/statics/hydrostatics.h"

/// @file
/// The sums of hydrostatics.h while they are added up.

namespace hydro {

/// An edge of the waterline; seen from above, the waterplane is on its left.
struct WaterlineEdge {
  Eigen::Vector2d from, to;
};

/// Sums over the wet triangles.
struct WetSums {
  double volume = 0;
  Eigen::Vector2d horizontal = Eigen::Vector2d::Zero();  ///< ∫ (x, y) dV
  double depth = 0;                                      ///< ∫ d dV
  double surface = 0;
  std::vector<WaterlineEdge> waterline;
};

/// Adds the part of a triangle that is wet: its terms of (1) to (3), and its edges at the surface.
/// @param depth   Depths of the corners [m].
void add_panel(const Panel& panel_G, const Eigen::Vector3d& depth, WetSums& sums);

/// Returns the hydrostatics that the sums over a closed mesh give.
/// @param height   Height of the centre of mass above the water [m].
Hydrostatics hydrostatics_of(const WetSums& sums, double height);

}  // namespace hydro

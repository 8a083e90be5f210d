#pragma once

#include <memory>
#include <vector>

#include "hydro/interior/interior.h"

/// @file
/// The pockets of a body and their water, as a simulation reports them.

namespace engine {

struct MovingBody;

/// A pocket at an instant.
struct PocketState {
  int id = 0;  ///< It stays while the body's pockets change with its attitude.
  /// Volume of the water in it; in a flooded one, of that below its mouth [m^3].
  double volume = 0;
  double level = 0;  ///< z of its surface in W; NaN without water; of a flooded one the sea's [m].
  double capacity = 0;   ///< Volume below the spill height in this attitude [m^3].
  double spill = 0;      ///< z in W above which it overflows; infinite for a void [m].
  bool flooded = false;  ///< It is a part of the sea.
  double inflow = 0;     ///< Net volume that has come in since the start [m^3].
  double air = 0;        ///< Pressure of its trapped air [Pa]; NaN where none is trapped.
  /// Centroid of its water [m]; NaN without.
  Eigen::Vector3d centroid_W = Eigen::Vector3d::Zero();
};

/// The pockets of a body at an instant.
struct InteriorState {
  std::shared_ptr<const hydro::Interior> interior;  ///< Null if the body has no pocket now.
  std::vector<PocketState> pockets;                 ///< In the order of the interior.
};

/// The pockets of a body at a time [s].
InteriorState interior_state(const MovingBody& moving, double time);

}  // namespace engine

#pragma once

#include "hydro/loads/coefficients.h"

/// @file
/// What a hull meets, as the kernel reads it, and what the kernel makes of it. Body axes about the
/// centre of mass; plain numbers, so that code for several processors can share them.

namespace hydro::kernel {

class WaterSurface;

/// Lanes of the widest vector unit in use.
inline constexpr int kMostLanes = 8;

/// The water around a hull, and its motion in it.
struct LoadInputs {
  double up[3] = {};       ///< Unit vector.
  double below = 0;        ///< Depth of the centre of mass under the surface taken as flat [m].
  double linear[3] = {};   ///< Velocity of the centre of mass relative to the water [m/s].
  double angular[3] = {};  ///< [rad/s]
  bool moving = false;     ///< Relative to the water.
  bool wet = false;        ///< All over: nothing needs to be looked at for the waterline.
  const WaterSurface* surface = nullptr;  ///< Null where the water is flat.
  double wave_error = 0;  ///< Of the elevation, over branches that are taken whole [m].
  bool branches = true;   ///< Branches of the tree may be taken whole.
  double drag_front = 0;  ///< ½ρC_p [kg/m^3].
  double drag_back = 0;
  double lift = 0;  ///< ½ρC_l [kg/m^3].
  double half_density = 0;
  const ViscousDrag* viscous = nullptr;  ///< Null where it is nothing.
};

/// Places of the loads in `Sums`: six components each, force before moment.
enum : int { kBuoyancy = 0, kPressureDrag = 6, kLift = 12, kViscousDrag = 18, kArea = 24, kSums };

/// Sums lane by lane: lanes are added up at the end only, in their order.
template <int kCount>
struct alignas(64) LaneSums {
  double lane[kCount][kMostLanes] = {};

  double total(int which) const {
    double sum = 0;
    for (double value : lane[which]) sum += value;
    return sum;
  }
};

/// Sums of the loads. Buoyancy is ∫ h n dS with its moment, drag and lift are in N.
using Sums = LaneSums<kSums>;

}  // namespace hydro::kernel

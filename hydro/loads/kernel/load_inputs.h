#pragma once

#include "hydro/loads/coefficients.h"

/// @file
/// The inputs of the kernel, the water around a hull and its motion in it, and the sums that it
/// returns. Axes are those of the body, about its centre of mass. All are plain numbers, so that
/// code for several processors can share them.

namespace hydro::kernel {

class WaterSurface;

/// The number of lanes of the widest vector unit in use.
inline constexpr int kMostLanes = 8;

/// The water around a hull, and its motion in it.
struct LoadInputs {
  double up[3] = {};       ///< The vertical, a unit vector.
  double below = 0;        ///< Depth of the centre of mass under the surface taken as flat [m].
  double linear[3] = {};   ///< Velocity of the centre of mass relative to the water [m/s].
  double angular[3] = {};  ///< [rad/s]
  bool slender = false;    ///< K of bluntness.h is not the unit matrix.
  double shape[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< K [-].
  double drag_linear[3] = {};  ///< K times `linear`: pressure drag sees it in place of that.
  bool moving = false;         ///< The hull moves relative to the water.
  bool wet = false;            ///< The hull is wholly submerged: no waterline is sought.
  bool above = false;          ///< The part above the surface is summed.
  const WaterSurface* surface = nullptr;  ///< It is null where the water is flat.
  double wave_error = 0;  ///< Error of the elevation allowed over whole branches [m].
  bool branches = true;   ///< Branches of the tree may be taken whole.
  double drag_front = 0;  ///< ½ρC_p [kg/m^3].
  double drag_back = 0;
  double lift = 0;  ///< ½ρC_l [kg/m^3].
  double half_density = 0;
  const ViscousDrag* viscous = nullptr;  ///< It is null where there is no viscous drag.
};

/// The first row of each load in `Sums`. A load has six rows, force before moment.
/// The volume is there under Airy waves only.
enum : int {
  kBuoyancy = 0,
  kPressureDrag = 6,
  kLift = 12,
  kViscousDrag = 18,
  kArea = 24,
  kVolume = 25,
  kSums
};

/// Sums are kept lane by lane. Lanes are added up at the end only, in their order.
template <int kCount>
struct alignas(64) LaneSums {
  double lane[kCount][kMostLanes] = {};

  double total(int which) const {
    double sum = 0;
    for (double value : lane[which]) sum += value;
    return sum;
  }
};

/// The sums of the loads. Buoyancy is −∫ h n dS with its moment; drag and lift are in N. The force
/// of the pressure drag lacks its factor K.
using Sums = LaneSums<kSums>;

}  // namespace hydro::kernel

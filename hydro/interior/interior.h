#pragma once

#include <memory>

#include "hydro/interior/pockets.h"
#include "hydro/loads/loads.h"

/// @file
/// A body's surface divided into what the sea wets and its pockets, and the water that stands in
/// them.
///
/// The pockets are those of one attitude. They may be used in others as long as no water passes
/// over their sills, or passes there as it would over those of the attitude.

namespace hydro {

/// A body divided into its outside and its pockets. It is constant.
struct Interior {
  Eigen::Vector3d up_B = Eigen::Vector3d::UnitZ();  ///< The vertical for which it was found.
  Pockets division;                                 ///< Faces of each pocket, and the sills.
  Hull outside;               ///< The faces that the sea wets, open at the sills.
  std::vector<Hull> pockets;  ///< The faces of each pocket, open at its sills.
};

/// The interior of a body with this vertical; null if it has no pocket.
std::shared_ptr<const Interior> make_interior(const TriMesh& mesh_B, const Eigen::Vector3d& up_B);

/// Water in a pocket up to a level, a height above the centre of mass.
struct WaterInside {
  double level = 0;   ///< [m]
  double volume = 0;  ///< [m^3]
  double area = 0;    ///< Area of its surface, as far as the search for the level found it [m^2].
  Wrench push;        ///< Its load on the body over ρ g, about the centre of mass in W [m^3, m^4].
};

/// The water in a pocket up to a level.
/// @param R_WB   Orientation of the body.
WaterInside water_up_to(const Hull& pocket, const Eigen::Matrix3d& R_WB, double level);

/// Where the search for a level begins. The result does not depend on it but by round-off.
struct LevelGuess {
  double level = 0;  ///< [m]
  double area = 0;   ///< [m^2]

  friend bool operator==(const LevelGuess&, const LevelGuess&) = default;
};

/// The water of a volume in a pocket. Its level solves V(level) = volume to 1e-13 of the volume, by
/// the secant method in a bracket, which is halved where that creeps. Above the sills it goes on as
/// if walls went straight up from them; a void that is full holds no more. V(level) of a pocket
/// that has been turned over falls again below zero: the lowest level with that volume counts (the
/// other one may be found if the search begins where V has fallen below the volume, but not below
/// zero), and where there is none the pocket is empty.
WaterInside water_of(const Hull& pocket, const Eigen::Matrix3d& R_WB, double volume,
                     const LevelGuess& guess = {});

/// Centroid of the water, about the centre of mass in W axes [m]; zero without water. It holds up
/// to the lowest sill.
Eigen::Vector3d centroid_of(const Hull& pocket, const Eigen::Matrix3d& R_WB,
                            const WaterInside& water);

}  // namespace hydro

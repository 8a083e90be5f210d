#pragma once

#include <array>
#include <memory>
#include <vector>

#include "engine/base/spatial_vector.h"
#include "hydro/interior/interior.h"

/// @file
/// The water in the pockets of a hollow body: part of the motion.
///
/// The water in a pocket has a level surface at any instant. Its load on the body is the pressure
/// ρg (level − z) on the faces of the pocket, so its weight, its levers and the effect of its free
/// surface are exact. The water does not slosh. As a mass it is a point that moves with the body,
/// W = Σ ρV JᵀJ, which is a part of the added mass A of the motion: water that comes in has the
/// velocity of the sea, water that runs out leaves the velocity of the body alone (E4). The point
/// is the mean of the places where water came in, or the centroid anew once the body has turned
/// far. So a body whose water stays has a constant W, and no energy comes or goes with it.
///
/// A flooded pocket is a part of the sea: the sea's pressure acts on its faces. The water below its
/// mouth still moves with the body. Drag does not act on the faces of a pocket.

namespace engine {

struct Body;
struct Motion;

/// The water in a pocket.
struct PocketContent {
  int id = 0;                 ///< It stays as pockets change with the attitude.
  double volume = 0;          ///< Water that moves with the body [m^3].
  double inflow = 0;          ///< Net volume that has come in [m^3].
  bool flooded = false;       ///< The water is a part of the sea.
  double air = 0;             ///< p V of the air in a void that traps it (trapped_air.h) [J].
  hydro::LevelGuess surface;  ///< At the end of the last substep; flooded or dry: of no meaning.
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();  ///< Where its mass is [m].
  Eigen::Vector3d up_B = Eigen::Vector3d::UnitZ();     ///< The vertical for which that was found.

  bool holds() const { return flooded || volume > 0; }
  friend bool operator==(const PocketContent&, const PocketContent&) = default;
};

/// The pockets of a body and their water. It is never changed, but replaced.
struct CarriedWater {
  std::shared_ptr<const hydro::Interior> interior;        ///< Null: the body has no pocket.
  Eigen::Vector3d found_up_B = Eigen::Vector3d::UnitZ();  ///< The vertical for which it was found.
  std::vector<Eigen::Vector3d> known_up_B;                ///< Verticals for which it is right.
  std::vector<PocketContent> pockets;                     ///< In the order of the interior.
  std::vector<std::array<int, 2>> openings;  ///< The pockets, or hydro::kSea, beside each opening.
  std::vector<std::array<int, 2>> pumps;     ///< The same at suction and outlet of each pump.
  Matrix6d inertia_B = Matrix6d::Zero();     ///< W
  int next_id = 0;
  /// Without its pockets, their mouths closed, the body is convex: it has no others.
  bool has_all = false;

  bool holds() const;
};

/// p V of the air in a void at the pressure of the atmosphere, over some water; 0 where no air is
/// trapped [J].
double air_at_rest(const Body& body, const hydro::Pocket& pocket, double water);

/// Volume of the air in a void; a full one keeps a trace, so that quotients are finite [m^3].
double air_volume(const PocketContent& content, double capacity);

/// True if the motion holds water.
bool holds_water(const Motion& motion);

/// The pockets of a body in the attitude `up_B`, dry; null for a body that cannot have any.
std::shared_ptr<CarriedWater> dry_pockets(const Body& body, const Eigen::Vector3d& up_B);

/// The pockets of a body at its start, with its water.
std::shared_ptr<const CarriedWater> water_at_start(const Body& body, const hydro::BodyState& state);

/// The same with the interior that the bytes of a state leave out.
std::shared_ptr<const CarriedWater> completed(const Body& body,
                                              const std::shared_ptr<const CarriedWater>& carried);
/// True if the water may be that of the body.
bool fits_water(const Body& body, const Motion& motion);

/// Updates the surfaces, and the places of masses of which the body has turned far since.
void settle(const Eigen::Matrix3d& R_WB, CarriedWater& carried);

/// W of the pockets' water, of a density [kg/m^3].
Matrix6d water_inertia(const std::vector<PocketContent>& pockets, double density);

/// The surface that the sea wets apart from flooded pockets.
const hydro::Hull& sea_hull(const Body& body, const Motion& motion);

/// The loads on that surface.
hydro::Loads sea_loads(const Body& body, const Motion& motion, const hydro::BodyState& state,
                       double time, const hydro::Coefficients& coefficients,
                       const hydro::LoadAccuracy& how);

/// Adds what the water in the pockets does to the body in a state: that of flooded ones to the
/// loads of the sea.
void add_carried_loads(const Body& body, const CarriedWater& carried, const hydro::BodyState& state,
                       double time, hydro::Loads& loads);

/// Potential energy of the sea on flooded pockets and of the water in the others, with the still
/// water level as its zero [J].
double carried_energy(const Body& body, const CarriedWater& carried, const hydro::BodyState& state);

}  // namespace engine

#pragma once

#include <cmath>
#include <vector>

#include "engine/motion/carried_water.h"

/// @file
/// The spaces between which water runs, the sea and the pockets of one body, and how streams change
/// them (flooding.h).

namespace engine {

/// The water that runs between two spaces.
struct Stream {
  double rate = 0;           ///< Into the first one [m^3/s].
  double sea_level = 0;      ///< Mean over its length, if the second one is the sea.
  double lowest = HUGE_VAL;  ///< Lowest point of its sill or opening.
  bool submerged = true;     ///< All of the sill is below the second one's level.
  double length = 0;         ///< Length of the sill under water [m].
  double head = 0;           ///< What drives it through an opening, in size [m].
};

/// The sea and the pockets of a body at one pose. Heights are above the centre of mass.
class Spaces {
 public:
  Spaces(const Body& body, const hydro::BodyState& state, double time, CarriedWater& carried);

  const Body& body() const { return body_; }
  const hydro::Sea& sea() const { return sea_; }
  const hydro::BodyState& state() const { return state_; }
  double time() const { return time_; }
  const Eigen::Matrix3d& R_WB() const { return R_WB_; }
  const hydro::Pockets& division() const { return division_; }
  CarriedWater& water() const { return water_; }

  bool is_sea(int space) const {
    return space == hydro::kSea || water_.pockets[static_cast<std::size_t>(space)].flooded;
  }
  /// True for a pocket without sills.
  bool is_void(int space) const;
  Eigen::Vector3d vertex(int i) const;
  double sea_level(const Eigen::Vector3d& r) const;
  /// Level of a space at a place; without water −infinity.
  double level(int space, const Eigen::Vector3d& r) const;
  /// Head of the pressure on one side of an opening: of the water above it and of trapped air.
  double head(int space, const Eigen::Vector3d& r) const;
  double volume_up_to(int pocket, double level) const;
  double capacity(int pocket) const {
    return division_.pockets[static_cast<std::size_t>(pocket)].capacity;
  }
  /// The height above which a group of pockets overflows into others, or into the sea alone.
  double spill_of(const std::vector<int>& group, bool into_sea = false) const;

  /// Lets a stream run into the first space, a pocket, for a time h.
  void exchange(int first, int second, const Stream& stream, double h);
  /// Brings a volume of water from a space to another.
  void bring(int from, int to, double volume);
  /// Gives a pocket another volume of water, and its mass another place if some has come in.
  void set_volume(int pocket, double volume);

 private:
  const hydro::Hull& hull(int pocket) const {
    return water_.interior->pockets[static_cast<std::size_t>(pocket)];
  }
  double equalising(int from, int to, const Stream& stream) const;
  double equalising_air(int from, int to, double stiffness, const Stream& stream) const;

  const Body& body_;
  const hydro::Sea& sea_;
  const hydro::BodyState& state_;
  double time_;
  Eigen::Matrix3d R_WB_;
  const hydro::Pockets& division_;
  CarriedWater& water_;
};

}  // namespace engine

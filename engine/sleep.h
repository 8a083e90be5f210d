#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "engine/body.h"
#include "engine/groups.h"
#include "engine/world.h"

/// @file
/// Bodies that rest are left out of the steps until something comes near them.
///
/// Drag that goes with the square of the speed slows a floating body ever less: it comes to rest in
/// no finite time. Putting it to sleep stops it where it is. That takes what is left of its energy,
/// below ½ m limit² a body, and leaves it as far from where it would have come to rest as it swings
/// at that speed.
///
/// An island, bodies that joints or nearness hold together or one by itself, falls asleep when
/// every point of its bodies has been slower than the limit for half the longest period that
/// something of its size swings with, kSlowestSwing: in that time a larger swing would have gone
/// through its middle. Nothing may be about to change: in waves nothing sleeps, nor does an island
/// before the last of its bodies' loads is constant. What drifts with a current does not rest. An
/// island wakes as a whole when the way of a body that is awake crosses the place of one of its
/// bodies; then it moves on from rest.

namespace engine {

class Sleep {
 public:
  using Island = std::vector<BodyId>;

  /// All must outlive it.
  /// @param limit   As Integrator::sleep [m/s].
  Sleep(const World& world, std::vector<Body>& bodies, const Surroundings& around, double limit);

  /// False: nothing ever falls asleep.
  bool possible() const { return limit_ > 0; }
  bool asleep(BodyId id) const {
    return id != kWorld && island_[static_cast<std::size_t>(id)] != nullptr;
  }
  /// True if one of the pair is; in a step's pairs both are, or the other cannot move.
  bool asleep(const Pair& pair) const { return asleep(pair.first) || asleep(pair.second); }
  /// Steps that the body has been left out of.
  long steps(BodyId id) const { return steps_[static_cast<std::size_t>(id)]; }

  /// Wakes what others come near to.
  /// @param boxes   Per body its swept_box, empty for those asleep; filled in for those woken.
  void wake(std::vector<Eigen::AlignedBox3d>& boxes);

  /// Wakes the body with its island.
  void rouse(BodyId id);

  /// After a step [s] to `time` [s]: lays those down that rest.
  /// @param islands   Of the bodies that were awake in it.
  void settle(const std::vector<Island>& islands, double time, double step);

 private:
  /// Wakes the island of a body that sleeps. @return its bodies
  Island woken(BodyId id);
  bool is_still(const Body& body, double time) const;
  bool rests(const Island& island) const;
  void lay_down(const Island& island, double step);
  /// Those whose place a box overlaps.
  std::vector<BodyId> sleepers_in(const Eigen::AlignedBox3d& box) const;
  double left(BodyId id) const { return place_[static_cast<std::size_t>(id)].min().x(); }

  const World& world_;
  std::vector<Body>& bodies_;
  const Surroundings& around_;
  double limit_ = 0;
  std::vector<double> still_;  ///< Per body, how long it has been slow enough [s].
  std::vector<std::shared_ptr<const Island>> island_;  ///< Per body; null: it is awake.
  std::vector<long> steps_;
  std::vector<Eigen::AlignedBox3d> place_;  ///< Per body asleep, its swept_box at rest.
  std::vector<BodyId> by_place_;            ///< Those that collide, by the least x of their place.
  double widest_ = 0;                       ///< Longest of those along x [m].
};

}  // namespace engine

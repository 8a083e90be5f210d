#pragma once

#include <limits>
#include <vector>

#include "engine/constraints/island.h"

/// @file
/// Keeps still water from giving energy to bodies.
///
/// In still water, level or under a height field, the energy of a group (energy.h) may exceed its
/// minimum so far by 2·kEnergyGain of the largest so far. Beyond that the substep is halved and
/// judged again; an excess that remains is removed by scaling the velocity, which joints allow
/// since their conditions on it are linear. Between one and two times kEnergyGain the velocity is
/// scaled without halving. Work done by rows (stiff ropes, motors, stops) and energy brought by
/// water that runs into a hull from above the still water level move the minimum by that amount.
/// Substeps of a jointed group that resolve its motion are not judged. Where lift, applied loads,
/// machines or lines that are loads drive a body, the energy is compared with that of the substep's
/// start. Water that moves may give energy, and so may wind: there nothing is judged. Joints do no
/// work (joint_closing.h).
///
/// Contacts dissipate by themselves: a group that touches something is not judged, and starts anew.

namespace engine {

/// Energies of a group so far: the limiter's part of the state of a simulation.
struct EnergyRange {
  double lowest = std::numeric_limits<double>::infinity();            ///< [J]
  double highest = -std::numeric_limits<double>::infinity();          ///< [J]
  double lowest_potential = std::numeric_limits<double>::infinity();  ///< [J]

  void extend(double energy, double potential);
};

class EnergyLimiter {
 public:
  /// @param group   Bodies that joints connect, ascending, or one body.
  EnergyLimiter(std::vector<BodyId> group, const std::vector<MovingBody>& bodies);

  const std::vector<BodyId>& group() const { return group_; }

  /// Judges a substep of length h [s] whose ends are found.
  /// @param members   Members of the group, in its order.
  /// @param halves    The substep is half of one that had too much energy: it is judged in any
  /// case.
  /// @return true if the group has so much energy that the substep is to be halved.
  bool judge(const std::vector<SubstepBody*>& members, double h, bool halves);

  /// After judge() for the same substep, which stands: slows ends that have too much energy. Bodies
  /// that move with less energy than that stay where they were.
  void clamp(const std::vector<SubstepBody*>& members);

  const EnergyRange& range() const { return range_; }
  void restore(const EnergyRange& range) { range_ = range; }

 private:
  void judge_energy(const std::vector<SubstepBody*>& members, double h);

  std::vector<BodyId> group_;
  bool in_still_water_ = true;
  double floor_ = 0;    ///< Least energy that a gain is compared with [J].
  EnergyRange range_;   ///< Up to the last substep that stands.
  EnergyRange next_;    ///< With the substep that was judged.
  double kinetic_ = 0;  ///< At its end [J].
  double allowed_ = 0;  ///< Gain that is ignored [J].
  double excess_ = 0;   ///< Energy at its end beyond that [J].
};

}  // namespace engine

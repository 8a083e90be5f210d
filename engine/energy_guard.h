#pragma once

#include <functional>
#include <vector>

#include "engine/body.h"

/// @file
/// Keeps still water, and the joints themselves, from giving energy to bodies that joints hold
/// together.
///
/// What free_step.h does for a body by itself, for all of a group at once: joints move energy
/// between its bodies and take some, but add none. A step after which a group has more than the
/// lowest so far by twice kEnergyGain of the greatest so far is taken in halves; above once that
/// its motion is slowed, which the joints allow: their conditions on the velocities are linear.
/// Groups that touch something are left to the contacts, and swings that a step resolves to
/// themselves: their energy swings, too, and comes back.
///
/// Water that moves or is not level may give energy: there only the work of the joints is looked
/// at, which a joint without error does not do. Taking back the error that a body leaves which
/// spins or is thrown far in a piece does work. Where the motion has come to gain by that more than
/// kJointGain of its own energy, less what loads have taken of both since, the step is halved or
/// the motion slowed in the same way.

namespace engine {

/// What a step of a body under constraints is judged by.
struct HeldStep {
  Motion before;          ///< At its start.
  bool touching = false;  ///< The body is in contact.
  double work = 0;        ///< Of the reactions on it in the step [J].
};

class EnergyGuard {
 public:
  using HeldStepOf = std::function<const HeldStep&(std::size_t body)>;
  static constexpr int kMostHalvings = 5;

  /// @param group   Bodies that joints hold together, or one that joints hold.
  EnergyGuard(const std::vector<BodyId>& group, const std::vector<Body>& bodies,
              const Surroundings& around);

  BodyId first() const { return static_cast<BodyId>(bodies_.front()); }

  /// Looks at the bodies after a step [s].
  /// @return true if they have so much energy that the step is to be taken in halves.
  bool gained(const std::vector<Body>& bodies, const HeldStepOf& held, double step);

  /// After gained() for the same step: slows the group if it has too much energy; if it has more of
  /// it than it moves with, it rests where it was before.
  void brake(std::vector<Body>& bodies, const HeldStepOf& held) const;

  /// After gained() for the same step, which stands.
  void accept();

 private:
  void look(const std::vector<Body>& bodies, const HeldStepOf& held, double step);
  void look_at_joints(const std::vector<Body>& bodies, const HeldStepOf& held);

  Surroundings around_;
  std::vector<std::size_t> bodies_;
  bool in_still_water_ = true;
  double floor_ = 0;       ///< Least energy that a gain is measured by [J].
  EnergyRange range_;      ///< Up to the last step that stands.
  EnergyRange next_;       ///< With the step that was looked at.
  double given_ = 0;       ///< By its joints up to the last step that stands [J].
  double next_given_ = 0;  ///< And in the step that was looked at.
  double kinetic_ = 0;     ///< After it [J].
  double allowed_ = 0;     ///< Gain for which nothing is done [J].
  double excess_ = 0;      ///< Beyond that after it [J].
};

}  // namespace engine

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

class EnergyGuard {
 public:
  using MotionOf = std::function<const Motion&(std::size_t body)>;
  static constexpr int kMostHalvings = 5;

  /// @param groups   Bodies that joints hold together, and alone ones that joints hold.
  EnergyGuard(const std::vector<std::vector<BodyId>>& groups, const std::vector<Body>& bodies,
              const Surroundings& around);

  /// Looks at the bodies after a step.
  /// @param before   Motion of a body at its start.
  /// @param touching   For each body, if it is in contact.
  /// @param work   Of the reactions on each body in the step [J].
  /// @param step   Between both [s].
  /// @return true if a group has so much energy that the step is to be taken in halves.
  bool gained(const std::vector<Body>& bodies, const MotionOf& before,
              const std::vector<bool>& touching, const std::vector<double>& work, double step);

  /// After gained() for the same step: slows the groups that have too much energy; those that have
  /// more of it than they move with rest where they were before.
  void brake(std::vector<Body>& bodies, const MotionOf& before) const;

  /// After gained() for the same step, which stands.
  void accept();

 private:
  struct Group {
    std::vector<std::size_t> bodies;
    bool in_still_water = true;
    double floor = 0;       ///< Least energy that a gain is measured by [J].
    EnergyRange range;      ///< Up to the last step that stands.
    EnergyRange next;       ///< With the step that was looked at.
    double given = 0;       ///< By its joints up to the last step that stands [J].
    double next_given = 0;  ///< And in the step that was looked at.
    double kinetic = 0;     ///< After it [J].
    double allowed = 0;     ///< Gain for which nothing is done [J].
    double excess = 0;      ///< Beyond that after it [J].
  };

  void look(Group& group, const std::vector<Body>& bodies, const MotionOf& before,
            double step) const;
  void look_at_joints(Group& group, const std::vector<Body>& bodies, const MotionOf& before,
                      const std::vector<double>& work) const;

  Surroundings around_;
  std::vector<Group> groups_;
};

}  // namespace engine

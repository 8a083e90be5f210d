#pragma once

#include <optional>

#include "engine/body.h"
#include "engine/energy_guard.h"
#include "engine/for_each.h"
#include "engine/world.h"

/// @file
/// A step of all bodies: half a drift, a kick, half a drift.
///
/// Each body drifts by its own inertia and that of the water it moves (free_motion.h) to the middle
/// of the step; there contacts are found, added mass is taken anew (added_inertia.h) and the
/// velocities change by loads (kick.h) and constraints (constrained_step.h); then each drifts on to
/// the end. Poses and velocities belong to the same instants, the ends of steps. Bodies without
/// joints and contacts, or with one joint that guides them (guide.h), go through the step each by
/// itself, in pieces of their own (free_step.h); the others in step with each other, in halves
/// where still water would give them energy (energy_guard.h). Constraints act on the poses halfway,
/// which are one step apart: for them the scheme is ODE's own, with the error of a joint taken back
/// in the next step, and resting contacts rest. In still air free fall is exact and a spin keeps
/// its momentum and energy.

namespace engine {

class SplitStep {
 public:
  /// All must outlive it. @param collides   False: nothing can touch.
  SplitStep(World& world, std::vector<Body>& bodies, const Surroundings& around, ForEach for_each,
            bool collides, double tolerance);

  /// @throws MotionFault, OdeFault
  void advance(double time, double step);
  double collision_seconds() const { return collision_seconds_; }

 private:
  bool any_constraint() const { return collides_ || jointed_; }
  void drift_to_middle(double step);
  void collide(double step);
  /// Where bodies drift to the middle of a step: what touches or is joined there.
  std::vector<std::vector<BodyId>> find_islands(double step);
  /// Groups of bodies that constraints hold to each other or to the world; not a body that only its
  /// guide does.
  std::vector<std::vector<BodyId>> held_islands() const;
  double longest_piece(const std::vector<std::vector<BodyId>>& islands, double step) const;
  void advance_constrained(const std::vector<std::vector<BodyId>>& islands, double time,
                           double step);
  void advance_island(const std::vector<BodyId>& island, double time, double step);
  void advance_free(const std::vector<std::vector<BodyId>>& islands, double time, double step);
  void advance_in_pieces(double time, double step, int halvings);

  /// Moves the islands. False: they have gained energy or were thrown, and are where they were.
  bool advance_soundly(const std::vector<std::vector<BodyId>>& islands, double time, double step,
                       bool may_halve);

  /// What a step changes of a body.
  struct Before {
    Motion motion;
    Vector6d reaction_B;
    std::optional<Eigen::Vector3d> acceleration_W;
  };

  World& world_;
  std::vector<Body>& bodies_;
  const Surroundings& around_;
  ForEach for_each_;
  bool collides_;
  bool jointed_;
  double tolerance_;
  double collision_seconds_ = 0;
  double shortest_ = 0;         ///< Piece that motion or energy ask for [s].
  std::vector<Motion> middle_;  ///< Halfway through the step, before the kick.
  std::vector<Before> before_;  ///< Of the members of islands, at the start of the step.
  std::vector<bool> touching_;  ///< Per body: it has contacts in this step.
  std::vector<double> work_;    ///< Per body: of its reactions in this step [J].
  EnergyGuard guard_;           ///< Of bodies under joints.
};

}  // namespace engine

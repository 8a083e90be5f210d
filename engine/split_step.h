#pragma once

#include <vector>

#include "engine/cluster_step.h"
#include "engine/sleep.h"

/// @file
/// A step of all bodies: half a drift, a kick, half a drift.
///
/// Each body drifts by its own inertia and that of the water it moves (free_motion.h) to the middle
/// of the step; there contacts are found, added mass is taken anew (added_inertia.h) and the
/// velocities change by loads (kick.h) and constraints (constrained_step.h); then each drifts on to
/// the end. Poses and velocities belong to the same instants, the ends of steps. Bodies without
/// joints and contacts, or with one joint that guides them (guide.h), go through the step each by
/// itself, in pieces of their own (free_step.h); those that joints hold together or that come near
/// each other in step with one another (cluster_step.h), in pieces where bodies run into each other
/// (impacts.h) and in halves where still water would give them energy (energy_guard.h). Those that
/// rest may be left out (sleep.h). Constraints act on the poses halfway, which are one step apart:
/// for them the scheme is ODE's own, with the error of a joint taken back in the next step, and
/// resting contacts rest. In still air free fall is exact and a spin keeps its momentum and energy.

namespace engine {

class SplitStep {
 public:
  /// What it refers to must outlive it.
  /// @param sleep   As Integrator::sleep [m/s].
  SplitStep(Stepping stepping, double sleep);

  /// @throws MotionFault, OdeFault
  void advance(double time, double step);

  const Sleep& sleep() const { return sleep_; }
  /// Wakes the body with what it sleeps with.
  void rouse(BodyId id) { sleep_.rouse(id); }

 private:
  /// Per body, empty for those asleep.
  std::vector<Eigen::AlignedBox3d> swept_boxes(double step) const;
  /// Pairs that may touch each other in a step. Wakes the sleeping that others come near to.
  std::vector<Pair> wake_near_pairs(double step);
  std::vector<Cluster> clusters(const std::vector<Pair>& near) const;
  std::vector<EnergyGuard*> guards_of(const Cluster& cluster);
  /// Bodies that are awake and in no cluster.
  std::vector<BodyId> free_bodies(const std::vector<Cluster>& clusters) const;
  /// Lays down what rests. Takes the bodies of the clusters.
  void settle(std::vector<Cluster> clusters, const std::vector<BodyId>& free, double time,
              double step);

  Stepping stepping_;
  std::vector<BodyId> movable_;      ///< Ascending.
  std::vector<EnergyGuard> guards_;  ///< Of bodies under joints, in the order of their first one.
  std::vector<Pair> met_;            ///< In contact, ascending.
  Overlaps overlaps_;
  Sleep sleep_;
};

}  // namespace engine

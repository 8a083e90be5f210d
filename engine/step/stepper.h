#pragma once

#include <vector>

#include "engine/contacts/broad_phase.h"
#include "engine/step/group_stepper.h"

/// @file
/// A step of all bodies: engine/README.md tells the whole scheme.
///
/// Bodies that joints connect or that may touch each other in a step form groups, which are
/// advanced independently of each other; most have one body.

namespace engine {

/// The state that a step leaves to the next one, beside the bodies' motions.
struct StepperState {
  PastContacts contacts;
  std::vector<EnergyRange> ranges;  ///< Ranges of the energy limiters, in their order.
};

class Stepper {
 public:
  /// The objects that the context refers to must outlive the stepper.
  /// @param step   The scene's step [s].
  Stepper(StepContext context, double step);
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  /// @return the overlaps in its substeps. @throws MotionFault, OdeFault
  std::vector<Overlap> advance(double time);

  /// Forces of contacts at the end of the last step; their pairs ascend.
  const std::vector<ContactForce>& contact_forces() const { return contacts_.forces; }
  StepperState state() const;
  /// True if the state has as many energy ranges as there are limiters.
  bool fits(const StepperState& state) const { return state.ranges.size() == limiters_.size(); }
  void restore(const StepperState& state);
  /// Starts the energies of the body's group anew, as after an intervention.
  void forget(BodyId body);

 private:
  /// Pairs that may touch in the next step, ascending.
  std::vector<Pair> near_pairs();
  /// Groups of bodies that joints, lines or nearness connect.
  std::vector<Group> find_groups(const std::vector<Pair>& near) const;
  std::vector<EnergyLimiter*> limiters_of(const Group& group);
  /// Bodies that are advanced and in no group.
  std::vector<SingleBody> single_bodies(const std::vector<Group>& groups) const;

  StepContext context_;
  double step_;
  std::vector<BodyId> movable_;      ///< Ascending.
  std::vector<SingleBody> watched_;  ///< Bodies that cannot move but have loads or pockets.
  std::vector<Pair> joints_;         ///< Joints that are not reduced, and couplings by lines.
  std::vector<EnergyLimiter> limiters_;
  std::vector<std::size_t> limiter_of_;       ///< Per body.
  std::vector<EnergyLimiter*> own_limiters_;  ///< Per body; null for one that judges others, too.
  PastContacts contacts_;
  BroadPhase broad_phase_;
};

}  // namespace engine

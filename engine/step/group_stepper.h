#pragma once

#include <optional>
#include <vector>

#include "engine/contacts/contact_memory.h"
#include "engine/record/constraint_errors.h"
#include "engine/step/energy_limiter.h"
#include "engine/step/impacts.h"
#include "engine/step/substep.h"

/// @file
/// A step of bodies that may have to do with each other, in substeps of their own.
///
/// Each substep is as long as the motion (substep_limit.h) and impacts (impacts.h) allow. Halfway
/// through it contacts are found; joints and contacts make islands, which are moved (substep.h),
/// judged (energy_limiter.h), and either accepted or repeated in halves. Bodies in no island take
/// the substep each as a group of its own. Where impacts shorten substeps, the group is divided
/// into groups that take theirs each for itself. A group of one body that nothing can touch and no
/// joint that is not reduced holds is the most frequent one: its island is itself. Such bodies are
/// moved after each other by one stepper, as its memory is larger than the motion of a body.
///
/// With a tolerance a substep is compared with its halves, which are kept (step_controller.h).

namespace engine {

/// Contacts at the end of a step.
struct PastContacts {
  std::vector<Pair> touching;        ///< Ascending.
  std::vector<ContactForce> forces;  ///< Forces of the last substep; their pairs ascend.
};

/// The contacts of several groups together.
PastContacts joined(const std::vector<PastContacts>& groups);

/// A body that is a group of its own, and the limiter that judges it; null if that judges others,
/// too.
struct SingleBody {
  BodyId id;
  EnergyLimiter* limiter;
};

class GroupStepper {
 public:
  /// @param group      The bodies that it names must outlive the stepper.
  /// @param limiters   Limiters of the bodies of the group, each once.
  /// @param own        Per body of the simulation: its limiter if it is alone.
  /// @param step       The scene's step [s].
  GroupStepper(const StepContext& context, Group group, std::vector<EnergyLimiter*> limiters,
               const std::vector<EnergyLimiter*>& own, const PastContacts& past, double step);
  GroupStepper(const GroupStepper&) = delete;
  GroupStepper& operator=(const GroupStepper&) = delete;

  /// Advances the bodies by a step, or a part of one [s]. @throws MotionFault, OdeFault
  void advance(double time, double length);

  PastContacts contacts() const { return {impacts_.touching(), forces_}; }
  /// The overlaps of all substeps so far.
  const std::vector<Overlap>& overlaps() const { return overlaps_; }

 private:
  friend class SingleBodies;
  /// For one single body after another.
  GroupStepper(const StepContext& context, const SingleBody& body, double step);
  /// Puts another single body in the place of the last one.
  void rebind(const SingleBody& body);

  struct Member : SubstepBody {
    std::optional<std::size_t> island;  ///< Its place in `islands_`; none: it is in no island.
  };
  /// Bodies that one limiter judges.
  struct Judged {
    EnergyLimiter* limiter;
    std::vector<SubstepBody*> members;
  };
  struct Snapshot {
    std::vector<Motion> motions;
    std::vector<EnergyRange> ranges;
    Impacts impacts;
    std::vector<ContactForce> forces;
    std::size_t rows, reactions;  ///< Lengths of the record.
    std::size_t overlaps;
  };

  Member& member(BodyId id);
  void advance_in_substeps(double time, double length, bool halves);
  /// The groups of the bodies that have to do with each other in a time [s]. None: these are all
  /// bodies, or no impact shortens the substeps.
  std::optional<std::vector<Group>> split_by_contact(double time, double length);
  void advance_parts(const std::vector<Group>& parts, double time, double length);
  void advance_within_tolerance(double time, double length);
  /// Finds the ends of a substep of all islands.
  void take_substeps(double time, double h);
  bool must_halve(double h, bool halves);
  void accept(double time, double h);
  Snapshot snapshot() const;
  void restore(const Snapshot& snapshot);

  /// Length of the substep that begins at a time, with its contacts and islands found.
  double next_length(double time, double rest, bool starting);
  double fitting_length(double time, double rest);
  double shortened(double time, double h, double longest);
  double longest_substep(double rest) const;
  void find_contacts(double time, double h);
  StateOf halfway_states();
  std::vector<EnergyLimiter*> limiters_of(const Group& part) const;
  void keep_forces();
  void find_islands();

  const StepContext& context_;
  Group group_;
  const std::vector<EnergyLimiter*>& own_;
  bool is_alone_;
  bool is_part_ = false;     ///< The group is a part of one that was divided.
  const double whole_step_;  ///< The scene's [s].
  double step_;      ///< Scene's step; for a single body, the interval that is advanced [s].
  double shortest_;  ///< Substep that is not halved any more for its energy or error [s].
  Impacts impacts_;
  World::Contacts contacts_;
  std::optional<std::pair<double, double>> found_;  ///< Time and h of the contacts [s].
  std::vector<ContactForce> forces_;                ///< Forces of the last accepted substep.
  std::vector<Member> members_;
  std::vector<Judged> judged_;   ///< Ascending by their first bodies.
  std::vector<Island> islands_;  ///< Islands of the present substep.
  Rig::Record record_;           ///< Record of the substeps since advance() was called.
  std::vector<Overlap> overlaps_;
};

/// Bodies that are groups of their own, in parts that may be advanced at once.
class SingleBodies {
 public:
  /// The objects that it refers to must outlive it. @param step   The scene's step [s].
  SingleBodies(const StepContext& context, std::vector<SingleBody> bodies, double step)
      : context_(context), bodies_(std::move(bodies)), step_(step) {}

  std::size_t parts() const;
  /// Advances the bodies of a part by a step, or a part of one [s]. @throws MotionFault
  void advance(std::size_t part, double time, double length) const;

 private:
  const StepContext& context_;
  std::vector<SingleBody> bodies_;
  double step_;
};

}  // namespace engine

#pragma once

#include <optional>
#include <vector>

#include "engine/substep.h"

/// @file
/// Impacts: substeps that end where bodies begin to touch, and short substeps after that.
///
/// The force of a contact sets in with a jump, c v of its damper, and decays within its time τ
/// (contacts.h), that of a corner within τ/10. A substep that only detects an overlap knows its
/// onset to within h. Whatever the scheme, the error is then O(h), and for h > τ as large as the
/// impact itself. So where two bodies are about to touch faster than
///
///     g τ                                                                                  (E15)
///
/// the substep ends where they begin to, found from depth over speed of the overlap that the bodies
/// drift into. The next substep is kFirstAfterImpact τ long (or that part of the step, if it is
/// shorter), and each further one longer by kImpactGrowth until it is a step: some dozen substeps
/// per impact, whatever the step, of the bodies near enough to have to do with it.
///
/// In a heap of more than kMostImpactPairs pairs the motion of a body depends on all its contacts
/// more than on the time of one: heaps take whole steps. No step of a group is cut for more than
/// kMostImpacts, so that bodies which rattle cannot stall it.

namespace engine {

/// Bodies that joints connect or that may touch each other in a step.
struct Group {
  std::vector<BodyId> bodies;  ///< Ascending; all can move.
  std::vector<Pair> joints;    ///< Of these bodies, with each other or with what cannot move.
  std::vector<Pair> near;      ///< Pairs that may touch; ascending.
};

class Impacts {
 public:
  /// What it refers to must outlive it.
  /// @param touching   Pairs in contact at the end of the last step, ascending.
  Impacts(const StepContext& context, const Group& group, const std::vector<Pair>& touching,
          double step);

  /// Longest substep that past impacts leave [s].
  double longest_substep() const;

  /// Time within the next substep of length h at which a pair begins to touch fast, where the
  /// substep is to end; a pair that has just begun to leaves it the first length after an impact.
  /// None: the substep may be taken as it is.
  /// @param touching   Pairs that touch halfway through the substep, ascending.
  std::optional<double> next(double h, const std::vector<Pair>& touching);

  /// The substep is taken.
  void accept(const std::vector<Pair>& touching);

  /// Pairs in contact, ascending.
  const std::vector<Pair>& touching() const { return touching_; }

 private:
  MovingBody& body(BodyId id) const { return context_->bodies[static_cast<std::size_t>(id)]; }
  bool may_meet_fast(const Pair& pair) const;
  std::optional<double> onset(const Pair& pair, double time) const;

  const StepContext* context_;
  const Group* group_;
  double first_;  ///< Length of the first substep after an impact [s].
  double begun_;  ///< An impact nearer to the start of a substep has begun with it [s].
  double step_;
  double slow_;                   ///< Speed of (E15) [m/s].
  int count_ = 0;                 ///< Impacts in this step.
  std::vector<Pair> touching_;    ///< Ascending.
  std::vector<Pair> will_touch_;  ///< At the end of the next substep, or at its start.
};

}  // namespace engine

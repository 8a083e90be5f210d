#pragma once

#include <optional>
#include <vector>

#include "engine/step/group.h"
#include "engine/step/step_context.h"

/// @file
/// Impacts: substeps that end where bodies begin to touch, and short substeps after that.
///
/// The force of a contact sets in with a jump, c v of its damper, and decays within its time τ
/// (contacts.h), that of a corner within τ/10. A substep that only detects an overlap knows its
/// onset to within h. Whatever the scheme, the error is then O(h), and for h > τ as large as the
/// impact itself. So where two bodies are about to touch with more speed than
///
///     g τ                                                                                  (E15)
///
/// the substep ends at the onset, which follows from depth over speed of the overlap that the
/// bodies drift into, and is looked at again a little later, where that overlap is sure to be
/// seen. The next substep has the length kFirstAfterImpact τ, or that part of a shorter step, and
/// each further one grows by kImpactGrowth up to a step: some dozen substeps of the group per
/// impact, whatever the step.
///
/// Bodies that would pass through each other in the substep (passing.h) end it at their onset, too,
/// and where kFirstAfterImpact τ would still take them through, the next one is shorter, so that
/// they are found in contact with less than half the thinner body's thickness. Shortening a
/// substep can hide a contact that the full substep would have found; the shortened one is
/// therefore searched again for passings. Each body may end at most kMostPassings substeps of a
/// step this way, with at most kMostPassingQueries queries.
///
/// Where impacts shorten the substeps of a group, it is divided into the groups of the bodies that
/// touch, or meet, in the time ahead, and each of these takes substeps of its own. Two bodies are
/// also taken to meet if they could move by more than half the thickness of the thinner one in that
/// time, as an impact may turn them round.
///
/// An impact shortens the substeps of all bodies of its group, so groups of more than
/// kMostImpactPairs pairs that touch take whole steps, as a shorter step gets them nearer in the
/// same time. So do groups under joints from kMostJointedImpactPairs on, as joints and overlaps
/// that contradict each other would push in each of the substeps. At most kMostImpacts shorten
/// substeps in a step of a group: bodies that rattle cannot stall it.

namespace engine {

class PredictedStates;

class Impacts {
 public:
  /// The objects that it refers to must outlive it.
  /// @param touching   Pairs in contact at the end of the last step, ascending.
  Impacts(const StepContext& context, const Group& group, const std::vector<Pair>& touching,
          double step);

  /// Limit of the substep by past impacts [s].
  double longest_substep() const;

  /// Limit of the next substep, of length h, by an impact in it [s]: the time at which a pair
  /// begins to touch or, if that is now, the first length after an impact. None: there is no
  /// impact, and no passing.
  /// @param touching   Pairs that touch halfway through the substep, ascending.
  std::optional<double> next(double h, const std::vector<Pair>& touching);

  /// Takes note of a substep that has been taken.
  void accept(const std::vector<Pair>& touching);

  /// Near pairs of the group that begin to touch in a time h [s], or that an impact of one of them
  /// with another body could bring together. None: no impact, of before or to come, shortens its
  /// substeps.
  std::optional<std::vector<Pair>> meetings(double h) const;
  /// Takes the pairs that touch at the end of a time that the parts of the group have taken.
  void set_touching(std::vector<Pair> touching) { touching_ = std::move(touching); }

  /// Pairs in contact, ascending.
  const std::vector<Pair>& touching() const { return touching_; }

 private:
  MovingBody& body(BodyId id) const { return context_->bodies[id]; }
  /// The next time at which a pair begins to touch.
  struct Onset {
    double time = 0;   ///< From the start of the substep [s].
    double first = 0;  ///< Length of the substep that follows [s].
    Pair pair;
  };

  /// Bounds of the relative speed of two points of a pair [m/s], and of its turning [rad/s].
  struct Speed {
    double linear = 0;
    double angular = 0;
  };
  /// Pairs that touch, beyond which impacts do not shorten substeps.
  std::size_t most_pairs() const;
  Speed meeting_speed(const Pair& pair) const;
  /// A bound of the relative speed of two points of a pair after an impact of one with another
  /// body [m/s].
  double turned_speed(const Pair& pair) const;
  static double earliest(const std::vector<Onset>& onsets);
  /// Onsets that the overlaps at the end of a substep tell of.
  std::vector<Onset> onsets(double h) const;
  /// Adds the pairs that would pass in a substep, or makes their onsets earlier. @return true if it
  /// has found some
  bool add_passings(double h, PredictedStates& states, std::vector<Onset>& found);
  double first_after(const Pair& pair, const Speed& speed) const;
  std::optional<double> onset(const Pair& pair, double time) const;
  /// The onset of a pair that would pass in the substep. @param reach   World::reach [m]
  std::optional<double> passing(const Pair& pair, double h, const Speed& speed, double reach,
                                PredictedStates& states);

  const StepContext* context_;
  const Group* group_;
  double first_;  ///< Length of the first substep after an impact [s].
  double begun_;  ///< Onset that counts as the start of the substep, unless that is shorter [s].
  double step_;
  double slow_;                   ///< Speed of (E15) [m/s].
  int count_ = 0;                 ///< Impacts in this step.
  int passings_ = 0;              ///< Passings in this step.
  int queries_;                   ///< Queries for passings that are left in this step.
  std::vector<Pair> touching_;    ///< Ascending.
  std::vector<Pair> will_touch_;  ///< At the end of the next substep, or at its start.
};

}  // namespace engine

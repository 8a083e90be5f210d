#pragma once

#include <optional>
#include <vector>

#include "engine/body.h"
#include "engine/world.h"

/// @file
/// Impacts: steps that end where bodies begin to touch, and short ones after it.
///
/// A contact's force sets in with a jump, c v of its damper, and wears off within its time τ
/// (contacts.h), that of a corner within τ/10. A step that finds an overlap somewhere on its way
/// misses when it began by up to its own length: whatever its method, its error is of first order,
/// and as large as all that the impact changes once the step is longer than τ. So where two bodies
/// are about to touch faster than
///
///     g τ                                                                                  (1)
///
/// the step ends where they begin to, found from depth over speed of the overlap that the bodies
/// drift into; and the next piece is kFirstPiece τ long (or of the step, if that is shorter), each
/// further one longer by kGrowth, until pieces are as long as steps again. That costs some dozen
/// pieces an impact, whatever the step, of the bodies near enough to have to do with it.
///
/// Where more than kMostPairs pairs of bodies touch each other, what a body does depends on all
/// their contacts more than on the time of one: heaps take whole steps. And no step of a cluster is
/// cut for more than kMostImpacts, so that bodies which rattle cannot make it stall.

namespace engine {

/// Bodies that joints hold together or that may touch each other in a step.
struct Cluster {
  std::vector<BodyId> bodies;  ///< Ascending; all can move.
  std::vector<Pair> joints;    ///< Of them, with each other or with what cannot move.
  std::vector<Pair> near;      ///< That may touch; ascending.
};

class Impacts {
 public:
  static constexpr double kFirstPiece = 1.0 / 32;
  static constexpr double kGrowth = 1.2;
  static constexpr std::size_t kMostPairs = 4;
  static constexpr int kMostImpacts = 4;

  /// All must outlive it.
  /// @param met   Pairs that were in contact at the end of the last step, ascending.
  Impacts(World& world, std::vector<Body>& bodies, const Surroundings& around,
          const Cluster& cluster, const std::vector<Pair>& met, double step);

  /// Longest piece that past impacts leave [s].
  double longest_piece() const;

  /// Where in the next piece a pair begins to touch fast, which is then where the piece is to end;
  /// one that has just begun to leaves it a first piece. None: it may be taken as it is.
  /// @param touching   Pairs that touch halfway through the piece, ascending.
  std::optional<double> next(double piece, const std::vector<Pair>& touching);

  /// The piece is taken.
  void accept(const std::vector<Pair>& touching);

  /// Pairs that are in contact now, ascending.
  const std::vector<Pair>& met() const { return met_; }

 private:
  Body& body(BodyId id) { return bodies_[static_cast<std::size_t>(id)]; }
  const Body& body(BodyId id) const { return bodies_[static_cast<std::size_t>(id)]; }
  bool may_meet_fast(const Pair& pair) const;
  std::optional<double> onset(const Pair& pair, double time) const;

  World& world_;
  std::vector<Body>& bodies_;
  const Surroundings& around_;
  const Cluster& cluster_;
  double first_piece_;  ///< After an impact [s].
  double begun_;        ///< An impact nearer to the start of a piece has begun with it [s].
  double step_;
  double slow_;             ///< Speed of (1) [m/s].
  int count_ = 0;           ///< Of impacts in this step.
  std::vector<Pair> met_;   ///< Ascending.
  std::vector<Pair> meet_;  ///< At the end of the next piece or at its start.
};

}  // namespace engine

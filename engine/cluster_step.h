#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/body.h"
#include "engine/constrained_step.h"
#include "engine/energy_guard.h"
#include "engine/for_each.h"
#include "engine/impacts.h"
#include "engine/world.h"

/// @file
/// A step of bodies that may have to do with each other, in pieces of their own.
///
/// In a piece all drift to its middle, where contacts are found. Those that joints or contacts hold
/// are kicked together, island by island; the others take the piece as a free step.

namespace engine {

/// What all steps have in common.
struct Stepping {
  World& world;
  std::vector<Body>& bodies;
  const Surroundings& around;
  ForEach for_each;
  bool collides = true;  ///< False: nothing can touch.
  double tolerance = 0;  ///< As free_step takes it.
};

/// A step of a body that nothing holds, or a part of a whole step [s].
void step_alone(const Stepping& stepping, Body& body, double time, double step, double whole);

class ClusterStep {
 public:
  /// All must outlive it.
  /// @param guards   Of the groups of bodies that its joints hold together.
  /// @param met   Pairs in contact, ascending.
  ClusterStep(const Stepping& stepping, const Cluster& cluster, std::vector<EnergyGuard*> guards,
              const std::vector<Pair>& met, double step);
  ClusterStep(const ClusterStep&) = delete;
  ClusterStep& operator=(const ClusterStep&) = delete;

  /// @throws MotionFault, OdeFault
  void advance(double time);

  /// Pairs in contact, ascending.
  const std::vector<Pair>& met() const { return impacts_.met(); }

 private:
  /// What joints and contacts hold together.
  struct Island {
    std::vector<BodyId> bodies;  ///< Ascending.
    std::vector<Contact> contacts;
  };

  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  /// What a step changes of a body.
  struct Member {
    BodyId id = 0;
    Body* body = nullptr;
    std::size_t island = kNone;  ///< Of the piece.
    Motion middle;               ///< Halfway through the piece, before the kick.
    HeldStep held;
    Vector6d reaction_before_B = Vector6d::Zero();
    std::optional<Eigen::Vector3d> acceleration_before_W;

    /// Remembers where it is; goes back there.
    void begin();
    void go_back() const;
  };

  Member& member(BodyId id);
  /// In pieces whose error is estimated.
  void advance_within_tolerance(double time);
  /// Tries a piece that fits as a whole and as two halves. Moves nothing.
  /// @return the largest estimated error of a member.
  double try_piece(double time, double piece);
  void advance_in_pieces(double time, double length, int halvings);
  /// The length of a piece of what is left of a step by all but impacts in it, found halfway
  /// through it.
  double fit_piece(double rest);
  /// The same of the next piece, which ends where an impact begins.
  double begin_piece(double rest);
  /// The piece, or the longest that it may be, halfway through which bodies then are.
  double shortened(double piece, double longest);
  /// Drifts to the middle of a piece, finds contacts there and the islands that they make.
  void meet_halfway(double piece);
  void find_islands();
  double longest_piece(double rest);
  void advance_islands(double time, double piece);
  /// Moves the islands. False: they have gained energy or were thrown, and are where they were.
  bool advance_soundly(double time, double piece, bool may_halve);
  void advance_island(const Island& island, double time, double piece);
  void advance_others(double time, double piece);

  const Stepping& stepping_;
  const Cluster& cluster_;
  std::vector<EnergyGuard*> guards_;
  double step_;
  double shortest_;  ///< Piece that motion or energy ask for [s].
  Impacts impacts_;
  World::Contacts contacts_;
  std::vector<Member> members_;
  std::vector<Island> islands_;  ///< Of the next piece.
};

}  // namespace engine

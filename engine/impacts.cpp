#include "engine/impacts.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace engine {
namespace {

// Times at which a pair is looked at to find when it begins to touch.
constexpr int kMostLooks = 4;
// Of a first piece: nearer than that to the start of a piece, an impact has begun.
constexpr double kBegun = 1.0 / 8;

/// Where a body gets to by its last accelerations.
hydro::BodyState expected_state(const Body& body, const Surroundings& around, double time) {
  hydro::BodyState state = state_after_drift(body, around, body.motion, time);
  const Vector6d acceleration_B = body.motion.kicks.expected(time / 2);
  state.position += time * time / 2 * (state.orientation * acceleration_B.head<3>());
  return state;
}

bool contains(const std::vector<Pair>& pairs, const Pair& pair) {
  return std::binary_search(pairs.begin(), pairs.end(), pair);
}

}  // namespace

Impacts::Impacts(World& world, std::vector<Body>& bodies, const Surroundings& around,
                 const Cluster& cluster, const std::vector<Pair>& met, double step)
    : world_(world),
      bodies_(bodies),
      around_(around),
      cluster_(cluster),
      first_piece_(kFirstPiece * std::min(step, kShortestContact)),
      begun_(kBegun * first_piece_),
      step_(step),
      slow_(kShortestContact * std::max(around.gravity, kLeastGravity)) {
  std::set_intersection(cluster.near.begin(), cluster.near.end(), met.begin(), met.end(),
                        std::back_inserter(met_));
}

double Impacts::longest_piece() const {
  double longest = std::numeric_limits<double>::infinity();
  for (const BodyId id : cluster_.bodies) longest = std::min(longest, body(id).after_impact);
  return longest;
}

std::optional<double> Impacts::next(double piece, const std::vector<Pair>& touching) {
  if (touching.size() > kMostPairs || count_ == kMostImpacts) return std::nullopt;
  std::vector<std::pair<double, Pair>> onsets;
  for (const Pair& pair : cluster_.near) {
    if (!may_meet_fast(pair)) continue;
    const auto time = onset(pair, piece);
    if (time) onsets.emplace_back(*time, pair);
  }
  if (onsets.empty()) return std::nullopt;
  ++count_;
  const double first = std::min_element(onsets.begin(), onsets.end())->first;
  for (const auto& [time, pair] : onsets) {
    if (time > first + begun_) continue;
    meet_.push_back(pair);
    for (const BodyId id : {pair.first, pair.second})
      if (moves(bodies_, id)) body(id).after_impact = first_piece_;
  }
  return first > begun_ ? first : std::min(piece, first_piece_);
}

void Impacts::accept(const std::vector<Pair>& touching) {
  met_.clear();
  std::set_union(touching.begin(), touching.end(), meet_.begin(), meet_.end(),
                 std::back_inserter(met_));
  meet_.clear();
  for (const BodyId id : cluster_.bodies) {
    double& longest = body(id).after_impact;
    longest = longest < step_ ? kGrowth * longest : std::numeric_limits<double>::infinity();
  }
}

bool Impacts::may_meet_fast(const Pair& pair) const {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  double turning = 0;
  for (const BodyId id : {pair.first, pair.second}) {
    if (!moves(bodies_, id)) continue;
    const hydro::BodyState& state = body(id).motion.state;
    velocity = state.linear_velocity - velocity;
    turning += body(id).radius * state.angular_velocity.norm();
  }
  return velocity.norm() + turning > slow_;
}

std::optional<double> Impacts::onset(const Pair& pair, double time) const {
  const bool met = contains(met_, pair);
  std::optional<double> found;
  for (int i = 0; i < kMostLooks; ++i) {
    std::vector<std::pair<BodyId, hydro::BodyState>> places;
    for (const BodyId id : {pair.first, pair.second})
      if (moves(bodies_, id)) places.emplace_back(id, expected_state(body(id), around_, time));
    std::optional<double> earliest;
    for (const double since : world_.closing_times(places, pair, slow_)) {
      const double start = time - since;
      if (met && start < begun_) continue;  // known
      earliest = std::max(0.0, std::min(start, earliest.value_or(start)));
    }
    if (!earliest) return found;
    found = time = *earliest;
  }
  return found;
}

}  // namespace engine

#include "engine/sleep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/applied_load.h"

namespace engine {
namespace {

/// Longest period of something of radius r, as a part of 2π √(r/g): that of a body which spreads
/// its mass as far as that and rolls with a metacentric height of r/16, a tender ship.
constexpr double kSlowestSwing = 4;

/// Half that period [s].
double time_to_rest(double radius, double gravity) {
  return kSlowestSwing * std::numbers::pi * std::sqrt(radius / gravity);
}

/// Of its fastest point, at most [m/s].
double largest_speed(const Body& body) {
  const hydro::BodyState& state = body.motion.state;
  return state.linear_velocity.norm() + body.radius * state.angular_velocity.norm();
}

/// The motion stopped where it is.
Motion stopped(const Body& body, const Surroundings& around) {
  Motion motion = body.motion;
  motion.state.linear_velocity.setZero();
  motion.state.angular_velocity.setZero();
  motion.added_rate_B.reset();
  motion.kicks.clear();
  if (motion.ledger) book_brake(body, around, body.motion, motion);
  return motion;
}

}  // namespace

Sleep::Sleep(const World& world, std::vector<Body>& bodies, const Surroundings& around,
             double limit)
    : world_(world),
      bodies_(bodies),
      around_(around),
      limit_(around.sea && hydro::changes_with_time(*around.sea) ? 0 : limit),
      still_(bodies.size(), 0),
      island_(bodies.size()),
      steps_(bodies.size(), 0),
      place_(bodies.size()) {}

void Sleep::wake(std::vector<Eigen::AlignedBox3d>& boxes) {
  if (by_place_.empty()) return;
  std::vector<BodyId> awake;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].movable && !island_[i]) awake.push_back(static_cast<BodyId>(i));
  const std::size_t before = awake.size();
  for (std::size_t k = 0; k < awake.size(); ++k) {
    for (const BodyId id : sleepers_in(boxes[static_cast<std::size_t>(awake[k])])) {
      if (!asleep(id)) continue;  // woken with another one
      for (const BodyId member : woken(id)) {
        const auto i = static_cast<std::size_t>(member);
        boxes[i] = place_[i];
        awake.push_back(member);
      }
    }
  }
  if (awake.size() > before) std::erase_if(by_place_, [this](BodyId id) { return !asleep(id); });
}

void Sleep::rouse(BodyId id) {
  if (!asleep(id)) return;
  woken(id);
  std::erase_if(by_place_, [this](BodyId other) { return !asleep(other); });
}

Sleep::Island Sleep::woken(BodyId id) {
  const Island island = *island_[static_cast<std::size_t>(id)];
  for (const BodyId member : island) {
    island_[static_cast<std::size_t>(member)] = nullptr;
    still_[static_cast<std::size_t>(member)] = 0;
  }
  return island;
}

void Sleep::settle(const std::vector<Island>& islands, double time, double step) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (island_[i])
      ++steps_[i];
    else
      still_[i] = is_still(bodies_[i], time) ? still_[i] + step : 0;
  }
  const std::size_t before = by_place_.size();
  for (const Island& island : islands)
    if (rests(island)) lay_down(island, step);
  if (by_place_.size() > before)
    std::sort(by_place_.begin(), by_place_.end(),
              [this](BodyId a, BodyId b) { return std::pair(left(a), a) < std::pair(left(b), b); });
}

bool Sleep::is_still(const Body& body, double time) const {
  const std::vector<AppliedLoad>& loads = body.spec->loads;
  return largest_speed(body) < limit_ && !body.pull &&
         std::none_of(loads.begin(), loads.end(),
                      [&](const AppliedLoad& load) { return changes_after(load, time); });
}

bool Sleep::rests(const Island& island) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const BodyId id : island)
    shortest = std::min(shortest, still_[static_cast<std::size_t>(id)]);
  if (shortest == 0) return false;
  Eigen::AlignedBox3d box;
  for (const BodyId id : island) {
    const Body& body = bodies_[static_cast<std::size_t>(id)];
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(body.radius);
    box.extend(body.motion.state.position - half);
    box.extend(body.motion.state.position + half);
  }
  const double radius = island.size() == 1
                            ? bodies_[static_cast<std::size_t>(island.front())].radius
                            : box.sizes().norm() / 2;
  return shortest >= time_to_rest(radius, around_.gravity);
}

void Sleep::lay_down(const Island& island, double step) {
  const auto shared = std::make_shared<const Island>(island);
  for (const BodyId id : island) {
    const auto i = static_cast<std::size_t>(id);
    bodies_[i].motion = stopped(bodies_[i], around_);
    island_[i] = shared;
    place_[i] = swept_box(world_.shape_box(id), bodies_[i].motion.state, around_.gravity, step);
    if (place_[i].isEmpty()) continue;
    widest_ = std::max(widest_, place_[i].sizes().x());
    by_place_.push_back(id);
  }
}

std::vector<BodyId> Sleep::sleepers_in(const Eigen::AlignedBox3d& box) const {
  std::vector<BodyId> found;
  if (box.isEmpty()) return found;
  auto next = std::lower_bound(by_place_.begin(), by_place_.end(), box.min().x() - widest_,
                               [this](BodyId id, double x) { return left(id) < x; });
  for (; next != by_place_.end() && left(*next) <= box.max().x(); ++next)
    if (box.intersects(place_[static_cast<std::size_t>(*next)])) found.push_back(*next);
  return found;
}

}  // namespace engine

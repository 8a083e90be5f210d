#include "engine/split_step.h"

#include <algorithm>
#include <utility>

namespace engine {

SplitStep::SplitStep(Stepping stepping, double sleep)
    : stepping_(std::move(stepping)),
      sleep_(stepping_.world, stepping_.bodies, stepping_.around, sleep) {
  const std::vector<Body>& bodies = stepping_.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].movable) movable_.push_back(static_cast<BodyId>(i));
  for (const std::vector<BodyId>& group : groups(movable_, stepping_.world.joints())) {
    // On a guide a body keeps to the rule of a free one.
    if (group.size() == 1 && bodies[static_cast<std::size_t>(group.front())].guide) continue;
    guards_.emplace_back(group, bodies, stepping_.around);
  }
}

void SplitStep::advance(double time, double step) {
  std::vector<Cluster> groups = clusters(wake_near_pairs(step));
  const std::vector<BodyId> free = free_bodies(groups);
  std::vector<std::vector<Pair>> met(groups.size());
  call_all(stepping_.for_each, groups.size() + free.size(), [&](std::size_t i) {
    if (i >= groups.size()) {
      Body& body = stepping_.bodies[static_cast<std::size_t>(free[i - groups.size()])];
      return step_alone(stepping_, body, time, step, step);
    }
    ClusterStep cluster(stepping_, groups[i], guards_of(groups[i]), met_, step);
    cluster.advance(time);
    met[i] = cluster.met();
  });
  std::erase_if(met_, [this](const Pair& pair) { return !sleep_.asleep(pair); });
  for (const std::vector<Pair>& pairs : met) met_.insert(met_.end(), pairs.begin(), pairs.end());
  std::sort(met_.begin(), met_.end());
  settle(std::move(groups), free, time + step, step);
}

std::vector<Eigen::AlignedBox3d> SplitStep::swept_boxes(double step) const {
  const std::vector<Body>& bodies = stepping_.bodies;
  std::vector<Eigen::AlignedBox3d> boxes(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto id = static_cast<BodyId>(i);
    if (!sleep_.asleep(id))
      boxes[i] = swept_box(stepping_.world.shape_box(id), bodies[i].motion.state,
                           stepping_.around.gravity, step);
  }
  return boxes;
}

std::vector<Pair> SplitStep::wake_near_pairs(double step) {
  if (!stepping_.collides) return {};
  const World& world = stepping_.world;
  const std::vector<Body>& bodies = stepping_.bodies;
  std::vector<Eigen::AlignedBox3d> boxes = swept_boxes(step);
  sleep_.wake(boxes);
  // Of the bodies and, last, the ground.
  boxes.push_back(world.ground_box());
  std::vector<Pair> pairs;
  for (const auto& [first, second] : overlaps_.find(boxes)) {
    const auto a = static_cast<BodyId>(first), b = static_cast<BodyId>(second);
    const Pair pair = second == bodies.size() ? Pair(kWorld, a) : Pair(a, b);
    if (world.may_touch(pair)) pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Cluster> SplitStep::clusters(const std::vector<Pair>& near) const {
  const auto guided = [this](BodyId id) {
    return id != kWorld && stepping_.bodies[static_cast<std::size_t>(id)].guide;
  };
  const std::vector<Pair>& joints = stepping_.world.joints();
  // What a joint guides goes by itself where nothing is near.
  std::vector<Pair> holding = near;
  for (const Pair& pair : joints)
    if (!guided(pair.first) && !guided(pair.second) && !sleep_.asleep(pair))
      holding.push_back(pair);
  std::vector<Cluster> clusters;
  if (holding.empty()) return clusters;
  std::vector<Cluster*> home(stepping_.bodies.size(), nullptr);
  std::vector<std::vector<BodyId>> held = groups(movable_, holding);
  clusters.reserve(held.size());
  for (std::vector<BodyId>& group : held) {
    clusters.push_back({.bodies = std::move(group), .joints = {}, .near = {}});
    for (const BodyId id : clusters.back().bodies)
      home[static_cast<std::size_t>(id)] = &clusters.back();
  }
  const auto home_of = [&](const Pair& pair) {
    return home[static_cast<std::size_t>(moves(stepping_.bodies, pair.first) ? pair.first
                                                                             : pair.second)];
  };
  for (const Pair& pair : joints)
    if (Cluster* cluster = home_of(pair)) cluster->joints.push_back(pair);
  for (const Pair& pair : near) home_of(pair)->near.push_back(pair);
  return clusters;
}

std::vector<EnergyGuard*> SplitStep::guards_of(const Cluster& cluster) {
  std::vector<EnergyGuard*> guards;
  if (cluster.joints.empty()) return guards;
  for (EnergyGuard& guard : guards_)
    if (std::binary_search(cluster.bodies.begin(), cluster.bodies.end(), guard.first()))
      guards.push_back(&guard);
  return guards;
}

std::vector<BodyId> SplitStep::free_bodies(const std::vector<Cluster>& clusters) const {
  std::vector<bool> alone(stepping_.bodies.size(), true);
  for (const Cluster& cluster : clusters)
    for (const BodyId id : cluster.bodies) alone[static_cast<std::size_t>(id)] = false;
  std::vector<BodyId> free;
  for (const BodyId id : movable_)
    if (alone[static_cast<std::size_t>(id)] && !sleep_.asleep(id)) free.push_back(id);
  return free;
}

void SplitStep::settle(std::vector<Cluster> clusters, const std::vector<BodyId>& free, double time,
                       double step) {
  if (!sleep_.possible()) return;
  std::vector<Sleep::Island> islands;
  for (Cluster& cluster : clusters) islands.push_back(std::move(cluster.bodies));
  for (const BodyId id : free) islands.push_back({id});
  sleep_.settle(islands, time, step);
}

}  // namespace engine

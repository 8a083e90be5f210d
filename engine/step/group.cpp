#include "engine/step/group.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace engine {

std::vector<Group> make_groups(const std::vector<MovingBody>& bodies,
                               const std::vector<BodyId>& movable,
                               const std::vector<Pair>& connections,
                               const std::vector<Pair>& joints, const std::vector<Pair>& near) {
  assert(std::ranges::is_sorted(movable) && std::ranges::is_sorted(near));
  std::vector<Group> groups;
  if (connections.empty()) return groups;
  std::vector<std::vector<BodyId>> connected = connected_components(movable, connections);
  groups.reserve(connected.size());
  std::vector<Group*> home(bodies.size(), nullptr);
  for (std::vector<BodyId>& members : connected) {
    assert(!members.empty() && std::ranges::is_sorted(members));
    groups.push_back({.bodies = std::move(members), .joints = {}, .near = {}});
    for (const BodyId id : groups.back().bodies) home[id] = &groups.back();
  }
  const auto home_of = [&](const Pair& pair) -> Group* {
    const auto [first, second] = pair;
    if (!can_move(bodies, first)) return home[second];
    if (!can_move(bodies, second) || home[first] == home[second]) return home[first];
    return nullptr;
  };
  for (const Pair& pair : joints)
    if (Group* group = home_of(pair)) group->joints.push_back(pair);
  for (const Pair& pair : near)
    if (Group* group = home_of(pair)) group->near.push_back(pair);
  return groups;
}

}  // namespace engine

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/contacts/world.h"

namespace engine {
namespace {

/// A fast body, and another fast one that is near it.
struct Neighbour {
  std::size_t place, other;  ///< In the list of placed bodies.
  Pair pair;
};

}  // namespace

void World::add_followers(const std::vector<Placed>& bodies, const std::vector<Pair>& pairs,
                          double step, Contacts& contacts) {
  const double slow = impact_speed(gravity_);
  // The place of a body in the list; none for one that is slow.
  const auto fast = [&](BodyId id) -> std::optional<std::size_t> {
    const auto found = std::ranges::lower_bound(bodies, id, {}, &Placed::body);
    if (found == bodies.end() || found->body != id) return std::nullopt;
    if (!(found->state.linear_velocity.norm() > slow)) return std::nullopt;
    return static_cast<std::size_t>(found - bodies.begin());
  };
  std::vector<std::size_t> stopped;
  std::vector<bool> is_stopped(bodies.size());
  const auto stop = [&](std::size_t place) {
    if (!is_stopped[place]) stopped.push_back(place);
    is_stopped[place] = true;
  };
  for (const Contact& contact : contacts.points)
    for (const BodyId id : {contact.pair.first, contact.pair.second})
      if (contact.rebounds && contact.restitution == 0)
        if (const auto place = fast(id)) stop(*place);
  if (stopped.empty()) return;
  std::vector<Neighbour> neighbours;
  for (const Pair& pair : pairs) {
    const auto first = fast(pair.first), second = fast(pair.second);
    if (!first || !second) continue;
    neighbours.push_back({*first, *second, pair});
    neighbours.push_back({*second, *first, pair});
  }
  std::ranges::stable_sort(neighbours, {}, &Neighbour::place);
  const std::vector<Pair> touching = contacts.pairs;
  for (std::size_t i = 0; i < stopped.size(); ++i) {
    const Placed& placed = bodies[stopped[i]];
    set_state(placed.body, placed.start);
    auto near = std::ranges::lower_bound(neighbours, stopped[i], {}, &Neighbour::place);
    for (; near != neighbours.end() && near->place == stopped[i]; ++near)
      if (!is_stopped[near->other] &&
          (std::ranges::binary_search(touching, near->pair) ||
           add_follower(near->pair, bodies[near->other], step, contacts)))
        stop(near->other);
    set_state(placed.body, placed.state);
  }
  std::ranges::sort(contacts.pairs);
  std::ranges::stable_sort(contacts.points, {}, &Contact::pair);
}

bool World::add_follower(const Pair& pair, const Placed& follower, double step,
                         Contacts& contacts) {
  const Surface surface = surfaces_.between(pair);
  if (surface.restitution > 0) return false;
  hydro::BodyState end = follower.state;
  end.position += step / 2 * end.linear_velocity;
  set_state(follower.body, end);
  const std::vector<ContactPoint> points = touching_points(pair, step);
  set_state(follower.body, follower.state);
  const ContactLaw law = law_of(pair, points.size());
  const double side = pair.first == follower.body ? -1 : 1;
  bool follows = false;
  for (ContactPoint point : points) {
    const double speed = side * point.normal_W.dot(follower.state.linear_velocity);
    if (!(speed > impact_speed(gravity_))) continue;
    point.depth -= step * speed;
    Contact contact = contact_at(pair, point, surface, law, step);
    contact.row.speed = (std::min(point.depth, 0.0) - law.rest) / step;
    contact.rebounds = false;
    contacts.points.push_back(std::move(contact));
    follows = true;
  }
  if (follows) contacts.pairs.push_back(pair);
  return follows;
}

}  // namespace engine

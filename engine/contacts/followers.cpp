#include <algorithm>
#include <utility>

#include "engine/contacts/world.h"

namespace engine {

void World::add_followers(const std::vector<Placed>& bodies, const std::vector<Pair>& pairs,
                          double step, Contacts& contacts) {
  const double slow = impact_speed(gravity_);
  const auto moving = [&](BodyId id) {
    const auto found = std::ranges::lower_bound(bodies, id, {}, &Placed::body);
    const bool known = found != bodies.end() && found->body == id;
    return known && found->state.linear_velocity.norm() > slow ? &*found : nullptr;
  };
  std::vector<const Placed*> stopped;
  const auto stop = [&](BodyId id) {
    const Placed* body = moving(id);
    if (body && std::ranges::find(stopped, body) == stopped.end()) stopped.push_back(body);
  };
  for (const Contact& contact : contacts.points) {
    if (!contact.rebounds || contact.restitution > 0) continue;
    stop(contact.pair.first);
    stop(contact.pair.second);
  }
  std::vector<Pair> touching = contacts.pairs;
  for (std::size_t i = 0; i < stopped.size(); ++i) {
    const Placed& held = *stopped[i];
    set_state(held.body, held.start);
    for (const Pair& pair : pairs) {
      if (pair.first != held.body && pair.second != held.body) continue;
      const Placed* other = moving(pair.first == held.body ? pair.second : pair.first);
      if (!other || std::ranges::find(stopped, other) != stopped.end()) continue;
      if (std::ranges::binary_search(touching, pair) || add_follower(pair, *other, step, contacts))
        stop(other->body);
    }
    set_state(held.body, held.state);
  }
  std::ranges::sort(contacts.pairs);
  std::ranges::stable_sort(contacts.points, {}, &Contact::pair);
}

bool World::add_follower(const Pair& pair, const Placed& follower, double step,
                         Contacts& contacts) {
  if (surfaces_.between(pair).restitution > 0) return false;
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
    Contact contact = contact_at(pair, point, law, step);
    contact.row.speed = (std::min(point.depth, 0.0) - law.rest) / step;
    contact.rebounds = false;
    contacts.points.push_back(std::move(contact));
    follows = true;
  }
  if (follows) contacts.pairs.push_back(pair);
  return follows;
}

}  // namespace engine

#include "engine/contacts/contact_surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace engine {
namespace {

Surface checked(double friction, double restitution, const std::string& whose) {
  if (!(friction >= 0 && std::isfinite(friction)))
    throw std::invalid_argument(
        fmt::format("the friction of {} is {}, expected a number >= 0", whose, friction));
  if (!(restitution >= 0 && restitution <= 1))
    throw std::invalid_argument(
        fmt::format("the restitution of {} is {}, expected 0 … 1", whose, restitution));
  return {.friction = friction, .restitution = restitution};
}

/// The pair of a specification, ascending.
Pair checked_pair(const ContactSpec& contact, std::size_t bodies) {
  const Pair pair = std::minmax(contact.first, contact.second);
  if (pair.first < kWorld || pair.second >= static_cast<BodyId>(bodies))
    throw std::invalid_argument(fmt::format("there is no body {}", pair.second));
  if (pair.first == pair.second)
    throw std::invalid_argument("a contact needs two different bodies, or a body and the ground");
  return pair;
}

}  // namespace

ContactSurfaces::ContactSurfaces(const SimulationSpec& spec)
    : ground_(checked(spec.ground_friction, spec.ground_restitution, "the ground")) {
  for (const BodySpec& body : spec.bodies)
    bodies_.push_back(
        checked(body.friction, body.restitution, fmt::format("body '{}'", body.name)));
  for (const ContactSpec& contact : spec.contacts) {
    const Pair pair = checked_pair(contact, bodies_.size());
    const Surface combined = between(pair);
    const Surface given = checked(contact.friction.value_or(combined.friction),
                                  contact.restitution.value_or(combined.restitution), "a contact");
    if (!pairs_.emplace(pair, given).second)
      throw std::invalid_argument("the contact of a pair is given twice");
  }
}

Surface ContactSurfaces::between(const Pair& pair) const {
  const auto given = pairs_.find(pair);
  if (given != pairs_.end()) return given->second;
  const Surface first = of(pair.first), second = of(pair.second);
  return {.friction = std::sqrt(first.friction * second.friction),
          .restitution = std::max(first.restitution, second.restitution)};
}

Surface ContactSurfaces::of(BodyId body) const {
  if (body == kWorld) return ground_;
  // A world that is built by hand, body by body, has the default surfaces.
  return bodies_.empty() ? Surface{} : bodies_.at(body);
}

}  // namespace engine

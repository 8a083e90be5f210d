#include "engine/contacts/contact_memory.h"

#include <algorithm>
#include <cassert>

namespace engine {

using Eigen::Vector3d;

std::vector<ContactForce> remembered(const std::vector<Contact>& contacts,
                                     const StateOf& state_of) {
  std::vector<ContactForce> memory;
  memory.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    const hydro::BodyState second = state_of(contact.pair.second);
    const Eigen::Quaterniond to_B = second.orientation.conjugate();
    memory.push_back({.pair = contact.pair,
                      .place_B = to_B * (contact.point.position_W - second.position),
                      .force_B = to_B * contact.force_W});
  }
  return memory;
}

std::span<const ContactForce> forces_of(const Pair& pair, const std::vector<ContactForce>& memory) {
  assert(std::ranges::is_sorted(memory, {}, &ContactForce::pair));
  return {std::ranges::lower_bound(memory, pair, {}, &ContactForce::pair),
          std::ranges::upper_bound(memory, pair, {}, &ContactForce::pair)};
}

void recall(const std::vector<ContactForce>& memory, const StateOf& state_of,
            std::vector<Contact>& contacts) {
  for (std::size_t i = 0; i < contacts.size();) {
    const Pair pair = contacts[i].pair;
    const auto end = std::find_if(contacts.begin() + static_cast<std::ptrdiff_t>(i), contacts.end(),
                                  [&](const Contact& other) { return other.pair != pair; });
    const auto now = static_cast<std::size_t>(end - contacts.begin()) - i;
    const std::span<const ContactForce> known = forces_of(pair, memory);
    const hydro::BodyState second = known.empty() ? hydro::BodyState{} : state_of(pair.second);
    const double fraction =
        std::min(1.0, static_cast<double>(known.size()) / static_cast<double>(now));
    for (const std::size_t last = i + now; i < last; ++i) {
      contacts[i].force_W.setZero();
      if (known.empty()) continue;
      const Vector3d place_B =
          second.orientation.conjugate() * (contacts[i].point.position_W - second.position);
      const auto distance = [&](const ContactForce& f) {
        return (f.place_B - place_B).squaredNorm();
      };
      contacts[i].force_W =
          fraction * (second.orientation * std::ranges::min_element(known, {}, distance)->force_B);
    }
  }
}

}  // namespace engine

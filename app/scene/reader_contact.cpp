#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

const char* const kGround = "world";

/// The reason why contacts of a body cannot occur; empty if they can.
std::string reason_for_no_contact(const MapReader& map, const Scene& scene,
                                  const std::string& name) {
  if (name == kGround)
    return map.has("ground") ? "" : "world stands for the ground, and the scene has none";
  const auto body = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                 [&](const Body& other) { return other.name == name; });
  const bool passes = body != scene.bodies.end() && body->collision == Collision::none;
  return passes ? fmt::format("{} has collision: none and passes through everything", name) : "";
}

std::pair<std::string, std::string> ordered(const std::array<std::string, 2>& names) {
  return std::minmax(names[0], names[1]);
}

/// The joint that lets two bodies pass through each other; null for none.
const Joint* joint_between(const Scene& scene, const std::array<std::string, 2>& names) {
  for (const Joint& joint : scene.joints)
    if (ordered(joint.bodies) == ordered(names) && names[0] != kGround && names[1] != kGround)
      return &joint;
  return nullptr;
}

}  // namespace

void read(MapReader& map, Contact& contact) {
  read_pair(map, contact.bodies);
  map.optional("friction", contact.friction, not_negative());
  map.optional("restitution", contact.restitution, between(0, 1));
  if (!map.has("friction") && !map.has("restitution"))
    map.fault("", "missing, expected friction, restitution or both");
}

void read_surface(MapReader& map, double& friction, double& restitution) {
  map.optional("friction", friction, not_negative());
  map.optional("restitution", restitution, between(0, 1));
}

void read(MapReader& map, BedSuction& suction) {
  map.required("pressure", suction.pressure, not_negative("Pa"));
  map.required("time", suction.time, positive("s"));
}

void check_contacts(MapReader& map, const Scene& scene) {
  std::map<std::pair<std::string, std::string>, std::size_t> first_uses;
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    const std::array<std::string, 2>& names = scene.contacts[i].bodies;
    if (names[0].empty() || names[1].empty() || names[0] == names[1]) continue;
    const std::string list = fmt::format("contacts[{}].bodies", i);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string reason = reason_for_no_contact(map, scene, names[k]);
      if (!reason.empty()) map.fault(fmt::format("{}[{}]", list, k), reason);
    }
    if (const Joint* joint = joint_between(scene, names))
      map.fault(list, fmt::format("{} and {} pass through each other, as {} joins them", names[0],
                                  names[1], joint->name));
    const auto [first, is_new] = first_uses.emplace(ordered(names), i);
    if (!is_new)
      map.fault(list, fmt::format("found {} and {}, which is the pair of contacts[{}]; expected "
                                  "another",
                                  names[0], names[1], first->second));
  }
}

}  // namespace scene

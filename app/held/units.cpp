#include "app/held/units.h"

#include <string_view>

namespace app {
namespace {

constexpr std::string_view kOr = " or ";

}  // namespace

std::string units_of(const scene::SetPoint& set_point, const scene::Scene& scene) {
  using Of = scene::SetPoint::Of;
  const std::string key = set_point.name.substr(set_point.name.rfind('.') + 1);
  switch (set_point.of) {
    case Of::load_factor:
      return "1";
    case Of::rope_rate:
      return "m/s";
    case Of::propeller_speed:
      return "1/s";
    case Of::pump_rate:
      return "m^3/s";
    case Of::joint_motor: {
      const bool hinge = scene.joints[set_point.index].type == scene::Joint::Type::hinge;
      if (key == "angle_deg") return "deg";
      if (key == "speed") return hinge ? "rad/s" : "m/s";
      if (key == "torque") return "N m";
      return key == "force" ? "N" : "m";
    }
    case Of::spring_length:
    case Of::rope_length:
      return "m";
    case Of::propeller_azimuth:
    case Of::rudder_angle:
    case Of::sail_angle:
      break;
  }
  return "deg";
}

std::string units_of_motion(const std::string& quantity) {
  if (quantity == "turn_rate_deg") return "deg/s";
  if (quantity.ends_with("_deg")) return "deg";
  if (quantity == "speed" || quantity == "sway" || quantity.starts_with("v")) return "m/s";
  if (quantity.starts_with("w")) return "rad/s";
  return quantity.starts_with("q") ? "1" : "m";
}

std::string units_of_probe(const std::string& column) {
  switch (column.front()) {
    case 'v':
      return "m/s";
    case 'a':
    case 's':
      return "m/s^2";
    case 'w':
      return "rad/s";
    default:
      return "m";
  }
}

std::string units_of_joint(const std::string& units, const engine::JointSpec& joint) {
  const std::size_t both = units.find(kOr);
  if (both == std::string::npos) return units;
  return joint.type == engine::JointSpec::Type::hinge ? units.substr(0, both)
                                                      : units.substr(both + kOr.size());
}

}  // namespace app

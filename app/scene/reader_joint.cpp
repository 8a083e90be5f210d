#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

using JointType = Joint::Type;

const ChoiceRule<JointType> kTypes = {{{"ball", JointType::ball},
                                       {"hinge", JointType::hinge},
                                       {"slider", JointType::slider},
                                       {"fixed", JointType::fixed},
                                       {"universal", JointType::universal}}};

/// True if a joint of this type has the optional key.
bool needs_anchor(JointType type) { return type != JointType::slider && type != JointType::fixed; }
bool has_axis(JointType type) { return type != JointType::ball && type != JointType::fixed; }

/// Notes the conditions that `check_keys` checks.
void note_keys(MapReader& map) {
  for (const auto& [word, type] : kTypes.choices) {
    std::vector<std::string> needed, refused;
    if (needs_anchor(type)) needed.push_back("anchor");
    (has_axis(type) ? needed : refused).push_back("axis");
    if (type != JointType::universal) refused.push_back("axis2");
    map.note_condition("type", word, needed, refused);
  }
}

const char* const kZeroDirection = "found a zero vector, expected a direction";

Eigen::Vector3d unit_vector(const Eigen::Vector3d& v) {
  return (v / v.cwiseAbs().maxCoeff()).normalized();
}

/// Reads a direction that may be absent.
void read_direction(MapReader& map, const std::string& key, std::optional<Eigen::Vector3d>& axis) {
  if (!map.optional(key, axis, number())) return;
  if (axis->isZero(0)) {
    map.fault(key, kZeroDirection);
    axis.reset();
    return;
  }
  axis = unit_vector(*axis);
}

/// Largest deviation from a right angle between the axes of a universal joint [rad]; it covers
/// rounding to three digits.
constexpr double kSquareness = 2e-3;

/// Makes the second axis of a universal joint exactly normal to the first.
void square_axes(MapReader& map, const Eigen::Vector3d& axis, Eigen::Vector3d& axis2) {
  const double angle = std::acos(std::clamp(axis.dot(axis2), -1.0, 1.0));
  if (std::abs(angle - std::numbers::pi / 2) > kSquareness)
    map.fault("axis2",
              fmt::format("found an axis at {:.1f} deg to axis, expected a perpendicular one",
                          angle * 180 / std::numbers::pi));
  else
    axis2 = (axis2 - axis.dot(axis2) * axis).normalized();
}

void check_type_has(MapReader& map, const char* type, const char* key, bool needed, bool allowed) {
  if (needed && !map.has(key)) map.fault(key, fmt::format("missing, a {} joint needs one", type));
  if (!allowed && map.has(key)) map.fault(key, fmt::format("not used by a {} joint", type));
}

void check_keys(MapReader& map, JointType type) {
  const std::string name = Field<ChoiceRule<JointType>, JointType>::text(kTypes, type);
  check_type_has(map, name.c_str(), "anchor", needs_anchor(type), true);
  check_type_has(map, name.c_str(), "axis", has_axis(type), has_axis(type));
  check_type_has(map, name.c_str(), "axis2", false, type == JointType::universal);
}

}  // namespace

void read_pair(MapReader& map, std::array<std::string, 2>& bodies) {
  const std::string expected = "a list of two names of bodies, one may be world";
  const auto value =
      map.find("bodies", expected, "required", {list_shape({.kind = ValueShape::Kind::text}, 2)});
  if (!value) return;
  if (!value->node.is(YamlNode::Kind::list) || value->node.items.size() != bodies.size()) {
    value->refuse(expected);
    return;
  }
  bool all = true;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    all = Field<TextRule, std::string>::read(value->item(i), {"the name of a body"}, bodies[i]) &&
          all;
  if (all && bodies[0] == bodies[1])
    value->fault(fmt::format("found {} twice, expected two different bodies", bodies[0]));
}

bool read_direction(MapReader& map, const std::string& key, Eigen::Vector3d& axis) {
  Eigen::Vector3d given = axis;
  if (!map.optional(key, given, number())) return false;
  if (given.isZero(0)) {
    map.fault(key, kZeroDirection);
    return false;
  }
  axis = unit_vector(given);
  return true;
}

void read(MapReader& map, Joint& joint) {
  map.optional("name", joint.name, NameRule{"joints"});
  const bool typed = map.required("type", joint.type, kTypes);
  read_pair(map, joint.bodies);
  map.optional("anchor", joint.anchor, number("m"));
  read_direction(map, "axis", joint.axis);
  read_direction(map, "axis2", joint.axis2);
  note_keys(map);
  if (joint.axis && joint.axis2) square_axes(map, *joint.axis, *joint.axis2);
  if (typed) check_keys(map, joint.type);
  read_drive(map, typed ? std::optional(joint.type) : std::nullopt, joint.drive);
}

}  // namespace scene

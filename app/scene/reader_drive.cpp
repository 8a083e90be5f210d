#include <fmt/format.h>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

using Type = Joint::Type;

/// The block `motor`, with the keys of both types of joint.
struct MotorBlock {
  std::optional<double> speed, angle, position, torque, force;
  std::optional<double> max_torque, max_force;
  double rate = 5;
};

void read(MapReader& map, MotorBlock& motor) {
  map.exactly_one_of({"speed", "angle_deg", "position", "torque", "force"});
  map.optional("speed", motor.speed, number("rad/s or m/s"));
  map.optional("angle_deg", motor.angle, degrees());
  map.optional("position", motor.position, number("m"));
  map.optional("torque", motor.torque, number("N m"));
  map.optional("force", motor.force, number("N"));
  map.optional("max_torque", motor.max_torque, positive("N m"));
  map.optional("max_force", motor.max_force, positive("N"));
  map.optional("rate", motor.rate, positive("1/s"));
  if (map.has("rate") && !map.has("angle_deg") && !map.has("position"))
    map.fault("rate", "is only used with angle_deg or position");
}

JointMotor built(const MotorBlock& block) {
  using Mode = JointMotor::Mode;
  JointMotor motor{.rate = block.rate};
  if (block.speed) motor.value = *block.speed;
  for (const auto& value : {block.angle, block.position})
    if (value) motor = {.mode = Mode::position, .value = *value, .rate = block.rate};
  for (const auto& value : {block.torque, block.force})
    if (value) motor = {.mode = Mode::effort, .value = *value, .rate = block.rate};
  for (const auto& most : {block.max_torque, block.max_force})
    if (most) motor.largest_effort = *most;
  return motor;
}

/// A value of a key that only one type of joint has.
struct OwnKey {
  const char* key;
  bool given;
  Type owner;
  const char* other;  ///< The key that the other type has in its place.
};

/// Refuses a key that the type of the joint does not have.
void check_owner(MapReader& map, Type type, const OwnKey& own) {
  if (own.given && own.owner != type)
    map.fault(own.key, fmt::format("not used by a {} joint, expected {}",
                                   type == Type::hinge ? "hinge" : "slider", own.other));
}

constexpr std::array<const char*, 8> kDriveKeys = {"limits_deg", "limits", "motor",   "stiffness",
                                                   "rest_deg",   "rest",   "damping", "friction"};

/// Refuses limits that the coordinate is outside of at the start, where it is 0.
void check_limits(MapReader& map, const char* key,
                  const std::optional<std::array<double, 2>>& limits) {
  if (!limits) return;
  if ((*limits)[0] > (*limits)[1])
    map.fault(key, "expected the lower limit first: [lo, hi] with lo < hi");
  else if ((*limits)[0] > 0 || (*limits)[1] < 0)
    map.fault(key, "does not include 0, where the joint is at the start");
}

/// The coordinates of both types.
struct Coordinates {
  std::optional<std::array<double, 2>> angles, positions;
  std::optional<double> rest_angle, rest_position;
};

void check_owners(MapReader& map, Type type, const Coordinates& at, const MotorBlock& motor) {
  for (const OwnKey& own :
       {OwnKey{"limits_deg", map.has("limits_deg"), Type::hinge, "limits"},
        OwnKey{"limits", map.has("limits"), Type::slider, "limits_deg"},
        OwnKey{"rest_deg", at.rest_angle.has_value(), Type::hinge, "rest"},
        OwnKey{"rest", at.rest_position.has_value(), Type::slider, "rest_deg"},
        OwnKey{"motor.angle_deg", motor.angle.has_value(), Type::hinge, "position"},
        OwnKey{"motor.position", motor.position.has_value(), Type::slider, "angle_deg"},
        OwnKey{"motor.torque", motor.torque.has_value(), Type::hinge, "force"},
        OwnKey{"motor.force", motor.force.has_value(), Type::slider, "torque"},
        OwnKey{"motor.max_torque", motor.max_torque.has_value(), Type::hinge, "max_force"},
        OwnKey{"motor.max_force", motor.max_force.has_value(), Type::slider, "max_torque"}})
    check_owner(map, type, own);
}

void note_owners(MapReader& map) {
  map.note_condition("type", "hinge", {}, {"limits", "rest"});
  map.note_condition("type", "slider", {}, {"limits_deg", "rest_deg"});
  for (const char* type : {"ball", "fixed", "universal"})
    map.note_condition("type", type, {}, {kDriveKeys.begin(), kDriveKeys.end()});
}

}  // namespace

void read_drive(MapReader& map, std::optional<Type> type, JointDrive& drive) {
  Coordinates at;
  map.optional("limits_deg", at.angles, degrees_between(-180, 180));
  map.optional("limits", at.positions, number("m"));
  MotorBlock motor;
  const bool has_motor = map.block("motor", motor);
  map.optional("stiffness", drive.stiffness, not_negative("N m/rad or N/m"));
  map.optional("rest_deg", at.rest_angle, degrees());
  map.optional("rest", at.rest_position, number("m"));
  map.optional("damping", drive.damping, not_negative("N m s/rad or N s/m"));
  map.optional("friction", drive.friction, not_negative("N m or N"));
  note_owners(map);
  check_limits(map, "limits_deg", at.angles);
  check_limits(map, "limits", at.positions);
  if (!type) return;
  if (*type == Type::hinge || *type == Type::slider) {
    check_owners(map, *type, at, motor);
  } else {
    for (const char* key : kDriveKeys)
      if (map.has(key)) map.fault(key, "not used by this type of joint, only by hinge and slider");
  }
  drive.limits = at.angles ? at.angles : at.positions;
  if (has_motor) drive.motor = built(motor);
  drive.rest = at.rest_angle ? *at.rest_angle : at.rest_position.value_or(0);
}

}  // namespace scene

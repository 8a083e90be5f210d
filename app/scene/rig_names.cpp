#include "app/scene/rig_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace scene {

namespace {

using Of = SetPoint::Of;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

constexpr std::array<const char*, 10> kBodyQuantities = {
    "x",    "y",           "z",         "depth",    "speed",
    "sway", "heading_deg", "pitch_deg", "roll_deg", "turn_rate_deg"};

bool is_set(const Scene& scene, const std::string& name) {
  return std::any_of(scene.controls.begin(), scene.controls.end(),
                     [&](const Control& control) { return control.set == name; });
}

void add_load_factors(const Scene& scene, std::vector<SetPoint>& all) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (std::size_t k = 0; k < scene.bodies[i].forces.size(); ++k)
      all.push_back({.name = fmt::format("bodies[{}].forces[{}].factor", scene.bodies[i].name, k),
                     .of = Of::load_factor,
                     .index = i,
                     .load = k,
                     .initial = scene.bodies[i].forces[k].factor.value_or(1)});
}

void add_motors(const Scene& scene, std::vector<SetPoint>& all) {
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const Joint& joint = scene.joints[i];
    if (!joint.drive.motor) continue;
    const std::string key = motor_key(joint);
    all.push_back({.name = fmt::format("joints[{}].motor.{}", joint.name, key),
                   .of = Of::joint_motor,
                   .index = i,
                   .initial = joint.drive.motor->value,
                   .unit = key == "angle_deg" ? kRadiansPerDegree : 1});
  }
}

void add_lengths(const Scene& scene, std::vector<SetPoint>& all) {
  for (std::size_t i = 0; i < scene.springs.size(); ++i)
    all.push_back({.name = fmt::format("springs[{}].length", scene.springs[i].name),
                   .of = Of::spring_length,
                   .index = i,
                   .initial = scene.springs[i].length,
                   .least = 0});
  for (std::size_t i = 0; i < scene.ropes.size(); ++i) {
    const Rope& rope = scene.ropes[i];
    all.push_back({.name = fmt::format("ropes[{}].length", rope.name),
                   .of = Of::rope_length,
                   .index = i,
                   .initial = rope.length,
                   .least = rope.shortest});
    all.push_back({.name = fmt::format("ropes[{}].rate", rope.name),
                   .of = Of::rope_rate,
                   .index = i,
                   .initial = rope.rate});
  }
}

template <class Foils>
void add_angles(const Foils& foils, const char* list, Of of, std::vector<SetPoint>& all) {
  for (std::size_t i = 0; i < foils.size(); ++i)
    all.push_back({.name = fmt::format("{}[{}].angle_deg", list, foils[i].name),
                   .of = of,
                   .index = i,
                   .initial = foils[i].angle,
                   .unit = kRadiansPerDegree});
}

void add_propellers(const Scene& scene, std::vector<SetPoint>& all) {
  for (std::size_t i = 0; i < scene.propellers.size(); ++i) {
    const Propeller& propeller = scene.propellers[i];
    const std::string head = fmt::format("propellers[{}].", propeller.name);
    all.push_back({.name = head + "speed_rps",
                   .of = Of::propeller_speed,
                   .index = i,
                   .initial = propeller.speed});
    all.push_back({.name = head + "azimuth_deg",
                   .of = Of::propeller_azimuth,
                   .index = i,
                   .initial = propeller.azimuth,
                   .unit = kRadiansPerDegree});
  }
}

void add_pumps(const Scene& scene, std::vector<SetPoint>& all) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (std::size_t k = 0; k < scene.bodies[i].pumps.size(); ++k)
      all.push_back({.name = fmt::format("pumps[{}].rate", scene.bodies[i].pumps[k].name),
                     .of = Of::pump_rate,
                     .index = i,
                     .load = k,
                     .initial = scene.bodies[i].pumps[k].rate,
                     .least = 0});
}

/// True if the scene has this set point.
bool has(const Scene& scene, const SetPoint& point) {
  if (point.of == Of::load_factor) {
    const AppliedLoad& load = scene.bodies[point.index].forces[point.load];
    return load.factor || load.formula || load.file || is_set(scene, point.name);
  }
  if (point.of == Of::rope_length) return is_set(scene, point.name);
  if (point.of == Of::rope_rate)
    return !is_set(scene, fmt::format("ropes[{}].length", scene.ropes[point.index].name));
  return true;
}

template <class Lines>
void add_lines(const Lines& lines, const char* list, Measurable::Of of,
               std::vector<Measurable>& all) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const char* quantity : {"tension", "distance"})
      all.push_back({fmt::format("{}[{}].{}", list, lines[i].name, quantity), of, i, quantity});
}

}  // namespace

std::string motor_key(const Joint& joint) {
  const bool hinge = joint.type == Joint::Type::hinge;
  switch (joint.drive.motor.value_or(JointMotor()).mode) {
    case JointMotor::Mode::speed:
      return "speed";
    case JointMotor::Mode::position:
      return hinge ? "angle_deg" : "position";
    case JointMotor::Mode::effort:
      break;
  }
  return hinge ? "torque" : "force";
}

std::vector<SetPoint> settable(const Scene& scene) {
  std::vector<SetPoint> all;
  add_load_factors(scene, all);
  add_motors(scene, all);
  add_lengths(scene, all);
  add_propellers(scene, all);
  add_angles(scene.rudders, "rudders", Of::rudder_angle, all);
  add_angles(scene.sails, "sails", Of::sail_angle, all);
  add_pumps(scene, all);
  return all;
}

std::vector<SetPoint> set_points(const Scene& scene) {
  std::vector<SetPoint> all = settable(scene);
  std::erase_if(all, [&](const SetPoint& point) { return !has(scene, point); });
  return all;
}

std::vector<Measurable> measurable(const Scene& scene) {
  std::vector<Measurable> all;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (const char* quantity : kBodyQuantities)
      all.push_back({scene.bodies[i].name + "." + quantity, Measurable::Of::body, i, quantity});
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const Joint& joint = scene.joints[i];
    if (joint.type != Joint::Type::hinge && joint.type != Joint::Type::slider) continue;
    for (const char* quantity :
         {joint.type == Joint::Type::hinge ? "angle_deg" : "position", "speed"})
      all.push_back(
          {fmt::format("joints[{}].{}", joint.name, quantity), Measurable::Of::joint, i, quantity});
  }
  add_lines(scene.springs, "springs", Measurable::Of::spring, all);
  add_lines(scene.ropes, "ropes", Measurable::Of::rope, all);
  add_lines(scene.moorings, "moorings", Measurable::Of::mooring, all);
  return all;
}

}  // namespace scene

#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/scene.h"

/// @file
/// Names of what controls set and measure.

namespace scene {

/// A value that a control may set.
struct SetPoint {
  enum class Of {
    load_factor,
    joint_motor,
    spring_length,
    rope_length,
    rope_rate,
    propeller_speed,
    propeller_azimuth,
    rudder_angle,
    sail_angle,
    pump_rate
  };
  std::string name;  ///< `propellers[main].speed_rps`
  Of of = Of::load_factor;
  std::size_t index = 0;  ///< Index of the body, joint, line or machine in its list.
  std::size_t load = 0;   ///< Index in the body's `forces` or `pumps`.
  /// In SI units; none for a length that follows from the points at time 0.
  std::optional<double> initial = 0;
  double unit = 1;                                          ///< SI units per unit of the name.
  double least = -std::numeric_limits<double>::infinity();  ///< In SI units.
};

/// Returns everything that a control of this scene could set.
std::vector<SetPoint> settable(const Scene& scene);

/// Returns the set points that the scene has: of a rope its `rate`, or its `length` where a control
/// sets that; of a load its factor where a key or a control gives it.
std::vector<SetPoint> set_points(const Scene& scene);

/// A quantity that a control may measure.
struct Measurable {
  enum class Of { body, joint, spring, rope, mooring };
  std::string name;  ///< `tug.heading_deg`
  Of of = Of::body;
  std::size_t index = 0;
  std::string quantity;  ///< `heading_deg`
};

/// Returns everything that a control of this scene could measure.
std::vector<Measurable> measurable(const Scene& scene);

/// Returns the entry of a name; null if there is none.
template <class T>
const T* find_named(const std::vector<T>& all, const std::string& name) {
  for (const T& one : all)
    if (one.name == name) return &one;
  return nullptr;
}

/// Returns the names of entries, in order.
template <class T>
std::vector<std::string> names_of(const std::vector<T>& all) {
  std::vector<std::string> names;
  for (const T& one : all) names.push_back(one.name);
  return names;
}

/// Returns the key that drives the motor of a joint: `angle_deg`.
std::string motor_key(const Joint& joint);

}  // namespace scene

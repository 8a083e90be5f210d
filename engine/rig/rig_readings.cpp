#include "engine/base/rig_readings.h"

#include "engine/base/body_quantity.h"
#include "engine/rig/rig.h"

namespace engine {

using Eigen::Vector3d;
using Quantity = Measurement::Quantity;

LinePull Rig::pull_now(std::size_t index, const std::vector<hydro::BodyState>& states,
                       double time) const {
  const LineSpec& line = spec_->lines[index];
  const LineEnd first = line_end(line.first, states), second = line_end(line.second, states);
  if (dynamic_->has(index))
    return {.tension = dynamic_->tension(index),
            .force_W = dynamic_->force(index),
            .distance = (second.place_W - first.place_W).norm()};
  return pull_of(line, length_at(index, time), first, second, sea_, time, lines_[index].pull);
}

/// The tension of a row is its mean over the last step: the state at one time does not tell it.
double Rig::tension_now(std::size_t index, const LinePull& pull, double h) const {
  if (lines_[index].broken) return 0;
  return is_row_[index] ? lines_[index].impulse / h : pull.tension;
}

JointBodies Rig::joint_bodies(std::size_t joint,
                              const std::vector<hydro::BodyState>& states) const {
  const auto state = [&](BodyId body) { return body == kWorld ? nullptr : &states[body]; };
  return {state(spec_->joints[joint].first), state(spec_->joints[joint].second)};
}

double Rig::measure(const Measurement& of, const std::vector<hydro::BodyState>& states, double time,
                    double h) const {
  const std::size_t i = of.index;
  switch (of.quantity) {
    case Quantity::joint:
      return drives_[i].coordinate.value(joint_bodies(i, states));
    case Quantity::joint_speed:
      return drives_[i].coordinate.rate(joint_bodies(i, states));
    case Quantity::tension:
      return tension_now(i, pull_now(i, states, time), h);
    case Quantity::line_length:
      return pull_now(i, states, time).distance;
    default:
      return body_quantity(of.quantity, states[i], sea_ ? sea_->level : 0);
  }
}

LineReading Rig::line_reading(std::size_t index, const std::vector<hydro::BodyState>& states,
                              double time, double h) const {
  const LineSpec& line = spec_->lines[index];
  const LinePull pull = pull_now(index, states, time);
  LineReading reading{.tension = tension_now(index, pull, h),
                      .distance = pull.distance,
                      .length = length_at(index, time).length,
                      .broken = lines_[index].broken,
                      .first_W = line_end(line.first, states).place_W,
                      .second_W = line_end(line.second, states).place_W};
  reading.taut = reading.tension != 0;
  if (reading.broken) return reading;
  if (pull.catenary) reading.resting = pull.catenary->resting;
  if (dynamic_->has(index)) {
    reading.nodes_W = dynamic_->nodes(index);
    reading.resting = dynamic_->resting(index, reading.length);
  }
  reading.force_W = pull.force_W;
  if (is_row_[index] && pull.distance > 0)
    reading.force_W = reading.tension / pull.distance * (reading.second_W - reading.first_W);
  return reading;
}

JointReading Rig::joint_reading(std::size_t index, const std::vector<hydro::BodyState>& states,
                                double time, double h) const {
  const JointSpec& joint = spec_->joints[index];
  JointReading reading{.force_W = joints_[index].force / h,
                       .moment_W = joints_[index].moment / h,
                       .place_W = drives_[index].coordinate.place_W(joint_bodies(index, states)),
                       .effort = joints_[index].effort / h};
  const Drive& drive = drives_[index];
  if (!drive.has_coordinate) return reading;
  const JointBodies bodies = joint_bodies(index, states);
  reading.coordinate = drive.coordinate.value(bodies);
  reading.speed = drive.coordinate.rate(bodies);
  reading.effort +=
      drive_load(joint.drive, *set_points_, time, reading.coordinate, reading.speed, drive.stiff);
  reading.damper = -joint.drive.damping * reading.speed;
  reading.spring = -joint.drive.stiffness * (reading.coordinate - joint.drive.rest);
  reading.motor = joints_[index].motor / h + motor_load(joint.drive, *set_points_);
  return reading;
}

std::vector<hydro::Wrench> Rig::loads_now(const std::vector<hydro::BodyState>& states,
                                          double time) const {
  std::vector<hydro::Wrench> loads(states.size());
  const auto add = [&](BodyId body, const Vector3d& force, const Vector3d& at_W) {
    if (body == kWorld) return;
    loads[body].force += force;
    loads[body].moment += (at_W - states[body].position).cross(force);
  };
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (is_row_[i] || lines_[i].broken || dynamic_->has(i)) continue;
    const LineSpec& line = spec_->lines[i];
    const Vector3d force = pull_now(i, states, time).force_W;
    add(line.first.body, force, line_end(line.first, states).place_W);
    add(line.second.body, -force, line_end(line.second, states).place_W);
  }
  for (std::size_t i = 0; i < states.size(); ++i)
    dynamic_->add_load(static_cast<BodyId>(i), states[i], loads[i]);
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    const JointSpec& joint = spec_->joints[i];
    if (!drives_[i].has_coordinate || !joint.drive.acts()) continue;
    const JointCoordinate& coordinate = drives_[i].coordinate;
    const JointBodies bodies = joint_bodies(i, states);
    const Vector3d push = drive_load(joint.drive, *set_points_, time, coordinate.value(bodies),
                                     coordinate.rate(bodies), drives_[i].stiff) *
                          coordinate.axis_W(bodies);
    for (const auto& [body, sign] : {std::pair(joint.first, -1.0), std::pair(joint.second, 1.0)}) {
      if (coordinate.turns() && body != kWorld) loads[body].moment += sign * push;
      if (!coordinate.turns()) add(body, sign * push, coordinate.place_W(bodies));
    }
  }
  return loads;
}

RigReadings Rig::readings(const std::vector<hydro::BodyState>& states, double time,
                          double h) const {
  RigReadings readings;
  for (std::size_t i = 0; i < lines_.size(); ++i)
    readings.lines.push_back(line_reading(i, states, time, h));
  for (std::size_t i = 0; i < joints_.size(); ++i)
    readings.joints.push_back(joint_reading(i, states, time, h));
  for (std::size_t i = 0; i < turns_.size(); ++i) {
    readings.propellers.push_back(machines_->propeller(i, states[spec_->propellers[i].body], time));
    readings.propellers.back().turn = turns_[i];
  }
  for (std::size_t i = 0; i < spec_->foils.size(); ++i)
    readings.foils.push_back(machines_->foil(i, states[spec_->foils[i].body], time));
  readings.set_points = set_points_->readings();
  return readings;
}

}  // namespace engine

#include "app/run/rig_totals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

}  // namespace

void RigTotals::Line::add(double time, const engine::LineReading& reading) {
  if (reading.tension > most) {
    most = reading.tension;
    at = time;
  }
  if (reading.broken && !broken) broken = time;
}

void RigTotals::Part::add(double energy, double mean_square, double most, double interval) {
  work += energy;
  square += mean_square * interval;
  largest = std::max(largest, most);
  power = steps == 0 ? energy / interval : std::max(power, energy / interval);
  ++steps;
}

Json RigTotals::Part::json(double seconds) const {
  const double time = steps > 0 ? seconds : 1;
  return {{"power_mean", work / time},
          {"power_max", power},
          {"effort_rms", std::sqrt(square / time)},
          {"effort_max", largest}};
}

void RigTotals::Joint::begin(const engine::JointReading& now) {
  least = most = coordinate = now.coordinate;
  latest = {now.coordinate, now.speed, now.damper, now.spring};
}

// The power of a damper over a step is the mean of its ends; that of spring and motor is the work
// of their mean effort along the way, which is exact for both.
void RigTotals::Joint::add(const engine::JointReading& now, bool turns, double interval) {
  const auto& [q, rate, damper, spring] = latest;
  double way = now.coordinate - q;
  if (turns) way = std::remainder(way, 2 * std::numbers::pi);
  coordinate += way;
  least = std::min(least, coordinate);
  most = std::max(most, coordinate);
  const auto mean = [](double a, double b) { return (a + b) / 2; };
  const auto mean_square = [&](double a, double b) { return mean(a * a, b * b); };
  const double by_damper = -mean(damper * rate, now.damper * now.speed) * interval,
               by_spring = -mean(spring, now.spring) * way, by_motor = -now.motor * way;
  of_damper.add(by_damper, mean_square(damper, now.damper), std::abs(now.damper), interval);
  of_spring.add(by_spring, mean_square(spring, now.spring), std::abs(now.spring), interval);
  of_motor.add(by_motor, now.motor * now.motor, std::abs(now.motor), interval);
  const double before = damper + spring + now.motor, after = now.damper + now.spring + now.motor;
  all.add(by_damper + by_spring + by_motor, mean_square(before, after), std::abs(after), interval);
  latest = {now.coordinate, now.speed, now.damper, now.spring};
}

Json RigTotals::Part::state() const { return {steps, work, power, square, largest}; }

void RigTotals::Part::restore(const Json& state) {
  steps = state.at(0).get<long>();
  work = state.at(1).get<double>();
  power = state.at(2).get<double>();
  square = state.at(3).get<double>();
  largest = state.at(4).get<double>();
}

void RigTotals::add(double time, const engine::SimulationSpec& spec,
                    const engine::RigReadings& readings) {
  joints_.resize(readings.joints.size());
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const bool turns = spec.joints[i].type == engine::JointSpec::Type::hinge;
    if (readings_ == 0)
      joints_[i].begin(readings.joints[i]);
    else if (time > latest_)
      joints_[i].add(readings.joints[i], turns, time - latest_);
  }
  if (readings_ == 0) start_ = time;
  latest_ = time;
  ++readings_;
  lines_.resize(readings.lines.size());
  for (std::size_t i = 0; i < lines_.size(); ++i) lines_[i].add(time, readings.lines[i]);
  propellers_.resize(readings.propellers.size());
  for (std::size_t i = 0; i < propellers_.size(); ++i) {
    const engine::PropellerReading& reading = readings.propellers[i];
    propellers_[i].power += 2 * std::numbers::pi * reading.speed * reading.torque;
    propellers_[i].thrust += reading.thrust;
  }
}

Json RigTotals::state() const {
  Json lines = Json::array(), propellers = Json::array();
  for (const Line& line : lines_) lines.push_back({line.most, line.at, or_null(line.broken)});
  for (const Propeller& propeller : propellers_)
    propellers.push_back({propeller.power, propeller.thrust});
  Json joints = Json::array();
  for (const Joint& j : joints_)
    joints.push_back({j.least, j.most, j.coordinate, j.latest, j.all.state(), j.of_damper.state(),
                      j.of_spring.state(), j.of_motor.state()});
  return {{"readings", readings_}, {"start", start_},          {"latest", latest_},
          {"lines", lines},        {"propellers", propellers}, {"joints", joints}};
}

void RigTotals::restore(const Json& state) {
  readings_ = state.at("readings").get<long>();
  lines_.clear();
  for (const Json& line : state.at("lines")) {
    lines_.push_back(
        {.most = line.at(0).get<double>(), .at = line.at(1).get<double>(), .broken = {}});
    if (!line.at(2).is_null()) lines_.back().broken = line.at(2).get<double>();
  }
  start_ = state.at("start").get<double>();
  latest_ = state.at("latest").get<double>();
  joints_.clear();
  for (const Json& joint : state.at("joints")) {
    Joint& j = joints_.emplace_back();
    j.least = joint.at(0).get<double>();
    j.most = joint.at(1).get<double>();
    j.coordinate = joint.at(2).get<double>();
    j.latest = joint.at(3).get<std::array<double, 4>>();
    std::size_t next = 4;
    for (Part* part : {&j.all, &j.of_damper, &j.of_spring, &j.of_motor})
      part->restore(joint.at(next++));
  }
  propellers_.clear();
  for (const Json& propeller : state.at("propellers"))
    propellers_.push_back({propeller.at(0).get<double>(), propeller.at(1).get<double>()});
}

Json RigTotals::lines(const engine::SimulationSpec& spec) const {
  Json all = Json::object();
  for (std::size_t i = 0; i < lines_.size(); ++i)
    all[log_name(spec.lines[i])] = {{"tension_max", lines_[i].most},
                                    {"at", lines_[i].at},
                                    {"broken_at", or_null(lines_[i].broken)}};
  return all;
}

Json RigTotals::joint(const engine::SimulationSpec& spec, std::size_t index) const {
  const engine::JointSpec& joint = spec.joints[index];
  if (!has_coordinate(joint) || index >= joints_.size()) return Json::object();
  const Joint& totals = joints_[index];
  Json json = {{"stroke", totals.most - totals.least}};
  const engine::JointDrive& drive = joint.drive;
  if (!(drive.damping > 0 || drive.stiffness > 0 || drive.motor)) return json;
  const double seconds = latest_ - start_;
  json.update(totals.all.json(seconds));
  if (drive.damping > 0) json["damper"] = totals.of_damper.json(seconds);
  if (drive.stiffness > 0) json["spring"] = totals.of_spring.json(seconds);
  if (drive.motor) json["motor"] = totals.of_motor.json(seconds);
  return json;
}

Json RigTotals::machines(const engine::SimulationSpec& spec) const {
  Json all = Json::object();
  const auto count = static_cast<double>(std::max(readings_, 1L));
  for (std::size_t i = 0; i < propellers_.size(); ++i)
    all[log_name(spec.propellers[i])] = {{"power_mean", propellers_[i].power / count},
                                         {"thrust_mean", propellers_[i].thrust / count}};
  return all;
}

}  // namespace app

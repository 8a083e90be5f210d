#include "app/logs/rig_log.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <utility>

namespace app {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kRadiansADegree = std::numbers::pi / 180;

/// The numbers of a table at a time, row after row.
class Numbers {
 public:
  Numbers& add(std::initializer_list<double> more) {
    for (const double number : more) all_.push_back(number == 0 ? 0 : number);  // no -0
    return *this;
  }
  Numbers& add(const Eigen::Vector3d& v) { return add({v.x(), v.y(), v.z()}); }
  std::vector<double> take() { return std::move(all_); }

 private:
  std::vector<double> all_;
};

void add_line(const engine::LineReading& r, bool rests, Numbers& numbers) {
  numbers.add({r.tension, r.distance, r.length, r.taut ? 1.0 : 0.0, r.broken ? 1.0 : 0.0})
      .add(r.first_W)
      .add(r.second_W)
      .add(r.force_W)
      .add({rests ? r.resting : kNone});
}

std::vector<double> lines_of(const engine::SimulationSpec& spec,
                             const engine::RigReadings& readings) {
  Numbers numbers;
  for (std::size_t i = 0; i < spec.lines.size(); ++i)
    add_line(readings.lines[i], spec.lines[i].kind == engine::LineSpec::Kind::mooring, numbers);
  return numbers.take();
}

std::vector<double> line_nodes_of(const engine::SimulationSpec& spec,
                                  const engine::RigReadings& readings) {
  Numbers numbers;
  for (std::size_t i = 0; i < spec.lines.size(); ++i) {
    const std::vector<Eigen::Vector3d>& nodes_W = readings.lines[i].nodes_W;
    for (std::size_t node = 0; node < node_count(spec.lines[i]); ++node)
      numbers.add(nodes_W.empty() ? Eigen::Vector3d::Constant(kNone) : nodes_W[node]);
  }
  return numbers.take();
}

std::vector<double> joints_of(const engine::SimulationSpec& spec,
                              const engine::RigReadings& readings) {
  Numbers numbers;
  for (std::size_t i = 0; i < spec.joints.size(); ++i) {
    const engine::JointReading& r = readings.joints[i];
    const bool moves = has_coordinate(spec.joints[i]);
    numbers.add({moves ? r.coordinate : kNone, moves ? r.speed : kNone})
        .add(r.force_W)
        .add(r.moment_W)
        .add({moves ? r.effort : kNone});
  }
  return numbers.take();
}

/// The thrust of a propeller on its body, in W.
Eigen::Vector3d thrust_W(const engine::PropellerSpec& propeller,
                         const engine::PropellerReading& reading, const hydro::BodyState& body) {
  const Eigen::Vector3d axis_B =
      Eigen::AngleAxisd(reading.azimuth, propeller.pivot_B) * propeller.axis_B;
  return reading.thrust * (body.orientation * axis_B);
}

std::vector<double> machines_of(const engine::SimulationSpec& spec,
                                const engine::RigReadings& readings,
                                const std::vector<hydro::BodyState>& states) {
  Numbers numbers;
  for (std::size_t i = 0; i < spec.propellers.size(); ++i) {
    const engine::PropellerReading& r = readings.propellers[i];
    const auto body = static_cast<std::size_t>(spec.propellers[i].body);
    numbers
        .add({r.speed, r.azimuth / kRadiansADegree, r.thrust, r.torque, r.advance, r.wetted, kNone,
              kNone})
        .add(thrust_W(spec.propellers[i], r, states[body]));
  }
  for (const engine::FoilReading& r : readings.foils)
    numbers
        .add({kNone, r.angle / kRadiansADegree, kNone, kNone, kNone, kNone,
              r.attack / kRadiansADegree, r.speed})
        .add(r.force_W);
  return numbers.take();
}

std::vector<double> controls_of(const engine::SimulationSpec& spec,
                                const engine::RigReadings& readings) {
  Numbers numbers;
  for (const engine::ControlSpec& control : spec.controls)
    numbers.add({readings.set_points[static_cast<std::size_t>(control.set)]});
  return numbers.take();
}

template <class Things>
std::vector<std::string> names_of(const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(log_name(thing));
  return names;
}

}  // namespace

bool has_coordinate(const engine::JointSpec& joint) {
  return joint.type == engine::JointSpec::Type::hinge ||
         joint.type == engine::JointSpec::Type::slider;
}

std::string log_name(const engine::LineSpec& line) {
  const char* kind = line.kind == engine::LineSpec::Kind::spring ? "springs"
                     : line.kind == engine::LineSpec::Kind::rope ? "ropes"
                                                                 : "moorings";
  return fmt::format("{}[{}]", kind, line.name);
}

std::string log_name(const engine::PropellerSpec& propeller) {
  return fmt::format("propellers[{}]", propeller.name);
}

std::string log_name(const engine::FoilSpec& foil) {
  const bool water = foil.fluid == engine::FoilSpec::Fluid::water;
  return fmt::format("{}[{}]", water ? "rudders" : "sails", foil.name);
}

std::size_t node_count(const engine::LineSpec& line) {
  return line.inertia ? static_cast<std::size_t>(line.inertia->segments) + 1 : 0;
}

std::string node_name(const engine::LineSpec& line, std::size_t node) {
  return fmt::format("{}.{}", log_name(line), node);
}

bool has_nodes(const engine::SimulationSpec& spec) {
  return std::ranges::any_of(spec.lines,
                             [](const engine::LineSpec& line) { return line.inertia.has_value(); });
}

RigLog::RigLog(const engine::SimulationSpec& spec, bool joints)
    : spec_(spec), joints_(joints && !spec.joints.empty()) {}

bool RigLog::empty() const {
  return spec_.lines.empty() && !joints_ && spec_.propellers.empty() && spec_.foils.empty() &&
         spec_.controls.empty();
}

std::vector<LogTable> RigLog::tables() const {
  std::vector<LogTable> tables;
  std::vector<std::string> lines = names_of(spec_.lines);
  if (!lines.empty()) tables.push_back({lines_layout(), std::move(lines)});
  if (has_nodes(spec_)) {
    tables.push_back({line_nodes_layout(), {}});
    for (const engine::LineSpec& line : spec_.lines)
      for (std::size_t node = 0; node < node_count(line); ++node)
        tables.back().names.push_back(node_name(line, node));
  }
  if (joints_) {
    tables.push_back({joints_layout(), {}});
    for (const engine::JointSpec& joint : spec_.joints) tables.back().names.push_back(joint.name);
  }
  std::vector<std::string> machines = names_of(spec_.propellers);
  for (std::string& foil : names_of(spec_.foils)) machines.push_back(std::move(foil));
  if (!machines.empty()) tables.push_back({machines_layout(), std::move(machines)});
  if (spec_.controls.empty()) return tables;
  tables.push_back({controls_layout(), {}});
  for (const engine::ControlSpec& control : spec_.controls)
    tables.back().names.push_back(spec_.set_points[static_cast<std::size_t>(control.set)].name);
  return tables;
}

std::vector<std::vector<double>> RigLog::numbers(
    const engine::RigReadings& readings, const std::vector<hydro::BodyState>& states) const {
  std::vector<std::vector<double>> all;
  if (!spec_.lines.empty()) all.push_back(lines_of(spec_, readings));
  if (has_nodes(spec_)) all.push_back(line_nodes_of(spec_, readings));
  if (joints_) all.push_back(joints_of(spec_, readings));
  if (!spec_.propellers.empty() || !spec_.foils.empty())
    all.push_back(machines_of(spec_, readings, states));
  if (!spec_.controls.empty()) all.push_back(controls_of(spec_, readings));
  return all;
}

}  // namespace app

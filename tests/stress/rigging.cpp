#include "tests/stress/rigging.h"

#include <fmt/format.h>

#include <algorithm>

namespace stress {
namespace {

using Eigen::Vector3d;
using engine::LineSpec;

/// The force that a body exerts by weight and buoyancy, which stiffnesses are multiples of [N].
double load(const Scenario& scenario) {
  return scenario.spec.bodies[0].mass * scenario.spec.gravity;
}

/// The vertex of a body that is farthest in a direction.
Vector3d corner(const engine::BodySpec& body, const Vector3d& direction_B) {
  Eigen::Index farthest = 0;
  (direction_B.transpose() * body.mesh_B.vertices).maxCoeff(&farthest);
  return body.mesh_B.vertices.col(farthest);
}

/// Place of a body's point in W.
Vector3d place(const engine::BodySpec& body, const Vector3d& at_B) {
  return body.initial.position + body.initial.orientation * at_B;
}

void add_line(LineSpec::Kind kind, double stiffness, Scenario& scenario) {
  const Vector3d at_B = corner(scenario.spec.bodies[0], {0.5, 0.3, 0.8});
  const Vector3d opposite_B = corner(scenario.spec.bodies[0], {-0.5, -0.3, -0.8});
  const bool between = scenario.spec.bodies.size() > 1;
  engine::AttachmentPoint second{.body = 1, .at = opposite_B};
  const Vector3d end = place(scenario.spec.bodies[0], at_B);
  if (!between) second = {engine::kWorld, end + scenario.size * Vector3d(1.2, -0.5, 1)};
  const Vector3d other = between ? place(scenario.spec.bodies[1], opposite_B) : second.at;
  scenario.spec.lines.push_back({.name = "line",
                                 .kind = kind,
                                 .first = {0, at_B},
                                 .second = second,
                                 .length = (other - end).norm(),
                                 .stiffness = stiffness * load(scenario) / scenario.size});
}

void moor(Scenario& scenario) {
  const double size = scenario.size;
  const Vector3d at_B = corner(scenario.spec.bodies[0], {0.1, 0, -1});
  const Vector3d end = place(scenario.spec.bodies[0], at_B);
  const Vector3d anchor = end + size * Vector3d(4, 1, -5);
  const double length = 1.02 * (anchor - end).norm();
  scenario.spec.lines.push_back({.name = "mooring",
                                 .kind = LineSpec::Kind::mooring,
                                 .first = {0, at_B},
                                 .second = {engine::kWorld, anchor},
                                 .length = length,
                                 .stiffness = 1e3 * load(scenario),
                                 .weight = 0.2 * load(scenario) / length});
}

/// A motor that turns a hinged body at 2 rad/s as far as stops allow, against friction.
void drive(Scenario& scenario) {
  scenario.spec.set_points.push_back({.name = "speed", .initial = 2});
  engine::JointDrive& drive = scenario.spec.joints[0].drive;
  const double torque = load(scenario) * scenario.size;
  drive.motor = {.mode = engine::JointMotor::Mode::speed, .set_point = 0, .largest_effort = torque};
  drive.limits = {{-0.8, 1.1}};
  drive.friction = 0.1 * torque;
}

}  // namespace

bool is_rigged(const std::string& with) {
  return std::find(rigged().begin(), rigged().end(), with) != rigged().end();
}

const std::vector<std::string>& rigged() {
  static const std::vector<std::string> names = {"rope", "leash", "spring", "moored", "driven"};
  return names;
}

void rig(const std::string& with, Scenario& scenario) {
  if (with == "rope") return add_line(LineSpec::Kind::rope, 1e4, scenario);
  if (with == "leash") return add_line(LineSpec::Kind::rope, 1e5, scenario);
  if (with == "spring") return add_line(LineSpec::Kind::spring, 30, scenario);
  if (with == "moored") return moor(scenario);
  if (with == "driven") return drive(scenario);
}

bool gives_energy(const std::string& with) { return with == "moored" || with == "driven"; }

double stretch_energy(const engine::SimulationSpec& spec,
                      const std::vector<engine::Motion>& motions) {
  double energy = 0;
  for (const LineSpec& line : spec.lines) {
    if (line.kind == LineSpec::Kind::mooring) continue;
    const auto end = [&](const engine::AttachmentPoint& point) -> Vector3d {
      if (point.body == engine::kWorld) return point.at;
      const hydro::BodyState& state = motions[point.body].state;
      return state.position + state.orientation * point.at;
    };
    const Vector3d way = end(line.first) - end(line.second);
    const double stretch = way.norm() - line.length;
    if (line.kind == LineSpec::Kind::rope && stretch < 0) continue;
    energy += line.stiffness * stretch * stretch / 2;
  }
  return energy;
}

}  // namespace stress

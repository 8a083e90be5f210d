#include "engine/rig/dynamic_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/base/constants.h"
#include "engine/constraints/force_row.h"
#include "engine/constraints/island.h"
#include "engine/motion/locks.h"
#include "engine/rig/line_pull.h"
#include "hydro/decompositions.h"

namespace engine {
namespace {

using Eigen::Vector3d;

hydro::LumpedLine lumped(const LineSpec& spec, double gravity) {
  const LineInertia& inertia = *spec.inertia;
  const bool rope = spec.kind == LineSpec::Kind::rope;
  return {.segments = inertia.segments,
          .stiffness = rope ? spec.stiffness * spec.length : spec.stiffness,
          .damping = rope ? spec.damping * inertia.segments : 0,
          .mass = inertia.mass,
          .weight = spec.weight,
          .diameter = spec.drag_diameter,
          .drag_across = spec.drag_coefficient,
          .drag_along = inertia.drag_along,
          .added_mass = inertia.added_mass,
          .friction = spec.friction,
          .gravity = gravity,
          .bottom = inertia.bottom};
}

bool moves(const SimulationSpec& spec, BodyId body) {
  return body != kWorld && !immovable(spec.bodies[static_cast<std::size_t>(body)].locked);
}

/// The largest reciprocal mass of a point of a body, without water; 0 for one that does not move.
double mobility(const SimulationSpec& spec, const AttachmentPoint& point) {
  if (!moves(spec, point.body)) return 0;
  const BodySpec& body = spec.bodies[static_cast<std::size_t>(point.body)];
  return 1 / body.mass + point.at.squaredNorm() / hydro::eigenvalues(body.inertia_B)[0];
}

/// Of the bodies at the ends of a line, in the most mobile direction, on the line as a spring
/// [1/s].
double taut_frequency(const SimulationSpec& spec, const LineSpec& line) {
  const double k = lumped(line, spec.gravity).stiffness / line.length;
  return std::sqrt(k * (mobility(spec, line.first) + mobility(spec, line.second)));
}

}  // namespace

double longest_step(const SimulationSpec& spec, const LineSpec& line) {
  const bool between = moves(spec, line.first.body) && moves(spec, line.second.body);
  return line.inertia && between ? kMostLinePhase / taut_frequency(spec, line)
                                 : std::numeric_limits<double>::infinity();
}

Vector3d DynamicLines::Line::force(int end) const {
  return broken ? Vector3d(Vector3d::Zero()) : Vector3d(motion.forces.col(end));
}

const AttachmentPoint& DynamicLines::point(const Line& line, int side) const {
  const LineSpec& spec = spec_->lines[line.index];
  return side == 0 ? spec.first : spec.second;
}

hydro::LineEnds DynamicLines::places(const Line& line,
                                     const std::vector<hydro::BodyState>& states) const {
  hydro::LineEnds ends;
  for (int side = 0; side < 2; ++side) ends.col(side) = line_end(point(line, side), states).place_W;
  return ends;
}

DynamicLines::DynamicLines(const SimulationSpec& spec)
    : spec_(&spec),
      sea_(spec.sea ? &*spec.sea : nullptr),
      place_(spec.lines.size(), -1),
      ends_of_(spec.bodies.size()),
      step_(spec.step) {
  std::vector<hydro::BodyState> states;
  for (const BodySpec& body : spec.bodies) states.push_back(body.initial);
  for (std::size_t i = 0; i < spec.lines.size(); ++i) {
    const LineSpec& given = spec.lines[i];
    if (!given.inertia) continue;
    place_[i] = static_cast<int>(lines_.size());
    Line line{.index = i,
              .line = lumped(given, spec.gravity),
              .between = moves(spec, given.first.body) && moves(spec, given.second.body)};
    if (spec.step > longest_step(spec, given))
      throw std::invalid_argument(
          fmt::format("line '{}': the step is {:g} s, expected at most {:.3g} s for a line of its "
                      "stiffness with inertia between two bodies",
                      given.name, spec.step, longest_step(spec, given)));
    line.unresolved = unresolved(spec.step * taut_frequency(spec, given));
    settle(line, given.length, states);
    for (int side = 0; side < 2; ++side) {
      const BodyId body = point(line, side).body;
      if (body != kWorld) ends_of_[static_cast<std::size_t>(body)].push_back({lines_.size(), side});
    }
    lines_.push_back(std::move(line));
  }
}

void DynamicLines::settle(Line& line, double length, const std::vector<hydro::BodyState>& states) {
  hydro::LumpedState& motion = line.motion;
  motion = hydro::line_at_rest(line.line, length, places(line, states), sea_);
  for (int side = 0; side < 2; ++side) {  // The ends have moved with their bodies before.
    const Vector3d velocity = line_end(point(line, side), states).velocity_W;
    const Eigen::Index node = side == 0 ? 0 : line.line.segments;
    motion.places_before.col(node) -= step_ * velocity;
    motion.velocities.col(node) = motion.velocities_before.col(node) = velocity;
  }
}

void DynamicLines::settle(BodyId body, const std::vector<hydro::BodyState>& states, double time,
                          const LengthAt& length_at) {
  for (const auto& [index, side] : ends_of_[static_cast<std::size_t>(body)])
    settle(lines_[index], length_at(lines_[index].index, time), states);
}

void DynamicLines::begin_step(const std::vector<hydro::BodyState>& states, double time, double h,
                              const LengthAt& length_at) {
  step_start_ = time;
  step_ = h;
  for (Line& line : lines_) {
    if (line.broken) continue;
    line.aimed = places(line, states);
    for (int side = 0; side < 2; ++side)
      line.aimed.col(side) += h * line_end(point(line, side), states).velocity_W;
    line.step.begin(line.line, length_at(line.index, time + h), line.aimed, sea_, time + h, h,
                    line.motion);
  }
}

void DynamicLines::add_update(double time, double h, SubstepBody& body) const {
  const hydro::BodyState& state = body.halfway.state;
  const double part = (time - step_start_) / step_, rest = step_start_ + step_ - time;
  for (const auto& [index, side] : ends_of_[static_cast<std::size_t>(body.id)]) {
    const Line& line = lines_[index];
    if (line.broken) continue;
    const Vector3d r = state.orientation * point(line, side).at;
    const Vector3d velocity = state.linear_velocity + state.angular_velocity.cross(r);
    const Vector3d off = state.position + r + rest * velocity - line.aimed.col(side);
    const auto k = static_cast<std::size_t>(side);
    const Vector3d now = line.force(side);
    const double theta = part + line.unresolved * (1 - part);
    const Vector3d force = now + theta * (line.step.response().forces.col(side) - now -
                                          line.step.response().stiffness[k] * off);
    body.moving->rig_load.force += force;
    body.moving->rig_load.moment += r.cross(force);
    if (!body.rig_inertia) body.rig_inertia = Matrix6d::Zero();
    Eigen::Matrix<double, 3, 6> J;
    J << Eigen::Matrix3d::Identity(), -cross_matrix(r);
    const double weight = (line.between ? 2 : 1) * theta * rest * h;
    *body.rig_inertia += weight * J.transpose() * line.step.response().stiffness[k] * J;
  }
}

void DynamicLines::follow(const std::vector<hydro::BodyState>& states) {
  for (Line& line : lines_)
    if (!line.broken) line.step.end(places(line, states), line.motion);
}

void DynamicLines::add_load(BodyId body, const hydro::BodyState& state, hydro::Wrench& load) const {
  for (const auto& [index, side] : ends_of_[static_cast<std::size_t>(body)]) {
    const Vector3d force = lines_[index].force(side);
    load.force += force;
    load.moment += (state.orientation * point(lines_[index], side).at).cross(force);
  }
}

double DynamicLines::tension(std::size_t line) const {
  return std::max(of(line).force(0).norm(), of(line).force(1).norm());
}

std::vector<Vector3d> DynamicLines::nodes(std::size_t line) const {
  std::vector<Vector3d> nodes;
  if (of(line).broken) return nodes;
  for (const auto node : of(line).motion.places.colwise()) nodes.emplace_back(node);
  return nodes;
}

double DynamicLines::resting(std::size_t line, double length) const {
  return hydro::resting_length(of(line).line, length, of(line).motion);
}

std::vector<hydro::LumpedState> DynamicLines::state() const {
  std::vector<hydro::LumpedState> states;
  for (const Line& line : lines_) states.push_back(line.motion);
  return states;
}

bool DynamicLines::fits(const std::vector<hydro::LumpedState>& state) const {
  return std::ranges::equal(state, lines_, [](const hydro::LumpedState& m, const Line& line) {
    const Eigen::Index count = line.motion.places.cols();
    return m.places.cols() == count && m.places_before.cols() == count &&
           m.velocities.cols() == count && m.velocities_before.cols() == count;
  });
}

void DynamicLines::restore(const std::vector<hydro::LumpedState>& state) {
  for (std::size_t i = 0; i < lines_.size(); ++i) lines_[i].motion = state[i];
}

}  // namespace engine

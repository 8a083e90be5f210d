#include "engine/rig/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/base/constants.h"
#include "engine/motion/locks.h"
#include "hydro/decompositions.h"

namespace engine {
namespace {

using Eigen::Vector3d;

void check_points(const SimulationSpec& spec) {
  const auto known = [&](BodyId body) {
    return body >= kWorld && body < static_cast<BodyId>(spec.bodies.size());
  };
  for (const LineSpec& line : spec.lines) {
    if (!known(line.first.body) || !known(line.second.body))
      throw std::invalid_argument(fmt::format("line '{}': it ends at no body", line.name));
    if (line.first.body == kWorld && line.second.body == kWorld)
      throw std::invalid_argument(fmt::format("line '{}': both its ends are fixed", line.name));
    if (!(line.length >= 0) || !(line.stiffness >= 0) || !(line.damping >= 0))
      throw std::invalid_argument(
          fmt::format("line '{}': its length is {} m, its stiffness {}, its damping {}; none may "
                      "be negative",
                      line.name, line.length, line.stiffness, line.damping));
  }
  const bool rigged = !spec.lines.empty() || !spec.propellers.empty() || !spec.foils.empty();
  if (rigged && spec.integrator.method == Integrator::Method::ode)
    throw std::invalid_argument("the method ode knows no lines and machines");
}

}  // namespace

Rig::Rig(const SimulationSpec& spec)
    : spec_(&spec),
      set_points_(std::make_unique<SetPoints>(spec)),
      lines_(spec.lines.size()),
      joints_(spec.joints.size()),
      turns_(spec.propellers.size(), 0),
      is_row_(spec.lines.size(), false),
      parts_(spec.bodies.size()),
      acts_on_(spec.bodies.size(), false),
      constrains_(spec.bodies.size(), false) {
  check_points(spec);
  for (const BodySpec& body : spec.bodies)
    least_inertia_.push_back(hydro::eigenvalues(body.inertia_B)[0]);
  machines_ = std::make_unique<Machines>(spec, *set_points_);
  dynamic_ = std::make_unique<DynamicLines>(spec);
  if (spec.sea) sea_ = &*spec.sea;
  const std::vector<double> stiffness = stiffness_of_bodies();
  for (std::size_t i = 0; i < spec.lines.size(); ++i) {
    lines_[i].length = spec.lines[i].length;
    sort_line(i, stiffness);
  }
  for (std::size_t i = 0; i < spec.joints.size(); ++i) sort_joint(i, stiffness);
  for (std::size_t i = 0; i < spec.bodies.size(); ++i)
    if (machines_->drives(static_cast<BodyId>(i))) acts_on_[i] = true;
  for (std::size_t i = 0; i < spec.bodies.size(); ++i)
    if (dynamic_->acts_on(static_cast<BodyId>(i)) && movable(static_cast<BodyId>(i)))
      acts_on_[i] = true;
  std::sort(couplings_.begin(), couplings_.end());
  couplings_.erase(std::unique(couplings_.begin(), couplings_.end()), couplings_.end());
}

bool Rig::empty() const {
  return spec_->lines.empty() && spec_->set_points.empty() && spec_->propellers.empty() &&
         spec_->foils.empty() && spec_->joints.empty();
}

bool Rig::movable(BodyId body) const {
  return body != kWorld && !immovable(spec_->bodies[body].locked);
}

BodyId Rig::first_movable(BodyId first, BodyId second) const {
  if (!movable(first)) return movable(second) ? second : kWorld;
  return movable(second) ? std::min(first, second) : first;
}

/// The largest reciprocal mass of a point of a body: that along the most mobile direction.
double Rig::mobility(BodyId body, const Vector3d& r_B) const {
  if (!movable(body)) return 0;
  return 1 / spec_->bodies[body].mass + r_B.squaredNorm() / least_inertia_[body];
}

std::vector<double> Rig::stiffness_of_bodies() const {
  std::vector<double> sums(spec_->bodies.size(), 0);
  const double h = spec_->step;
  const auto add = [&](BodyId body, double mobility, double k, double c) {
    if (movable(body)) sums[body] += (h * h * k + 2 * h * c) * mobility;
  };
  for (const LineSpec& line : spec_->lines) {
    if (line.kind == LineSpec::Kind::mooring || line.inertia) continue;
    const bool between = movable(line.first.body) && movable(line.second.body);
    if (line.kind == LineSpec::Kind::spring && !between) continue;
    for (const AttachmentPoint& end : {line.first, line.second})
      add(end.body, mobility(end.body, end.at), line.stiffness, line.damping);
  }
  for (const JointSpec& joint : spec_->joints)
    for (const BodyId body : {joint.first, joint.second}) {
      if (!movable(body)) continue;
      const double all = mobility(body, Vector3d::UnitX());
      const double turning = all - 1 / spec_->bodies[body].mass;
      add(body, joint.type == JointSpec::Type::hinge ? turning : all, joint.drive.stiffness,
          joint.drive.damping);
    }
  return sums;
}

void Rig::couple(BodyId first, BodyId second, bool by_row) {
  for (const BodyId body : {first, second}) {
    if (!movable(body)) continue;
    acts_on_[body] = true;
    if (by_row) constrains_[body] = true;
  }
  if (by_row || (movable(first) && movable(second)))
    couplings_.push_back(std::minmax(first, second));
}

void Rig::sort_line(std::size_t index, const std::vector<double>& stiffness) {
  const LineSpec& line = spec_->lines[index];
  if (line.inertia) return;
  const BodyId a = line.first.body, b = line.second.body;
  const BodyId owner = first_movable(a, b);
  if (owner == kWorld) return;
  const bool between = movable(a) && movable(b);
  const auto stiff = [&](BodyId body) { return movable(body) && stiffness[body] > kStiffLine; };
  const bool may_be_row =
      line.kind == LineSpec::Kind::rope || (line.kind == LineSpec::Kind::spring && between);
  is_row_[index] = may_be_row && (stiff(a) || stiff(b));
  Parts& parts = parts_[owner];
  (is_row_[index] ? parts.rows : between ? parts.lines : parts.to_world).push_back(index);
  couple(a, b, is_row_[index]);
}

void Rig::sort_joint(std::size_t index, const std::vector<double>& stiffness) {
  const JointSpec& joint = spec_->joints[index];
  const BodyId owner = first_movable(joint.first, joint.second);
  const auto start = [&](BodyId body) {
    return body == kWorld ? nullptr : &spec_->bodies[body].initial;
  };
  const bool stiff = std::ranges::any_of(std::array{joint.first, joint.second}, [&](BodyId body) {
    return movable(body) && stiffness[body] > kStiffLine;
  });
  const bool has_coordinate =
      joint.type == JointSpec::Type::hinge || joint.type == JointSpec::Type::slider;
  const bool sprung = joint.drive.stiffness > 0 || joint.drive.damping > 0;
  drives_.push_back(
      {.coordinate = JointCoordinate(joint, {start(joint.first), start(joint.second)}),
       .has_coordinate = has_coordinate,
       .stiff = stiff,
       .rows = needs_rows(joint.drive, stiff && sprung)});
  if (!has_coordinate || owner == kWorld || !joint.drive.acts()) return;
  parts_[owner].drives.push_back(index);
  couple(joint.first, joint.second, drives_[index].rows);
}

LineLength Rig::length_at(std::size_t index, double time) const {
  const LineSpec& line = spec_->lines[index];
  const auto wound = [&](double length, double rate) {
    return length > line.shortest ? LineLength{length, rate} : LineLength{line.shortest, 0};
  };
  if (line.set_length)
    return wound(set_points_->value(*line.set_length, time),
                 set_points_->rate(*line.set_length, time));
  if (!line.set_rate) return {.length = lines_[index].length};
  const double mean = set_points_->value(*line.set_rate, (step_start_ + time) / 2);
  return wound(lines_[index].length + (time - step_start_) * mean,
               set_points_->value(*line.set_rate, time));
}

DynamicLines::LengthAt Rig::lengths() const {
  return [this](std::size_t line, double time) { return length_at(line, time).length; };
}

void Rig::begin_step(const std::vector<hydro::BodyState>& states, double time, double h) {
  const auto measured = [&](const Measurement& of) { return measure(of, states, time, h); };
  step_start_ = time;
  set_points_->begin_step(time, h, measured);
  for (LineState& line : lines_) {
    line.tension = line.impulse / h;
    line.impulse = 0;
  }
  for (JointState& joint : joints_) joint = {};
  if (!dynamic_->empty()) dynamic_->begin_step(states, time, h, lengths());
}

void Rig::follow(const std::vector<hydro::BodyState>& states) { dynamic_->follow(states); }

std::vector<std::size_t> Rig::end_step(const std::vector<hydro::BodyState>& states, double time,
                                       double h) {
  std::vector<std::size_t> broken;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const LineSpec& line = spec_->lines[i];
    const LineLength length = length_at(i, time + h);
    if (!lines_[i].broken && std::isfinite(line.breaks_at) &&
        tension_now(i, pull_now(i, states, time + h), h) > line.breaks_at) {
      lines_[i].broken = true;
      if (dynamic_->has(i)) dynamic_->set_broken(i, true);
      broken.push_back(i);
    }
    lines_[i].length = length.length;
  }
  for (std::size_t i = 0; i < turns_.size(); ++i)
    turns_[i] +=
        2 * std::numbers::pi * h * set_points_->value(spec_->propellers[i].speed, time + h / 2);
  step_start_ = time + h;
  return broken;
}

RigState Rig::state() const {
  return {.lines = lines_,
          .joints = joints_,
          .turns = turns_,
          .set_points = set_points_->states(),
          .dynamic_lines = dynamic_->state()};
}

bool Rig::fits(const RigState& state) const {
  return state.lines.size() == lines_.size() && state.joints.size() == joints_.size() &&
         state.turns.size() == turns_.size() &&
         state.set_points.size() == set_points_->states().size() &&
         dynamic_->fits(state.dynamic_lines);
}

void Rig::restore(const RigState& state, double time, double h) {
  lines_ = state.lines;
  joints_ = state.joints;
  turns_ = state.turns;
  set_points_->restore(state.set_points);
  set_points_->set_time(time - h, h);
  dynamic_->restore(state.dynamic_lines);
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (dynamic_->has(i)) dynamic_->set_broken(i, lines_[i].broken);
  step_start_ = time;
}

}  // namespace engine

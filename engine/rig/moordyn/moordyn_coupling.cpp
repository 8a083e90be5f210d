#include "engine/rig/moordyn/moordyn_coupling.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/constants.h"
#include "engine/base/spec.h"
#include "engine/constraints/island.h"
#include "engine/motion/locks.h"

namespace engine {
namespace {

using Eigen::Vector3d;

std::vector<hydro::BodyState> initial_states(const SimulationSpec& spec) {
  std::vector<hydro::BodyState> states;
  for (const BodySpec& body : spec.bodies) states.push_back(body.initial);
  return states;
}

}  // namespace

MoorDynCoupling::MoorDynCoupling(const SimulationSpec& spec)
    : simulation_(&spec),
      spec_(&*spec.moordyn),
      system_(spec_->file, spec_->text,
              {.gravity = spec.gravity, .sea = spec.sea ? &*spec.sea : nullptr}),
      step_(spec.step) {
  if (spec_->points.size() != system_.coupled_points().size() ||
      spec_->lines.size() != system_.lines().size())
    throw MoorDynFault(
        fmt::format("the file has {} coupled points and {} lines, the specification {} and {}",
                    system_.coupled_points().size(), system_.lines().size(), spec_->points.size(),
                    spec_->lines.size()));
  for (const AttachmentPoint& point : spec_->points)
    if (point.body < 0 || point.body >= static_cast<BodyId>(spec.bodies.size()))
      throw MoorDynFault("a coupled point is on no body");
  motions_ = motions(initial_states(spec));
  std::vector<Vector3d> places;
  for (const PointMotion& motion : motions_) places.push_back(motion.place);
  system_.start(places);
  forces_ = before_ = system_.forces();
  holds_ = system_.holds();
  motions_before_ = motions_;
  for (PointMotion& motion : motions_before_) motion.place -= step_ * motion.velocity;
}

bool MoorDynCoupling::acts_on(BodyId body) const {
  return std::ranges::any_of(spec_->points,
                             [body](const AttachmentPoint& point) { return point.body == body; });
}

void MoorDynCoupling::add_load(BodyId body, const hydro::BodyState& state, double time,
                               hydro::Wrench& load) const {
  const double fraction = (time - step_start_) / step_;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (spec_->points[i].body != body) continue;
    const Vector3d force = forces_[i] + fraction * (forces_[i] - before_[i]);
    load.force += force;
    load.moment += (state.orientation * spec_->points[i].at).cross(force);
  }
}

Vector3d MoorDynCoupling::direction(std::size_t point) const {
  const double size = forces_[point].norm();
  return size > 0 ? Vector3d(forces_[point] / size) : Vector3d(Vector3d::Zero());
}

void MoorDynCoupling::add_update(double time, double h, SubstepBody& body) const {
  add_load(body.id, body.halfway.state, time, body.moving->rig_load);
  const hydro::BodyState& state = body.halfway.state;
  const BodySpec& spec = simulation_->bodies[static_cast<std::size_t>(body.id)];
  if (immovable(spec.locked)) return;
  // Each point of the body with its Jacobian along its line, and the sum of their h² K + 2 h C over
  // the mass.
  std::vector<std::pair<std::size_t, Vector6d>> resisting;
  double stiffness = 0;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (spec_->points[i].body != body.id) continue;
    const Vector3d n = direction(i), arm = (state.orientation * spec_->points[i].at).cross(n);
    const Vector3d arm_B = state.orientation.conjugate() * arm;
    const double mobility =
        n.squaredNorm() / spec.mass + arm_B.dot(spec.inertia_B.ldlt().solve(arm_B));
    stiffness += (h * h * holds_[i].stiffness + 2 * h * holds_[i].damping) * mobility;
    resisting.emplace_back(i, to_vector6(n, arm));
  }
  if (stiffness < kHeavyLine) return;
  if (!body.rig_inertia) body.rig_inertia = Matrix6d::Zero();
  const double fraction = (time - step_start_) / step_;
  const auto expected = [fraction](const Vector3d& now, const Vector3d& before) -> Vector3d {
    return now + fraction * (now - before);
  };
  for (const auto& [i, J] : resisting) {
    const Vector3d n = J.head<3>(), r = state.orientation * spec_->points[i].at;
    const Vector3d velocity = state.linear_velocity + state.angular_velocity.cross(r);
    const PointMotion &now = motions_[i], &before = motions_before_[i];
    const auto& [K, C] = holds_[i];
    const double push = K * n.dot(expected(now.place, before.place) - state.position - r) +
                        C * n.dot(expected(now.velocity, before.velocity) - velocity);
    body.moving->rig_load += to_wrench(push * J);
    *body.rig_inertia += (h * h / 4 * K + h / 2 * C) * J * J.transpose();
  }
}

void MoorDynCoupling::begin_step(const std::vector<hydro::BodyState>& states, double time,
                                 double h) {
  motions_ = motions(states);
  step_start_ = time;
  step_ = h;
}

void MoorDynCoupling::follow(const std::vector<hydro::BodyState>& states) {
  std::vector<PointMotion> to = motions(states);
  system_.step(motions_, to, step_start_, step_);
  before_ = std::move(forces_);
  forces_ = system_.forces();
  motions_before_ = std::move(motions_);
  motions_ = std::move(to);
  step_start_ += step_;
}

MoorDynState MoorDynCoupling::state() const {
  MoorDynState state{.forces = forces_, .before = before_, .system = system_.save()};
  for (const PointMotion& motion : motions_before_) {
    state.places_before.push_back(motion.place);
    state.velocities_before.push_back(motion.velocity);
  }
  return state;
}

bool MoorDynCoupling::fits(const MoorDynState& state) const {
  return state.forces.size() == forces_.size() && state.before.size() == before_.size() &&
         state.places_before.size() == before_.size() &&
         state.velocities_before.size() == before_.size() &&
         state.system.size() == system_.save().size();
}

void MoorDynCoupling::restore(const MoorDynState& state, double time, double h) {
  forces_ = state.forces;
  before_ = state.before;
  for (std::size_t i = 0; i < motions_before_.size(); ++i)
    motions_before_[i] = {.place = state.places_before[i], .velocity = state.velocities_before[i]};
  system_.load(state.system);
  step_start_ = time;
  step_ = h;
}

std::vector<PointMotion> MoorDynCoupling::motions(
    const std::vector<hydro::BodyState>& states) const {
  std::vector<PointMotion> motions;
  for (const AttachmentPoint& point : spec_->points) {
    const hydro::BodyState& state = states[static_cast<std::size_t>(point.body)];
    const Vector3d r = state.orientation * point.at;
    motions.push_back({.place = state.position + r,
                       .velocity = state.linear_velocity + state.angular_velocity.cross(r)});
  }
  return motions;
}

}  // namespace engine

#include "engine/moordyn_coupling.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/constants.h"
#include "engine/spec.h"
#include "engine/substep.h"

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
    : spec_(&*spec.moordyn),
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
  impedances_ = system_.impedances();
  for (const PointMotion& motion : motions_) velocities_before_.push_back(motion.velocity);
}

bool MoorDynCoupling::acts_on(BodyId body) const {
  return std::ranges::any_of(spec_->points,
                             [body](const AttachmentPoint& point) { return point.body == body; });
}

void MoorDynCoupling::add_load(BodyId body, const hydro::BodyState& state, double time,
                               hydro::Wrench& load) const {
  const double part = (time - step_start_) / step_;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (spec_->points[i].body != body) continue;
    const Vector3d force = forces_[i] + part * (forces_[i] - before_[i]);
    load.force += force;
    load.moment += (state.orientation * spec_->points[i].at).cross(force);
  }
}

void MoorDynCoupling::add_update(double time, double h, const std::vector<double>& mobility,
                                 SubstepBody& body) const {
  add_load(body.id, body.halfway.state, time, body.moving->rig_load);
  double stiffness = 0;
  for (std::size_t i = 0; i < forces_.size(); ++i)
    if (spec_->points[i].body == body.id) stiffness += 2 * h * impedances_[i] * mobility[i];
  if (stiffness < kStiffLine) return;
  if (!body.rig_inertia) body.rig_inertia = Matrix6d::Zero();
  const hydro::BodyState& state = body.halfway.state;
  const double part = (time - step_start_) / step_;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (spec_->points[i].body != body.id) continue;
    const Vector3d r = state.orientation * spec_->points[i].at;
    const Vector3d& known = motions_[i].velocity;
    const Vector3d expected = known + part * (known - velocities_before_[i]);
    const Vector3d velocity = state.linear_velocity + state.angular_velocity.cross(r);
    const Vector3d force = impedances_[i] * (expected - velocity);
    body.moving->rig_load.force += force;
    body.moving->rig_load.moment += r.cross(force);
    Eigen::Matrix<double, 3, 6> J;
    J << Eigen::Matrix3d::Identity(), -cross_matrix(r);
    *body.rig_inertia += h / 2 * impedances_[i] * J.transpose() * J;
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
  for (std::size_t i = 0; i < to.size(); ++i) velocities_before_[i] = motions_[i].velocity;
  motions_ = std::move(to);
  step_start_ += step_;
}

MoorDynState MoorDynCoupling::state() const {
  return {.forces = forces_,
          .before = before_,
          .velocities_before = velocities_before_,
          .system = system_.save()};
}

bool MoorDynCoupling::fits(const MoorDynState& state) const {
  return state.forces.size() == forces_.size() && state.before.size() == before_.size() &&
         state.velocities_before.size() == before_.size() &&
         state.system.size() == system_.save().size();
}

void MoorDynCoupling::restore(const MoorDynState& state, double time, double h) {
  forces_ = state.forces;
  before_ = state.before;
  velocities_before_ = state.velocities_before;
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

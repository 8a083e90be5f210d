#include "engine/moordyn_coupling.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/spec.h"

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
  places_ = places(initial_states(spec));
  system_.start(places_);
  forces_ = before_ = system_.forces();
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

void MoorDynCoupling::begin_step(const std::vector<hydro::BodyState>& states, double time,
                                 double h) {
  places_ = places(states);
  step_start_ = time;
  step_ = h;
}

void MoorDynCoupling::follow(const std::vector<hydro::BodyState>& states) {
  std::vector<Vector3d> to = places(states);
  system_.step(places_, to, step_start_, step_);
  before_ = std::move(forces_);
  forces_ = system_.forces();
  places_ = std::move(to);
  step_start_ += step_;
}

MoorDynState MoorDynCoupling::state() const {
  return {.forces = forces_, .before = before_, .system = system_.save()};
}

bool MoorDynCoupling::fits(const MoorDynState& state) const {
  return state.forces.size() == forces_.size() && state.before.size() == before_.size() &&
         state.system.size() == system_.save().size();
}

void MoorDynCoupling::restore(const MoorDynState& state, double time, double h) {
  forces_ = state.forces;
  before_ = state.before;
  system_.load(state.system);
  step_start_ = time;
  step_ = h;
}

std::vector<Vector3d> MoorDynCoupling::places(const std::vector<hydro::BodyState>& states) const {
  std::vector<Vector3d> places;
  for (const AttachmentPoint& point : spec_->points) {
    const hydro::BodyState& state = states[static_cast<std::size_t>(point.body)];
    places.push_back(state.position + state.orientation * point.at);
  }
  return places;
}

}  // namespace engine

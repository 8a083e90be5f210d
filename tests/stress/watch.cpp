#include "tests/stress/watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/state_checks.h"
#include "engine/motion/energy.h"
#include "engine/state_data.h"
#include "tests/stress/rigging.h"
#include "tests/stress/waters.h"

namespace stress {
namespace {

std::vector<engine::Motion> motions_of(const engine::Simulation& simulation) {
  const engine::SimulationState state = simulation.state();
  std::vector<engine::Motion> motions;
  for (const auto& body : state.data().bodies) motions.push_back(body.motion);
  return motions;
}

double kinetic_energy(const engine::Body& body, const engine::Motion& motion) {
  return engine::kinetic_energy(body, motion, body.current());
}

/// The motion with the added mass of its pose.
engine::Motion at_its_pose(const engine::Body& body, engine::Motion motion) {
  motion.added_B = engine::added_mass(body, motion.state, motion.carried_water.get(), 0);
  return motion;
}

}  // namespace

Watch::Watch(const Scenario& scenario)
    : scenario_(scenario), world_(scenario.spec.gravity), counts_(scenario.spec.bodies.size()) {
  for (const engine::BodySpec& body : scenario_.spec.bodies) world_.add_body(body);
  for (const engine::JointSpec& joint : scenario_.spec.joints) world_.add_joint(joint);
  world_.add_ground(scenario_.spec.ground);
  environment_ = engine::make_environment(scenario_.spec);
  bodies_ = engine::make_bodies(scenario_.spec);
  std::vector<engine::Motion> motions;
  for (std::size_t i = 0; i < scenario_.spec.bodies.size(); ++i) {
    motions.push_back(
        engine::motion_at(bodies_[i], scenario_.spec, scenario_.spec.bodies[i].initial, 0));
    initial_energies_.push_back(kinetic_energy(bodies_[i], motions.back()));
    weight_ += (scenario_.spec.bodies[i].mass + environment_.sea->density * scenario_.volume) *
               environment_.gravity;
  }
  smallest_scale_ = kSmallestScale * weight_ * scenario_.size;
  if (!judges_energy()) return;
  const Energy energy = find_energy(motions);
  energy_ = lowest_ = highest_ = energy.total() + energy.unseen;
  lowest_potential_ = energy.potential;
}

double Watch::overlap_energy(const std::vector<engine::Motion>& motions) {
  if (!world_.can_collide()) return 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].movable) continue;
    const auto id = static_cast<engine::BodyId>(i);
    world_.set_state(id, motions[i].state);
    world_.set_contact_inertia(id, {.mass = engine::contact_mass(bodies_[i], motions[i])});
  }
  world_.collide(scenario_.spec.step);
  double deepest = 0;
  for (const engine::Contact& contact : world_.contacts().points)
    deepest = std::max(deepest, contact.point.depth);
  return weight_ * static_cast<double>(bodies_.size()) * deepest;
}

Watch::Energy Watch::find_energy(const std::vector<engine::Motion>& motions) {
  Energy sum;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].movable) continue;
    const engine::Motion& motion = motions[i];
    const double moved = kinetic_energy(bodies_[i], motion);
    const double reported = kinetic_energy(bodies_[i], at_its_pose(bodies_[i], motion));
    sum.kinetic += std::min(moved, reported) + engine::memory_energy(bodies_[i], motion);
    sum.unseen += std::abs(moved - reported);
    sum.potential += engine::potential_energy(bodies_[i], motion);
  }
  sum.potential -= scenario_.push.dot(motions[0].state.position);
  sum.unseen += stretch_energy(scenario_.spec, motions);
  sum.overlap = overlap_energy(motions);
  return sum;
}

void Watch::follow_energy(const Energy& energy) {
  energy_ = std::max(energy.total(), std::min(lowest_, energy.total() + energy.unseen));
  lowest_ = std::min(lowest_, energy_);
  highest_ = std::max(highest_, energy_);
  lowest_potential_ = std::min(lowest_potential_, energy.potential);
  const double scale = std::max(highest_ - lowest_potential_, smallest_scale_);
  overlap_ = std::max(overlap_, energy.overlap);
  worst_rise_ = std::max(worst_rise_, (energy_ - lowest_ - overlap_) / scale);
}

double Watch::greatest_speed(std::size_t i, const hydro::BodyState& state) const {
  const engine::BodySpec& body = scenario_.spec.bodies[i];
  const double c = fastest(*environment_.sea);
  const Eigen::Vector3d way = state.position - body.initial.position;
  const double depth = environment_.highest - body.initial.position.z();
  double kinetic = 0;
  for (const double energy : initial_energies_) kinetic += energy;
  const double lift = environment_.sea->density * environment_.gravity * scenario_.volume *
                      (std::max(0.0, depth) + scenario_.size);
  const double sunk = body.mass * environment_.gravity * std::max(0.0, -way.z());
  const double pushed = scenario_.push.norm() * way.norm();
  const double bodies = static_cast<double>(bodies_.size());
  const double q = std::sqrt(2 * kinetic / body.mass);
  return c + std::sqrt((q + c) * (q + c) + 2 * bodies * (lift + sunk + pushed) / body.mass);
}

std::optional<std::string> Watch::left(const engine::Simulation& simulation) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].movable) continue;
    const hydro::BodyState& state = simulation.states()[i];
    const hydro::BodyState& initial = scenario_.spec.bodies[i].initial;
    const double v = greatest_speed(i, state);
    const double way = (state.position - initial.position).head<2>().norm();
    if (way > v * simulation.time() + scenario_.size)
      return fmt::format("{} got {:.3g} m away, no more than {:.3g} m/s fast",
                         scenario_.spec.bodies[i].name, way, v);
    const double height = state.position.z() - std::max(environment_.highest, initial.position.z());
    if (height > v * v / (2 * environment_.gravity) + scenario_.size)
      return fmt::format("{} rose {:.3g} m, no more than {:.3g} m/s fast",
                         scenario_.spec.bodies[i].name, height, v);
  }
  return std::nullopt;
}

std::optional<std::string> Watch::stalled(const engine::Simulation& simulation) {
  const std::vector<engine::Counts> counts = simulation.counts();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    most_substeps_ = std::max(most_substeps_, counts[i].substeps - counts_[i].substeps);
    most_sweeps_ = std::max(most_sweeps_, counts[i].iterations - counts_[i].iterations);
  }
  counts_ = counts;
  if (most_substeps_ > kMostSubsteps) return fmt::format("a step took {} substeps", most_substeps_);
  if (most_sweeps_ > kMostSweeps)
    return fmt::format("a step took {} sweeps over its constraints", most_sweeps_);
  return std::nullopt;
}

std::optional<std::string> Watch::look(const engine::Simulation& simulation) {
  for (const hydro::BodyState& state : simulation.states())
    if (const auto fault = engine::state_fault(state)) return fault;
  if (judges_energy()) {
    follow_energy(find_energy(motions_of(simulation)));
    if (worst_rise_ > kLargestRise)
      return fmt::format("energy rose by {:.3g} of the greatest so far", worst_rise_);
  }
  if (scenario_.inside)
    if (auto fault = left(simulation)) return fault;
  return stalled(simulation);
}

}  // namespace stress

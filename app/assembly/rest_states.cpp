#include "app/assembly/rest_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/assembly/rigid_group.h"
#include "engine/simulation.h"

namespace assembly {
namespace {

using engine::BodyId;
using engine::kWorld;

constexpr long kMostSteps = 20000;
constexpr double kFarthest = 10;  ///< Radii from the start [-].

/// Acceleration below which bodies are at rest, in units of gravity [-]: that of a floating body
/// which is off its rest by this part of its size.
constexpr double kAtRest = 1e-7;

/// A load that acts from the start on and does not change.
bool is_constant(const engine::AppliedLoad& load) {
  return load.start <= 0 && std::isinf(load.end) && !load.sine && !load.factor;
}

/// Holder of each body; empty: the water alone.
std::vector<std::string> holders(const engine::SimulationSpec& spec) {
  std::vector<std::string> holders(spec.bodies.size());
  const auto add = [&](BodyId id, const std::string& holder) {
    if (id != kWorld) holders[static_cast<std::size_t>(id)] = holder;
  };
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    const engine::BodySpec& body = spec.bodies[i];
    if (std::ranges::any_of(body.loads, is_constant)) holders[i] = "a constant load";
    if (body.locked[2] || body.locked[3] || body.locked[4]) holders[i] = "a lock";
  }
  for (const engine::LineSpec& line : spec.lines)
    for (const BodyId id : {line.first.body, line.second.body})
      add(id, fmt::format("the line {}", line.name));
  for (const engine::JointSpec& joint : spec.joints) {
    const bool rigid = joint.type == engine::JointSpec::Type::fixed && joint.first != kWorld &&
                       joint.second != kWorld;
    if (rigid) continue;
    for (const BodyId id : {joint.first, joint.second})
      add(id, fmt::format("the joint {}", joint.name));
  }
  return holders;
}

double radius_of(const engine::BodySpec& body) {
  return std::sqrt(body.mesh_B.vertices.colwise().squaredNorm().maxCoeff());
}

/// The body without what moves it, damps it or lets water in.
void calm(engine::BodySpec& body) {
  body.initial.linear_velocity.setZero();
  body.initial.angular_velocity.setZero();
  body.added_mass.reset();
  body.radiation.reset();
  body.openings.clear();
  body.pumps.clear();
  std::erase_if(body.loads, [](const engine::AppliedLoad& load) { return !is_constant(load); });
  body.coefficients.pressure_drag = {0, 0};
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
}

/// Takes the inertia from a line: a mooring is a catenary then, and a rope straight with half of
/// its weight at each end.
void put_at_rest(engine::LineSpec& line, engine::SimulationSpec& still) {
  line.inertia.reset();
  if (line.kind == engine::LineSpec::Kind::mooring) return;
  for (const engine::AttachmentPoint& end : {line.first, line.second})
    if (end.body != engine::kWorld)
      still.bodies[static_cast<std::size_t>(end.body)].loads.push_back(
          {.force = {0, 0, -line.weight * line.length / 2}, .at_B = end.at});
}

/// The scene in still water, with all bodies outside the group held where they start.
engine::SimulationSpec still_scene(const engine::SimulationSpec& spec, const HeldGroup& group,
                                   double step) {
  engine::SimulationSpec still = spec;
  still.integrator = {};
  still.step = step;
  still.record_work = false;
  still.threads = 1;
  still.sea->surface = hydro::FlatSurface{};
  still.sea->current.setZero();
  still.sea->profile.clear();
  still.sea->air.reset();
  still.propellers.clear();
  still.foils.clear();
  still.controls.clear();
  for (engine::JointSpec& joint : still.joints) {
    joint.drive.motor.reset();
    joint.drive.damping = joint.drive.friction = 0;
  }
  for (engine::LineSpec& line : still.lines) {
    line.breaks_at = std::numeric_limits<double>::infinity();
    if (line.inertia) put_at_rest(line, still);
    line.set_length.reset();
    line.set_rate.reset();
  }
  for (engine::BodySpec& body : still.bodies) {
    calm(body);
    body.locked.fill(true);
  }
  for (const BodyId id : group.bodies)
    still.bodies[static_cast<std::size_t>(id)].locked =
        spec.bodies[static_cast<std::size_t>(id)].locked;
  return still;
}

/// The bodies of one group on their way to rest.
class Settling {
 public:
  Settling(const engine::SimulationSpec& still, const HeldGroup& group)
      : group_(group), simulation_(still), start_(simulation_.states()), stopped_at_(start_) {
    for (const engine::BodySpec& body : still.bodies) radii_.push_back(radius_of(body));
  }

  std::optional<Rest> rest() {
    double energy = 0, time = 0;
    for (long i = 0; i < kMostSteps; ++i) {
      simulation_.step();
      time += simulation_.spec().step;
      if (!(largest_motion(start_) < kFarthest)) return std::nullopt;
      const double now = kinetic_energy();
      if (now >= energy && now > 0) {
        energy = now;
        continue;
      }
      const double least = std::ranges::min(radii_);
      const double acceleration = 2 * largest_motion(stopped_at_) * least / (time * time);
      stop();
      if (acceleration < kAtRest * simulation_.spec().gravity) return found();
      energy = time = 0;
    }
    return std::nullopt;
  }

 private:
  Rest found() const {
    Rest rest{.states = simulation_.states(), .coordinates = {}};
    for (const engine::JointReading& joint : simulation_.rig().joints)
      rest.coordinates.push_back(joint.coordinate);
    return rest;
  }

  double kinetic_energy() const {
    double energy = 0;
    for (const BodyId id : group_.bodies) {
      const auto i = static_cast<std::size_t>(id);
      const engine::BodySpec& body = simulation_.spec().bodies[i];
      const hydro::BodyState& state = simulation_.states()[i];
      const Eigen::Vector3d spin_B = state.orientation.conjugate() * state.angular_velocity;
      energy +=
          body.mass * state.linear_velocity.squaredNorm() + spin_B.dot(body.inertia_B * spin_B);
    }
    return energy;
  }

  /// Largest displacement of a body from one of these states, with its turn, in its radii.
  double largest_motion(const std::vector<hydro::BodyState>& from) const {
    double most = 0;
    for (const BodyId id : group_.bodies) {
      const auto i = static_cast<std::size_t>(id);
      const hydro::BodyState& now = simulation_.states()[i];
      most = std::max(most, (now.position - from[i].position).norm() / radii_[i] +
                                now.orientation.angularDistance(from[i].orientation));
    }
    return most;
  }

  void stop() {
    stopped_at_ = simulation_.states();
    for (const BodyId id : group_.bodies) {
      hydro::BodyState& state = stopped_at_[static_cast<std::size_t>(id)];
      state.linear_velocity.setZero();
      state.angular_velocity.setZero();
      simulation_.set_motion(id, state);
    }
  }

  const HeldGroup& group_;
  engine::Simulation simulation_;
  std::vector<hydro::BodyState> start_;
  std::vector<hydro::BodyState> stopped_at_;
  std::vector<double> radii_;
};

}  // namespace

std::vector<HeldGroup> held_groups(const engine::SimulationSpec& spec) {
  std::vector<engine::Pair> pairs;
  for (const engine::JointSpec& joint : spec.joints)
    pairs.push_back(std::minmax(joint.first, joint.second));
  for (const engine::LineSpec& line : spec.lines)
    pairs.push_back(std::minmax(line.first.body, line.second.body));
  const std::vector<std::string> holder_of = holders(spec);
  std::vector<HeldGroup> groups;
  for (std::vector<BodyId>& members : groups_by(std::move(pairs), spec.bodies.size())) {
    HeldGroup group{.bodies = std::move(members), .holder = {}};
    for (const BodyId id : group.bodies)
      if (group.holder.empty()) group.holder = holder_of[static_cast<std::size_t>(id)];
    groups.push_back(std::move(group));
  }
  return groups;
}

std::optional<Rest> find_rest(const engine::SimulationSpec& spec, const HeldGroup& group) {
  double least = std::numeric_limits<double>::infinity();
  for (const BodyId id : group.bodies)
    least = std::min(least, radius_of(spec.bodies[static_cast<std::size_t>(id)]));
  const double step = std::clamp(0.1 * std::sqrt(least / spec.gravity), 1e-3, 0.05);
  try {
    return Settling(still_scene(spec, group, step), group).rest();
  } catch (const engine::SimulationError&) {
    return std::nullopt;
  }
}

}  // namespace assembly

#include "engine/energy_guard.h"

#include <algorithm>
#include <cmath>

#include "engine/energy.h"

namespace engine {
namespace {

/// A swing that goes through less in a step keeps its energy but for what comes back [rad].
constexpr double kSmoothSwing = 0.3;

/// What joints may come to have given a group, of the energy of its motion, where water adds to it.
constexpr double kJointGain = 0.1;

/// ½ u·(M + A) u with the velocity in W [J].
double absolute_energy(const Body& body, const Motion& motion) {
  const Eigen::Matrix3d R_BW = motion.state.orientation.conjugate().toRotationMatrix();
  const Vector6d u = turned(R_BW, velocity(motion.state, Eigen::Vector3d::Zero()));
  return u.dot((body.rigid_B + motion.added_B) * u) / 2;
}

struct Energies {
  double kinetic = 0;
  double potential = 0;
};

Energies energies(const std::vector<std::size_t>& members, const std::vector<Body>& bodies,
                  const EnergyGuard::MotionOf& motion, const Surroundings& around) {
  Energies sum;
  for (const std::size_t i : members) {
    sum.kinetic += kinetic_energy(bodies[i], around, motion(i));
    sum.potential += potential_energy(bodies[i], around, motion(i).state);
  }
  return sum;
}

}  // namespace

EnergyGuard::EnergyGuard(const std::vector<std::vector<BodyId>>& groups,
                         const std::vector<Body>& bodies, const Surroundings& around)
    : around_(around) {
  for (const std::vector<BodyId>& ids : groups) {
    // On a guide a body keeps to the rule of a free one.
    if (ids.size() == 1 && bodies[static_cast<std::size_t>(ids.front())].guide) continue;
    Group group;
    for (const BodyId id : ids) {
      const auto i = static_cast<std::size_t>(id);
      group.bodies.push_back(i);
      group.floor += least_energy_scale(bodies[i], around);
      group.in_still_water = group.in_still_water && must_not_gain_energy(bodies[i], around);
    }
    groups_.push_back(std::move(group));
  }
}

bool EnergyGuard::gained(const std::vector<Body>& bodies, const MotionOf& before,
                         const std::vector<bool>& touching, const std::vector<double>& work,
                         double step) {
  bool any = false;
  for (Group& group : groups_) {
    group.excess = 0;
    group.next = group.range;
    group.next_given = group.given;
    const auto touches = [&](std::size_t i) { return touching[i]; };
    if (std::any_of(group.bodies.begin(), group.bodies.end(), touches)) {
      group.next = {};
      group.next_given = 0;
      continue;
    }
    const auto smooth = [&](std::size_t i) {
      const KickHistory& kicks = bodies[i].motion.kicks;
      return kicks.resolved() && kicks.pace() * step <= kSmoothSwing;
    };
    if (std::all_of(group.bodies.begin(), group.bodies.end(), smooth)) continue;
    if (group.in_still_water)
      look(group, bodies, before, step);
    else
      look_at_joints(group, bodies, before, work);
    any = any || group.excess > group.allowed;
  }
  return any;
}

void EnergyGuard::look(Group& group, const std::vector<Body>& bodies, const MotionOf& before,
                       double step) const {
  const Energies start = energies(group.bodies, bodies, before, around_);
  const auto after = [&](std::size_t i) -> const Motion& { return bodies[i].motion; };
  const Energies end = energies(group.bodies, bodies, after, around_);
  group.next.extend(start.kinetic + start.potential, start.potential);
  const auto driven = [&](std::size_t i) { return is_driven(bodies[i]); };
  if (std::any_of(group.bodies.begin(), group.bodies.end(), driven)) {
    group.next.lowest = start.kinetic + start.potential;
    for (const std::size_t i : group.bodies)
      group.next.lowest +=
          work_done(bodies[i], around_, before(i).state, bodies[i].motion.state, step);
  }
  const double energy = end.kinetic + end.potential;
  group.kinetic = end.kinetic;
  group.allowed = group.next.allowed_gain(group.floor);
  group.excess = energy - group.next.lowest - group.allowed;
  group.next.extend(std::min(energy, energy - group.excess), end.potential);
}

void EnergyGuard::look_at_joints(Group& group, const std::vector<Body>& bodies,
                                 const MotionOf& before, const std::vector<double>& work) const {
  double start = 0, end = 0, gain = 0;
  for (const std::size_t i : group.bodies) {
    start += absolute_energy(bodies[i], before(i));
    end += absolute_energy(bodies[i], bodies[i].motion);
    gain += work[i];
  }
  // Of what joints add, drag may take all at once; what loads take of the motion later they take of
  // the gains in it, too.
  if (gain > 0) gain = std::min(gain, std::max(0.0, end - start));
  const double sound = std::max(0.0, end - gain);
  const double left = start > 0 ? std::min(1.0, sound / start) : 1;
  group.next_given = std::max(0.0, left * group.given + gain);
  group.kinetic = end;
  group.allowed = kJointGain * std::max({start, sound, group.floor});
  group.excess = group.next_given - group.allowed;
  if (group.excess > 0) group.next_given -= std::min(group.excess, end);
}

void EnergyGuard::brake(std::vector<Body>& bodies, const MotionOf& before) const {
  for (const Group& group : groups_) {
    if (!(group.excess > 0)) continue;
    const bool enough = group.kinetic > group.excess;
    const bool much = group.excess > group.allowed;
    if (!enough && !much) continue;
    const double part = enough ? std::sqrt(1 - group.excess / group.kinetic) : 0;
    for (const std::size_t i : group.bodies) {
      Motion& motion = bodies[i].motion;
      if (!enough) motion = before(i);
      const Motion fast = motion;
      // Still water has no current where joints hold a body.
      const Eigen::Vector3d still = Eigen::Vector3d::Zero();
      motion.state = with_velocity(motion.state, part * velocity(motion.state, still), still);
      if (motion.ledger) book_brake(bodies[i], around_, fast, motion);
      if (!much) continue;
      motion.kicks.clear();
      ++bodies[i].cost.braked;
    }
  }
}

void EnergyGuard::accept() {
  for (Group& group : groups_) {
    group.range = group.next;
    group.given = group.next_given;
  }
}

}  // namespace engine

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

/// Of the motion in W, whatever the water does [J].
double absolute_energy(const Body& body, const Motion& motion) {
  return kinetic_energy(body, Surroundings{}, motion);
}

struct Energies {
  double kinetic = 0;
  double potential = 0;
};

template <class MotionOf>
Energies energies(const std::vector<std::size_t>& members, const std::vector<Body>& bodies,
                  const MotionOf& motion, const Surroundings& around) {
  Energies sum;
  for (const std::size_t i : members) {
    sum.kinetic += kinetic_energy(bodies[i], around, motion(i));
    sum.potential += potential_energy(bodies[i], around, motion(i).state);
  }
  return sum;
}

}  // namespace

EnergyGuard::EnergyGuard(const std::vector<BodyId>& group, const std::vector<Body>& bodies,
                         const Surroundings& around)
    : around_(around) {
  for (const BodyId id : group) {
    const auto i = static_cast<std::size_t>(id);
    bodies_.push_back(i);
    floor_ += least_energy_scale(bodies[i], around);
    in_still_water_ = in_still_water_ && must_not_gain_energy(bodies[i], around);
  }
}

bool EnergyGuard::gained(const std::vector<Body>& bodies, const HeldStepOf& held, double step) {
  excess_ = 0;
  next_ = range_;
  next_given_ = given_;
  const auto touches = [&](std::size_t i) { return held(i).touching; };
  if (std::any_of(bodies_.begin(), bodies_.end(), touches)) {
    next_ = {};
    next_given_ = 0;
    return false;
  }
  const auto smooth = [&](std::size_t i) {
    const KickHistory& kicks = bodies[i].motion.kicks;
    return kicks.resolved() && kicks.pace() * step <= kSmoothSwing;
  };
  if (std::all_of(bodies_.begin(), bodies_.end(), smooth)) return false;
  if (in_still_water_)
    look(bodies, held, step);
  else
    look_at_joints(bodies, held);
  return excess_ > allowed_;
}

void EnergyGuard::look(const std::vector<Body>& bodies, const HeldStepOf& held, double step) {
  const auto before = [&](std::size_t i) -> const Motion& { return held(i).before; };
  const auto after = [&](std::size_t i) -> const Motion& { return bodies[i].motion; };
  const Energies start = energies(bodies_, bodies, before, around_);
  const Energies end = energies(bodies_, bodies, after, around_);
  next_.extend(start.kinetic + start.potential, start.potential);
  const auto driven = [&](std::size_t i) { return is_driven(bodies[i]); };
  if (std::any_of(bodies_.begin(), bodies_.end(), driven)) {
    next_.lowest = start.kinetic + start.potential;
    for (const std::size_t i : bodies_)
      next_.lowest += work_done(bodies[i], around_, before(i).state, after(i).state, step);
  }
  const double energy = end.kinetic + end.potential;
  kinetic_ = end.kinetic;
  allowed_ = next_.allowed_gain(floor_);
  excess_ = energy - next_.lowest - allowed_;
  next_.extend(std::min(energy, energy - excess_), end.potential);
}

void EnergyGuard::look_at_joints(const std::vector<Body>& bodies, const HeldStepOf& held) {
  double start = 0, end = 0, gain = 0;
  for (const std::size_t i : bodies_) {
    start += absolute_energy(bodies[i], held(i).before);
    end += absolute_energy(bodies[i], bodies[i].motion);
    gain += held(i).work;
  }
  // Of what joints add, drag may take all at once; what loads take of the motion later they take of
  // the gains in it, too.
  if (gain > 0) gain = std::min(gain, std::max(0.0, end - start));
  const double sound = std::max(0.0, end - gain);
  const double left = start > 0 ? std::min(1.0, sound / start) : 1;
  next_given_ = std::max(0.0, left * given_ + gain);
  kinetic_ = end;
  allowed_ = kJointGain * std::max({start, sound, floor_});
  excess_ = next_given_ - allowed_;
  if (excess_ > 0) next_given_ -= std::min(excess_, end);
}

void EnergyGuard::brake(std::vector<Body>& bodies, const HeldStepOf& held) const {
  if (!(excess_ > 0)) return;
  const bool enough = kinetic_ > excess_;
  const bool much = excess_ > allowed_;
  if (!enough && !much) return;
  const double part = enough ? std::sqrt(1 - excess_ / kinetic_) : 0;
  for (const std::size_t i : bodies_) {
    Motion& motion = bodies[i].motion;
    if (!enough) motion = held(i).before;
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

void EnergyGuard::accept() {
  range_ = next_;
  given_ = next_given_;
}

}  // namespace engine

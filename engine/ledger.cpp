#include "engine/ledger.h"

#include "engine/applied_load.h"
#include "engine/energy.h"
#include "engine/kick.h"
#include "engine/wetness.h"

namespace engine {
namespace {

Eigen::Matrix3d turn_of(const Motion& motion) {
  return motion.state.orientation.toRotationMatrix();
}

Vector6d carried(const Surroundings& around) {
  return stacked(around.current(), Eigen::Vector3d::Zero());
}

/// ½ u·X u.
double half_square(const Matrix6d& X, const Vector6d& u) { return u.dot(X * u) / 2; }

/// Momentum of the body's own mass, in W, for a velocity in W.
Vector6d own_momentum(const Body& body, const Motion& motion, const Vector6d& u) {
  const Eigen::Matrix3d R_WB = turn_of(motion);
  return turned(R_WB, body.rigid_B * turned(R_WB.transpose(), u));
}

/// That of the water that moves with it.
Vector6d added_momentum(const Motion& motion, const Vector6d& u) {
  const Eigen::Matrix3d R_WB = turn_of(motion);
  return turned(R_WB, motion.added() * turned(R_WB.transpose(), u));
}

double own_kinetic_energy(const Body& body, const Motion& motion) {
  const Vector6d v = velocity(motion.state, Eigen::Vector3d::Zero());
  return v.dot(own_momentum(body, motion, v)) / 2;
}

/// K + E_A.
double whole_kinetic_energy(const Body& body, const Surroundings& around, const Motion& motion) {
  return own_kinetic_energy(body, motion) + added_kinetic_energy(body, around, motion);
}

/// Enters an impulse of the water that moves with a body: a current that carries the body along
/// does work by it.
void add_added_impulse(const Surroundings& around, const Vector6d& impulse, Ledger& ledger) {
  ledger.added_impulse += impulse;
  ledger.works.added_mass += around.current().dot(impulse.head<3>());
}

/// Enters the works of the body's loads at the mean velocity `w` over `step`. @return their sum as
/// an impulse.
Vector6d book_loads(const Body& body, const Vector6d& w, double step, Works& works) {
  Vector6d sum = Vector6d::Zero();
  const auto add = [&](const hydro::Wrench& load, double& work) {
    const Vector6d impulse = step * stacked(load);
    work += impulse.dot(w);
    sum += impulse;
  };
  add(body.loads.water.buoyancy, works.buoyancy);
  add(body.loads.water.pressure_drag, works.pressure_drag);
  add(body.loads.water.viscous_drag, works.viscous_drag);
  add(body.loads.water.lift, works.lift);
  for (const hydro::Wrench& load : body.loads.applied) add(load, works.applied);
  add(body.loads.weight, works.weight);
  return sum;
}

/// True if locks or its guide hold a body where nothing else does.
bool holds_itself(const Body& body) { return body.locked || body.guide; }

}  // namespace

double added_kinetic_energy(const Body& body, const Surroundings& around, const Motion& motion) {
  if (!body.adds) return 0;
  const Vector6d u = velocity(motion.state, around.current());
  return half_square(motion.added(), turned(turn_of(motion).transpose(), u));
}

void book_kick(const Body& body, const Surroundings& around, const Middle& middle,
               const Kicked& kicked, Motion& after) {
  Ledger& ledger = *after.ledger;
  const Matrix6d S = inertia_W(body, middle);
  const Vector6d u = middle.after + kicked.change;
  const Vector6d mean = (middle.before + u) / 2;
  const Vector6d w = mean + carried(around);
  const Vector6d impulse = S * kicked.change;
  Vector6d rest = impulse - book_loads(body, w, kicked.step, ledger.works);
  if (kicked.reaction) {
    const Vector6d held = kicked.step * *kicked.reaction;
    ledger.constraint_impulse += held;
    ledger.works.constraint += held.dot(w);
    rest -= held;
  } else if (holds_itself(body)) {
    ledger.constraint_impulse += rest;
  }
  // What is left does work as the part of the buoyancy that a kick took implicitly, or as the
  // difference of loads on a guide to those of the pose halfway.
  if (kicked.implicit)
    ledger.works.buoyancy += rest.dot(w);
  else if (kicked.reaction || holds_itself(body))
    ledger.works.constraint += rest.dot(w);
  if (!body.adds) return;
  ledger.works.added_mass += half_square(inertia_W(body, after), u) -
                             half_square(inertia_W(body, *middle.motion), middle.before) -
                             impulse.dot(mean);
  add_added_impulse(around, own_momentum(body, after, u - middle.before) - impulse, ledger);
}

void book_drift(const Body& body, const Surroundings& around, const Motion& before, double time,
                Motion& after) {
  const bool held = holds_itself(body);
  if (!held && !before.added_B) return;
  const Vector6d u0 = velocity(before.state, around.current());
  const Vector6d u1 = velocity(after.state, around.current());
  const Vector6d own = own_momentum(body, after, u1) - own_momentum(body, before, u0);
  if (!held) return add_added_impulse(around, own, *after.ledger);
  Vector6d water = Vector6d::Zero();
  if (before.added_B) {
    const Vector6d p0 = added_momentum(before, u0);
    const Vector6d p1 = added_momentum(after, u1);
    const Eigen::Vector3d v = (u0 + u1).head<3>() / 2;
    const Eigen::Vector3d P = (p0 + p1).head<3>() / 2;
    water = p0 - p1;
    water.tail<3>() -= time * v.cross(P);  // about a centre of mass that moves on
    add_added_impulse(around, water, *after.ledger);
  }
  after.ledger->constraint_impulse += own - water;
}

void book_added_mass(const Body& body, const Surroundings& around, const Motion& before,
                     Motion& after) {
  const Vector6d change =
      velocity(after.state, around.current()) - velocity(before.state, around.current());
  after.ledger->works.added_mass +=
      kinetic_energy(body, around, after) - kinetic_energy(body, around, before);
  add_added_impulse(around, own_momentum(body, after, change), *after.ledger);
}

void book_brake(const Body& body, const Surroundings& around, const Motion& before, Motion& after) {
  after.ledger->works.brake +=
      whole_kinetic_energy(body, around, after) - whole_kinetic_energy(body, around, before);
}

void book_ode_step(const Body& body, const Motion& before, double step, bool held, Motion& after) {
  const Vector6d v0 = velocity(before.state, Eigen::Vector3d::Zero());
  const Vector6d v1 = velocity(after.state, Eigen::Vector3d::Zero());
  const Vector6d w = (v0 + v1) / 2;
  Ledger& ledger = *after.ledger;
  const Vector6d impulse = book_loads(body, w, step, ledger.works);
  if (!held) return;
  const Vector6d rest = own_momentum(body, after, v1) - own_momentum(body, before, v0) - impulse;
  ledger.constraint_impulse += rest;
  ledger.works.constraint += rest.dot(w);
}

BodyForces forces_on(const Body& body, const Surroundings& around, double time, double step,
                     bool asleep) {
  const Motion& motion = body.motion;
  const hydro::BodyState& state = motion.state;
  const Ledger& ledger = *motion.ledger;
  BodyForces forces{.works = ledger.works};
  for (const AppliedLoad& load : body.spec->loads) forces.applied += wrench(load, state, time);
  if (body.pull) forces.applied += pull_on(body, state);
  forces.weight.force.z() = -body.spec->mass * around.gravity;
  if (body.wet && lowest_point(body.box_B, state) < around.highest)
    forces.water = hydro::compute_loads(*body.hull, state, *around.sea, time,
                                        body.spec->coefficients, body.spec->summation);
  forces.added_mass = to_wrench(ledger.added_impulse / step);
  forces.constraint = to_wrench(ledger.constraint_impulse / step);
  if (!body.movable || asleep)
    forces.constraint = -1.0 * (forces.weight + forces.applied + forces.water.total());
  forces.kinetic_energy = own_kinetic_energy(body, motion);
  forces.added_kinetic_energy = added_kinetic_energy(body, around, motion);
  const double level = around.sea ? around.sea->level : 0;
  forces.potential_energy = body.spec->mass * around.gravity * (state.position.z() - level);
  forces.works.added_mass += ledger.added_energy_at_start - forces.added_kinetic_energy;
  return forces;
}

}  // namespace engine

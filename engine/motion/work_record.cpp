#include "engine/motion/work_record.h"

#include <cmath>
#include <utility>

#include "engine/motion/energy.h"
#include "engine/motion/locks.h"
#include "engine/motion/velocity_update.h"

namespace engine {
namespace {

/// ½ u·X u.
double half_square(const Matrix6d& X, const Vector6d& u) { return u.dot(X * u) / 2; }

/// X u in W, for X in B and u in W.
Vector6d momentum(const Matrix6d& X_B, const Motion& motion, const Vector6d& u) {
  const Eigen::Matrix3d R_WB = motion.state.orientation.toRotationMatrix();
  return rotate(R_WB, X_B * rotate(R_WB.transpose(), u));
}

/// K + E_A
double moving_energy(const Body& body, const Motion& motion) {
  return own_kinetic_energy(body, motion) + added_kinetic_energy(body, motion);
}

/// Adds an impulse of the water that moves with a body, by which water of a velocity does work.
void add_added_impulse(const Eigen::Vector3d& flow, const Vector6d& impulse, WorkRecord& record) {
  record.added_impulse += impulse;
  record.works.added_mass += flow.dot(impulse.head<3>());
}

/// The added kinetic energy relative to the current less that relative to the flow, whose velocity
/// is w relative to the current: w·A u + ½ w·A w.
double energy_by_flow(const Body& body, const Motion& motion) {
  const Vector6d w = to_vector6(motion.flow - body.current(), Eigen::Vector3d::Zero());
  if (w.isZero(0) || !motion.added_B) return 0;
  const Vector6d u = velocity(motion.state, motion.flow);
  return w.dot(momentum(*motion.added_B, motion, u + w / 2));
}

/// Adds the works of the loads at the mean velocity `w` over a time h. @return their impulse
Vector6d record_loads(const BodyLoads& loads, const Vector6d& w, double h, Works& works) {
  Vector6d sum = Vector6d::Zero();
  const auto add = [&](const hydro::Wrench& load, double& work) {
    const Vector6d impulse = h * to_vector6(load);
    work += impulse.dot(w);
    sum += impulse;
  };
  add(loads.water.buoyancy, works.buoyancy);
  add(loads.water.pressure_drag, works.pressure_drag);
  add(loads.water.viscous_drag, works.viscous_drag);
  add(loads.water.lift, works.lift);
  add(loads.water.wave_inertia, works.wave_inertia);
  add(loads.water.diffraction, works.diffraction);
  add(loads.water.hull_lift, works.hull_lift);
  add(loads.water.wind, works.wind);
  add(loads.water.interior, works.interior);
  add(loads.water.resistance, works.resistance);
  for (const hydro::Wrench& load : loads.applied) add(load, works.applied);
  add(loads.weight, works.weight);
  add(loads.lines, works.lines);
  add(loads.machines, works.machines);
  return sum;
}

/// Puts what (E4) leaves out in the components that locks hold into the impulse of an update: the
/// water that a body gains there comes to move with the body, and the locks hold against that.
void complete_locked(const Body& body, const MidpointState& midpoint, const Vector6d& u,
                     const Motion& after, Vector6d& impulse) {
  const Motion& before = *midpoint.motion;
  const DofMask locked = mobility(body, before.state).locked;
  if (!partly_locked(locked) || after.added() == before.added()) return;
  const Matrix6d change = rotate_tensor(midpoint.R_WB, after.added() - before.added());
  const InertiaChange whole =
      inertia_change(inertia_W(body, before, midpoint.R_WB), change, {}, midpoint.before);
  const Vector6d all = whole.inertia * (u - whole.velocity);
  for (int i = 0; i < 6; ++i)
    if (locked[i]) impulse[i] = all[i];
}

/// True if locks or a reduced joint constrain the body by projection, not by reactions.
bool is_projected(const Body& body) { return body.locked || body.reduced_joint; }

}  // namespace

double own_kinetic_energy(const Body& body, const Motion& motion) {
  const Vector6d v = velocity(motion.state, Eigen::Vector3d::Zero());
  return v.dot(momentum(body.rigid_B, motion, v)) / 2;
}

double added_kinetic_energy(const Body& body, const Motion& motion) {
  if (!body.has_added_mass) return 0;
  const Vector6d u = velocity(motion.state, body.current());
  return half_square(motion.added(),
                     rotate(motion.state.orientation.toRotationMatrix().transpose(), u));
}

void record_update(const MovingBody& moving, const MidpointState& midpoint,
                   const UpdateRecord& update, Motion& after) {
  const Body& body = moving.body;
  WorkRecord& record = *after.work;
  const Matrix6d S = inertia_W(body, midpoint);
  const Vector6d u = midpoint.after + update.change;
  const Vector6d mean = (midpoint.before + u) / 2;
  const Vector6d w = mean + to_vector6(after.flow, Eigen::Vector3d::Zero());
  Vector6d impulse = S * update.change;
  if (!update.reaction) complete_locked(body, midpoint, u, after, impulse);
  Vector6d rest = impulse - record_loads(moving.cache.loads, w, update.h, record.works);
  if (midpoint.memory) {
    const Vector6d memory =
        midpoint.memory->impulse(update.change, update.h) + update.h * midpoint.memory->turning;
    record.works.radiation += memory.dot(w);
    rest -= memory;
  }
  if (midpoint.rig_inertia) {
    const Vector6d less = *midpoint.rig_inertia * update.change;
    record.works.lines -= less.dot(w);
    rest += less;
  }
  if (update.reaction) {
    Vector6d reaction = update.h * *update.reaction;
    if (update.rows) {
      const Vector6d rows = update.h * *update.rows;
      record.row_impulse += rows;
      record.works.lines += rows.dot(w);
      rest -= rows;
      reaction -= rows;
    }
    record.constraint_impulse += reaction;
    record.works.constraint += reaction.dot(w);
    rest -= reaction;
  } else if (is_projected(body)) {
    record.constraint_impulse += rest;
  }
  // The rest is buoyancy that an implicit update added, or the difference between the loads on a
  // reduced joint and those of the pose halfway.
  if (update.implicit)
    record.works.buoyancy += rest.dot(w);
  else if (update.reaction || is_projected(body))
    record.works.constraint += rest.dot(w);
  if (!body.has_added_mass) return;
  record.works.added_mass += half_square(inertia_W(body, after), u) -
                             half_square(inertia_W(body, *midpoint.motion), midpoint.before) -
                             impulse.dot(mean) + energy_by_flow(body, after) -
                             energy_by_flow(body, *midpoint.motion);
  add_added_impulse(after.flow, momentum(body.rigid_B, after, u - midpoint.before) - impulse,
                    record);
}

void record_drift(const Body& body, const Motion& before, double time, Motion& after) {
  const bool projected = is_projected(body);
  if (!projected && !before.added_B) return;
  const Vector6d u0 = velocity(before.state, after.flow);
  const Vector6d u1 = velocity(after.state, after.flow);
  const auto spun = [](const Motion& motion) {
    return to_vector6(Eigen::Vector3d::Zero(), motion.state.orientation * motion.rotors_B);
  };
  // The momentum that rotors lose to the body is no load's.
  const Vector6d own = momentum(body.rigid_B, after, u1) - momentum(body.rigid_B, before, u0) +
                       spun(after) - spun(before);
  after.work->works.added_mass += energy_by_flow(body, after) - energy_by_flow(body, before);
  if (!projected) return add_added_impulse(after.flow, own, *after.work);
  Vector6d water = Vector6d::Zero();
  if (before.added_B) {
    const Vector6d p0 = momentum(before.added(), before, u0);
    const Vector6d p1 = momentum(after.added(), after, u1);
    const Eigen::Vector3d v = (u0 + u1).head<3>() / 2;
    const Eigen::Vector3d P = (p0 + p1).head<3>() / 2;
    water = p0 - p1;
    water.tail<3>() -= time * v.cross(P);  // about a moving centre of mass
    add_added_impulse(after.flow, water, *after.work);
  }
  after.work->constraint_impulse += own - water;
}

void record_added_mass(const Body& body, const Motion& before, Motion& after) {
  const Vector6d change =
      velocity(after.state, body.current()) - velocity(before.state, body.current());
  after.work->works.added_mass +=
      kinetic_energy(body, after, body.current()) - kinetic_energy(body, before, body.current());
  add_added_impulse(body.current(), momentum(body.rigid_B, after, change), *after.work);
}

void record_clamp(const Body& body, const Motion& before, Motion& after) {
  after.work->works.brake += moving_energy(body, after) - moving_energy(body, before);
}

void record_joints(const Body& body, const Motion& before, Motion& after) {
  WorkRecord& record = *after.work;
  const double weight = -body.spec->mass * body.environment.gravity *
                        (after.state.position.z() - before.state.position.z());
  record.works.weight += weight;
  record.works.constraint += moving_energy(body, after) - moving_energy(body, before) - weight;
  // A pose is put on a joint without an impulse.
  if (before.state.orientation != after.state.orientation) return;
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  const Vector6d change = velocity(after.state, still) - velocity(before.state, still);
  const Vector6d added = momentum(after.added(), after, change);
  record.constraint_impulse += momentum(body.rigid_B, after, change) + added;
  record.added_impulse -= added;
}

void record_ode_step(const MovingBody& moving, const Motion& before, double step, bool constrained,
                     Motion& after) {
  const Vector6d v0 = velocity(before.state, Eigen::Vector3d::Zero());
  const Vector6d v1 = velocity(after.state, Eigen::Vector3d::Zero());
  const Vector6d w = (v0 + v1) / 2;
  WorkRecord& record = *after.work;
  const Vector6d impulse = record_loads(moving.cache.loads, w, step, record.works);
  if (!constrained) return;
  const Vector6d rest = momentum(moving.body.rigid_B, after, v1) -
                        momentum(moving.body.rigid_B, before, v0) - impulse;
  record.constraint_impulse += rest;
  record.works.constraint += rest.dot(w);
}

double Works::sum() const {
  double sum = 0;
  for (const double work : all()) sum += work;
  return sum;
}

double Works::clamped_share() const {
  double sum = 0;
  for (const double work : all()) sum += std::abs(work);
  return brake == 0 ? 0 : std::abs(brake) / sum;
}

Works works_of(const Body& body, const Motion& motion) {
  Works works = motion.work->works;
  works.added_mass += motion.work->added_energy_at_start - added_kinetic_energy(body, motion);
  if (motion.water)
    works.water = std::exchange(works.radiation, 0) + std::exchange(works.diffraction, 0);
  return works;
}

}  // namespace engine

#include "engine/contacts/ode_world.h"

#include <ode/ode.h>

#include <algorithm>
#include <mutex>

#include "engine/base/constants.h"

namespace engine {
namespace {

dContact to_ode_contact(const Contact& contact) {
  const ContactPoint& point = contact.point;
  dContact ode{};
  Eigen::Map<Eigen::Vector3d>(ode.geom.pos) = point.position_W;
  Eigen::Map<Eigen::Vector3d>(ode.geom.normal) = point.normal_W;
  ode.geom.depth = point.depth;
  ode.surface.mode = dContactSoftERP | dContactSoftCFM | dContactMotionN | dContactSlip1 |
                     dContactSlip2 | dContactApprox1;
  ode.surface.mu = contact.friction;
  ode.surface.soft_erp = 0;
  ode.surface.motionN = contact.row.speed;
  ode.surface.soft_cfm = ode.surface.slip1 = ode.surface.slip2 = contact.row.compliance;

  const Eigen::Vector3d& velocity = contact.sliding_W;
  const Eigen::Vector3d sliding = velocity - velocity.dot(point.normal_W) * point.normal_W;
  if (sliding.norm() > 1e-9 * velocity.norm()) {
    ode.surface.mode |= dContactFDir1;
    Eigen::Map<Eigen::Vector3d>(ode.fdir1) = sliding.normalized();
  }
  return ode;
}

/// Takes a step by the iterative solver, which visits constraints in a random order: every step
/// starts the same one.
void step_by_iteration(dxWorld* world, int iterations, double step) {
  static std::mutex one_sequence;  // ODE has one random sequence for all worlds.
  const std::lock_guard lock(one_sequence);
  dWorldSetQuickStepNumIterations(world, iterations);
  dRandSetSeed(1);
  if (!dWorldQuickStep(world, step)) throw OdeFault("ODE: no memory for the step");
}

}  // namespace

void add_contact(dxWorld* world, dxJointGroup* group, const Contact& contact, dxBody* first,
                 dxBody* second) {
  const dContact ode = to_ode_contact(contact);
  dJointAttach(dJointCreateContact(world, group, &ode), first, second);
}

void place(dxBody* body, const hydro::BodyState& state) {
  const Eigen::Vector3d& p = state.position;
  const Eigen::Vector3d& v = state.linear_velocity;
  const Eigen::Vector3d& w = state.angular_velocity;
  dBodySetPosition(body, p.x(), p.y(), p.z());
  dBodySetQuaternion(body, to_ode(state.orientation).data());
  dBodySetLinearVel(body, v.x(), v.y(), v.z());
  dBodySetAngularVel(body, w.x(), w.y(), w.z());
}

void set_mass(dxBody* body, double mass, const Eigen::Matrix3d& inertia_B) {
  dMass ode;
  dMassSetParameters(&ode, mass, 0, 0, 0, inertia_B(0, 0), inertia_B(1, 1), inertia_B(2, 2),
                     inertia_B(0, 1), inertia_B(0, 2), inertia_B(1, 2));
  dBodySetMass(body, &ode);
}

bool step_or_fall_back(dxWorld* world, const std::function<void()>& restart, double step) {
  take_ode_warning();  // drops one of an earlier collision
  if (!dWorldStep(world, step)) throw OdeFault("ODE: no memory for the step");
  if (take_ode_warning().empty()) return false;
  restart();
  step_by_iteration(world, kFallbackIterations, step);
  return true;
}

}  // namespace engine

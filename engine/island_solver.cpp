#include "engine/island_solver.h"

#include <ode/ode.h>

#include <algorithm>
#include <bit>

#include "engine/constants.h"
#include "engine/row_joints.h"

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
  ode.surface.mu = kFriction;
  ode.surface.soft_erp = contact.stiffness.erp;
  ode.surface.soft_cfm = contact.stiffness.cfm;
  ode.surface.motionN = contact.stiffness.speed;
  ode.surface.slip1 = ode.surface.slip2 = contact.stiffness.slip;

  const Eigen::Vector3d& velocity = contact.sliding_W;
  const Eigen::Vector3d sliding = velocity - velocity.dot(point.normal_W) * point.normal_W;
  if (sliding.norm() > 1e-9 * velocity.norm()) {
    ode.surface.mode |= dContactFDir1;
    Eigen::Map<Eigen::Vector3d>(ode.fdir1) = sliding.normalized();
  }
  return ode;
}

/// Enables an ODE body with the state, mass and load of a solver body.
void prepare(dxBody* body, const SolverBody& as, double unit) {
  const Eigen::Vector3d force = unit * as.load.force;
  const Eigen::Vector3d moment = unit * as.load.moment;
  place(body, as.state);
  set_mass(body, unit * as.mass, unit * as.inertia_B);
  dBodySetForce(body, force.x(), force.y(), force.z());
  dBodySetTorque(body, moment.x(), moment.y(), moment.z());
  dBodyEnable(body);
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

IslandSolution solve(dxWorld* world, dxJointGroup* contact_joints,
                     const std::vector<dxBody*>& handles, const IslandProblem& problem,
                     bool exact) {
  const std::vector<SolverBody>& bodies = problem.bodies;
  const auto prepare_all = [&] {
    for (std::size_t i = 0; i < bodies.size(); ++i) prepare(handles[i], bodies[i], problem.unit);
  };
  const auto handle_of = [&](BodyId id) -> dxBody* {
    const auto place = std::lower_bound(bodies.begin(), bodies.end(), id,
                                        [](const SolverBody& b, BodyId i) { return b.body < i; });
    if (place == bodies.end() || place->body != id) return nullptr;
    return handles[place - bodies.begin()];
  };
  prepare_all();
  for (const Contact& contact : problem.contacts)
    add_contact(world, contact_joints, contact, handle_of(contact.pair.first),
                handle_of(contact.pair.second));
  RowJoints rows(world, contact_joints, problem.unit, problem.step);
  for (const ForceRow& row : problem.rows)
    rows.add(row, handle_of(row.first), handle_of(row.second));
  if (exact)
    step_or_fall_back(world, prepare_all, problem.step);
  else
    step_by_iteration(world, kHeapIterations, problem.step);
  IslandSolution solution{.velocities = {}, .forces = rows.forces()};
  dJointGroupEmpty(contact_joints);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    solution.velocities.push_back({vector_from_ode(dBodyGetLinearVel(handles[i])),
                                   vector_from_ode(dBodyGetAngularVel(handles[i]))});
    dBodyDisable(handles[i]);
  }
  return solution;
}

/// A world with a number of bodies, all disabled between two calls.
struct IslandSolver::PooledWorld {
  explicit PooledWorld(std::size_t count)
      : threading(dThreadingAllocateSelfThreadedImplementation()),
        world(dWorldCreate()),
        contact_joints(dJointGroupCreate(0)) {
    // The implementation that worlds share by default is not safe for several threads.
    dWorldSetStepThreadingImplementation(
        world.get(), dThreadingImplementationGetFunctions(threading.get()), threading.get());
    for (std::size_t i = 0; i < count; ++i) {
      bodies.push_back(dBodyCreate(world.get()));
      dBodySetGyroscopicMode(bodies.back(), 0);
      dBodyDisable(bodies.back());
    }
  }

  ThreadingHandle threading;
  WorldHandle world;
  JointGroupHandle contact_joints;  ///< It is destroyed before the world.
  std::vector<dxBody*> bodies;
};

std::unique_ptr<IslandSolver::PooledWorld> IslandSolver::take(std::size_t bodies) {
  const std::size_t size = std::bit_ceil(bodies);
  const std::lock_guard lock(mutex_);
  std::vector<std::unique_ptr<PooledWorld>>& unused = pool_[size];
  if (unused.empty()) return std::make_unique<PooledWorld>(size);
  std::unique_ptr<PooledWorld> world = std::move(unused.back());
  unused.pop_back();
  return world;
}

void IslandSolver::give_back(std::unique_ptr<PooledWorld> world) {
  const std::lock_guard lock(mutex_);
  pool_[world->bodies.size()].push_back(std::move(world));
}

IslandSolver::IslandSolver() = default;
IslandSolver::~IslandSolver() = default;

IslandSolution IslandSolver::velocities(const IslandProblem& problem) {
  open_ode();
  std::unique_ptr<PooledWorld> pooled = take(problem.bodies.size());
  const std::size_t most = problem.rows.empty() ? kMostDirectContacts : kMostDirectWithRows;
  IslandSolution result = solve(pooled->world.get(), pooled->contact_joints.get(), pooled->bodies,
                                problem, problem.contacts.size() <= most);
  give_back(std::move(pooled));
  return result;
}

}  // namespace engine

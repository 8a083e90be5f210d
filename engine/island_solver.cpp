#include "engine/island_solver.h"

#include <ode/ode.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <map>

#include "engine/constants.h"
namespace engine {
namespace {

dContact in_odes_words(const Contact& contact) {
  const ContactPoint& point = contact.point;
  dContact words{};
  Eigen::Map<Eigen::Vector3d>(words.geom.pos) = point.position_W;
  Eigen::Map<Eigen::Vector3d>(words.geom.normal) = point.normal_W;
  words.geom.depth = point.depth;
  words.surface.mode = dContactSoftERP | dContactSoftCFM | dContactMotionN | dContactSlip1 |
                       dContactSlip2 | dContactApprox1;
  words.surface.mu = kFriction;
  words.surface.soft_erp = contact.stiffness.erp;
  words.surface.soft_cfm = contact.stiffness.cfm;
  words.surface.motionN = contact.stiffness.speed;
  words.surface.slip1 = words.surface.slip2 = contact.stiffness.slip;

  const Eigen::Vector3d& velocity = contact.sliding_W;
  const Eigen::Vector3d sliding = velocity - velocity.dot(point.normal_W) * point.normal_W;
  if (sliding.norm() > 1e-9 * velocity.norm()) {
    words.surface.mode |= dContactFDir1;
    Eigen::Map<Eigen::Vector3d>(words.fdir1) = sliding.normalized();
  }
  return words;
}

}  // namespace

void add_contact(dxWorld* world, dxJointGroup* group, const Contact& contact, dxBody* first,
                 dxBody* second) {
  const dContact words = in_odes_words(contact);
  dJointAttach(dJointCreateContact(world, group, &words), first, second);
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
  dMass words;
  dMassSetParameters(&words, mass, 0, 0, 0, inertia_B(0, 0), inertia_B(1, 1), inertia_B(2, 2),
                     inertia_B(0, 1), inertia_B(0, 2), inertia_B(1, 2));
  dBodySetMass(body, &words);
}

void hand_over(dxBody* body, const SolverBody& as, double unit) {
  const Eigen::Vector3d force = unit * as.load.force;
  const Eigen::Vector3d moment = unit * as.load.moment;
  place(body, as.state);
  set_mass(body, unit * as.mass, unit * as.inertia_B);
  dBodySetForce(body, force.x(), force.y(), force.z());
  dBodySetTorque(body, moment.x(), moment.y(), moment.z());
  dBodyEnable(body);
}

void step_by_iteration(dxWorld* world, int iterations, double step) {
  static std::mutex one_sequence;  // ODE has one random sequence for all.
  const std::lock_guard lock(one_sequence);
  dWorldSetQuickStepNumIterations(world, iterations);
  dRandSetSeed(1);
  if (!dWorldQuickStep(world, step)) throw OdeFault("ODE: no memory for the step");
}

bool step_or_fall_back(dxWorld* world, const std::function<void()>& again, double step) {
  take_ode_warning();  // one that a collision left says nothing about the step
  if (!dWorldStep(world, step)) throw OdeFault("ODE: no memory for the step");
  if (take_ode_warning().empty()) return false;
  again();
  step_by_iteration(world, kFallbackIterations, step);
  return true;
}

/// A world with so many bodies, all disabled between two calls.
class IslandSolver::PooledWorld {
 public:
  explicit PooledWorld(std::size_t bodies)
      : threading_(dThreadingAllocateSelfThreadedImplementation()),
        world_(dWorldCreate()),
        group_(dJointGroupCreate(0)) {
    // The one that worlds share by default is not for several threads.
    dWorldSetStepThreadingImplementation(
        world_.get(), dThreadingImplementationGetFunctions(threading_.get()), threading_.get());
    for (std::size_t i = 0; i < bodies; ++i) {
      bodies_.push_back(dBodyCreate(world_.get()));
      dBodySetGyroscopicMode(bodies_.back(), 0);
      dBodyDisable(bodies_.back());
    }
  }

  std::size_t size() const { return bodies_.size(); }

  /// @param fell_back   Set where the exact solver gave up.
  std::vector<hydro::Twist> velocities(double unit, const std::vector<SolverBody>& bodies,
                                       const std::vector<Contact>& contacts, double step,
                                       bool& fell_back) {
    const auto ready = [&] {
      for (std::size_t i = 0; i < bodies.size(); ++i) hand_over(bodies_[i], bodies[i], unit);
    };
    ready();
    join(bodies, contacts);
    if (contacts.size() > kMostDirectContacts)
      step_by_iteration(world_.get(), kHeapIterations, step);
    else
      fell_back = step_or_fall_back(world_.get(), ready, step);
    dJointGroupEmpty(group_.get());
    std::vector<hydro::Twist> velocities;
    velocities.reserve(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      velocities.push_back({vector_from_ode(dBodyGetLinearVel(bodies_[i])),
                            vector_from_ode(dBodyGetAngularVel(bodies_[i]))});
      dBodyDisable(bodies_[i]);
    }
    return velocities;
  }

 private:
  void join(const std::vector<SolverBody>& bodies, const std::vector<Contact>& contacts) {
    const auto handle = [&](BodyId id) -> dxBody* {
      const auto place = std::lower_bound(bodies.begin(), bodies.end(), id,
                                          [](const SolverBody& b, BodyId i) { return b.body < i; });
      if (place == bodies.end() || place->body != id) return nullptr;
      return bodies_[static_cast<std::size_t>(place - bodies.begin())];
    };
    for (const Contact& contact : contacts)
      add_contact(world_.get(), group_.get(), contact, handle(contact.pair.first),
                  handle(contact.pair.second));
  }

  ThreadingHandle threading_;
  WorldHandle world_;
  JointGroupHandle group_;  ///< Goes before the world.
  std::vector<dxBody*> bodies_;
};

/// The rooms that are free, by size.
class IslandSolver::WorldPool {
 public:
  std::unique_ptr<PooledWorld> take(std::size_t bodies) {
    const std::size_t size = std::bit_ceil(bodies);
    {
      const std::lock_guard lock(mutex_);
      std::vector<std::unique_ptr<PooledWorld>>& free = free_[size];
      if (!free.empty()) {
        std::unique_ptr<PooledWorld> room = std::move(free.back());
        free.pop_back();
        return room;
      }
    }
    return std::make_unique<PooledWorld>(size);
  }
  void give_back(std::unique_ptr<PooledWorld> room) {
    const std::lock_guard lock(mutex_);
    free_[room->size()].push_back(std::move(room));
  }
  void note_fallback() { ++fallback_steps_; }
  long fallback_steps() const { return fallback_steps_; }

 private:
  std::mutex mutex_;
  std::map<std::size_t, std::vector<std::unique_ptr<PooledWorld>>> free_;
  std::atomic<long> fallback_steps_ = 0;
};

IslandSolver::IslandSolver() : rooms_(std::make_unique<WorldPool>()) {}
IslandSolver::~IslandSolver() = default;
IslandSolver::IslandSolver(IslandSolver&&) noexcept = default;

std::vector<hydro::Twist> IslandSolver::velocities(double unit,
                                                   const std::vector<SolverBody>& bodies,
                                                   const std::vector<Contact>& contacts,
                                                   double step) {
  open_ode();
  std::unique_ptr<PooledWorld> room = rooms_->take(bodies.size());
  bool fell_back = false;
  std::vector<hydro::Twist> result = room->velocities(unit, bodies, contacts, step, fell_back);
  if (fell_back) rooms_->note_fallback();
  rooms_->give_back(std::move(room));
  return result;
}

long IslandSolver::fallback_steps() const { return rooms_->fallback_steps(); }

}  // namespace engine

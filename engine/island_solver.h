#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/broad_phase.h"
#include "engine/contacts.h"
#include "engine/ode_handles.h"
#include "engine/spec.h"
#include "hydro/spatial.h"

/// @file
/// Solves islands of bodies that only contacts constrain, in pooled ODE worlds.
///
/// A step of ODE's visits all bodies and joints of its world, enabled or not. To solve islands of a
/// few bodies one after the other in the world of all bodies would take a time that grows with the
/// square of their number. So each is solved in a world with room for little more than its own
/// bodies, several at once on several threads.

namespace engine {

/// A body for the constraint solver: moment and velocities are about the centre of mass.
struct SolverBody {
  BodyId body = 0;
  hydro::BodyState state;
  double mass = 0;
  Eigen::Matrix3d inertia_B = Eigen::Matrix3d::Identity();
  hydro::Wrench load;  ///< In W.
};

/// A point of a contact for the constraint solver.
struct Contact {
  Pair pair;
  ContactPoint point;
  ContactStiffness stiffness;
  Eigen::Vector3d sliding_W = Eigen::Vector3d::Zero();  ///< Relative velocity without it [m/s].
};

/// Joins two bodies by a contact; null stands for what does not move.
void add_contact(dxWorld* world, dxJointGroup* group, const Contact& contact, dxBody* first,
                 dxBody* second);

/// Puts an ODE body in a state.
void place(dxBody* body, const hydro::BodyState& state);

/// Sets the mass of an ODE body, and its inertia in B about the centre of mass.
void set_mass(dxBody* body, double mass, const Eigen::Matrix3d& inertia_B);

/// Enables an ODE body with the state, mass and load of a solver body; masses, moments and loads
/// are multiplied with `unit`.
void prepare(dxBody* body, const SolverBody& as, double unit);

/// Takes a step of an ODE world by the exact solver. Where constraints contradict each other, it
/// gives up, and the iterative solver finds a compromise.
/// @param restart   Makes the bodies ready for the step once more.
/// @return true for a compromise.
/// @throws OdeFault
bool step_or_fall_back(dxWorld* world, const std::function<void()>& restart, double step);

class IslandSolver {
 public:
  IslandSolver();
  ~IslandSolver();
  IslandSolver(IslandSolver&&) noexcept;

  /// The velocities in W that the bodies of an island have after `step` [s] under their loads and
  /// contacts, each of which has one of them at least; its other party does not move if it is not
  /// among them. Several threads may call this at once.
  /// @param unit     Factor of masses, moments and loads in the solver.
  /// @param bodies   Ascending.
  /// @throws OdeFault
  std::vector<hydro::Twist> velocities(double unit, const std::vector<SolverBody>& bodies,
                                       const std::vector<Contact>& contacts, double step);

 private:
  class PooledWorld;
  class WorldPool;
  std::unique_ptr<WorldPool> pool_;
};

}  // namespace engine

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
/// Bodies that only contacts hold, in ODE worlds of their own.
///
/// A step of ODE's walks over all bodies and joints of its world, be they awake or not: islands of
/// a few bodies each, solved one after the other in the world of all bodies, would take a time that
/// grows with the square of their number. Here each is solved in a world with room for little more
/// than its own, several at once on several threads.

namespace engine {

/// A body as the constraint solver is to take it, moment and velocities about the centre of mass.
struct SolverBody {
  BodyId body = 0;
  hydro::BodyState state;
  double mass = 0;
  Eigen::Matrix3d inertia_B = Eigen::Matrix3d::Identity();
  hydro::Wrench load;  ///< In W.
};

/// A point of a contact as the constraint solver is to take it.
struct Contact {
  Pair pair;
  ContactPoint point;
  ContactStiffness stiffness;
  Eigen::Vector3d sliding_W = Eigen::Vector3d::Zero();  ///< As it would be without it [m/s].
};

/// Joins two bodies by a contact; none for what does not move.
void add_contact(dxWorld* world, dxJointGroup* group, const Contact& contact, dxBody* first,
                 dxBody* second);

/// Puts an ODE body in a state.
void place(dxBody* body, const hydro::BodyState& state);

/// Gives an ODE body its mass, the inertia in B about the centre of mass.
void set_mass(dxBody* body, double mass, const Eigen::Matrix3d& inertia_B);

/// Hands an ODE body over to the solver, masses, moments and loads multiplied with `unit`.
void hand_over(dxBody* body, const SolverBody& as, double unit);

/// A step of an ODE world by the iterative solver, which takes constraints in a random order that
/// is always the same. Of several threads one after the other is answered.
/// @throws OdeFault
void step_by_iteration(dxWorld* world, int iterations, double step);

/// A step of an ODE world by the exact solver. Where constraints contradict each other and it gives
/// up, the iterative one gives the step a compromise between them.
/// @param again   Makes the bodies ready for the step once more.
/// @return true for a compromise.
/// @throws OdeFault
bool step_or_fall_back(dxWorld* world, const std::function<void()>& again, double step);

class IslandSolver {
 public:
  IslandSolver();
  ~IslandSolver();
  IslandSolver(IslandSolver&&) noexcept;

  /// The velocities in W, linear and angular, that these bodies have after `step` [s] under their
  /// loads and contacts, of which each is with one of them at least. May be called from several
  /// threads at once. What a contact is with beyond them does not move.
  /// @param unit     What masses, moments and loads are multiplied with.
  /// @param bodies   Ascending.
  /// @throws OdeFault
  std::vector<hydro::Twist> velocities(double unit, const std::vector<SolverBody>& bodies,
                                       const std::vector<Contact>& contacts, double step);

  /// Steps in which constraints contradicted each other and were each met in part.
  long fallback_steps() const;

 private:
  class PooledWorld;
  class WorldPool;
  std::unique_ptr<WorldPool> rooms_;
};

}  // namespace engine

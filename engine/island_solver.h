#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/broad_phase.h"
#include "engine/contacts.h"
#include "engine/force_row.h"
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

/// Takes a step of an ODE world by the exact solver. Where constraints contradict each other, it
/// gives up, and the iterative solver finds a compromise.
/// @param restart   Makes the bodies ready for the step once more.
/// @return true for a compromise.
/// @throws OdeFault
bool step_or_fall_back(dxWorld* world, const std::function<void()>& restart, double step);

/// An island for the constraint solver. Each contact has one of the bodies at least; its other
/// party does not move if it is not among them.
struct IslandProblem {
  const std::vector<SolverBody>& bodies;  ///< Ascending.
  const std::vector<Contact>& contacts;
  const std::vector<ForceRow>& rows;
  double step;      ///< Length of the substep [s].
  double unit = 1;  ///< Factor of masses, moments and loads in ODE.
};

/// The answer of the constraint solver.
struct IslandSolution {
  std::vector<hydro::Twist> velocities;  ///< Of the bodies after the substep, in W.
  std::vector<double> forces;            ///< λ of the rows.
};

/// The motion of the bodies after the substep under their loads and constraints.
/// They are enabled for that in the ODE world, where their states are undefined afterwards.
/// @param handles   Of the bodies.
/// @param exact     False: the iterative solver is used, as for heaps.
/// @throws OdeFault
IslandSolution solve(dxWorld* world, dxJointGroup* contact_joints,
                     const std::vector<dxBody*>& handles, const IslandProblem& problem, bool exact);

class IslandSolver {
 public:
  IslandSolver();
  ~IslandSolver();

  /// Solves an island without joints and locks. Several threads may call this at once.
  /// @throws OdeFault
  IslandSolution velocities(const IslandProblem& problem);

 private:
  struct PooledWorld;
  std::unique_ptr<PooledWorld> take(std::size_t bodies);
  void give_back(std::unique_ptr<PooledWorld> world);

  std::mutex mutex_;
  std::map<std::size_t, std::vector<std::unique_ptr<PooledWorld>>> pool_;  ///< Unused ones by size.
};

}  // namespace engine

#pragma once

#include <vector>

#include "engine/parallel_for.h"
#include "engine/processing_correction.h"
#include "engine/rig.h"
#include "engine/velocity_update.h"
#include "engine/world.h"

/// @file
/// One substep of an island: half a drift, an update of the velocities, half a drift.
///
/// An island is a free body, or the bodies that joints, contacts and lines connect in this substep.
/// Bodies that loads of lines alone connect, and free ones, solve S Δu = h F each for itself, with
/// locks and a reduced joint as projections (E5, E6); the others solve S Δu = h (F + R) with the
/// reactions R of joints, contacts and rows (E7). In both, the
/// added mass at the end is that of the expected pose; the update is repeated with that of the pose
/// that it leads to until both agree.

namespace engine {

/// What all substeps of a simulation have in common.
struct StepContext {
  World& world;
  Rig& rig;
  std::vector<MovingBody>& bodies;
  double gravity = 0;  ///< [m/s^2]
  ParallelFor parallel_for;
  bool collides = true;  ///< False: nothing in the scene can touch.
  double tolerance = 0;  ///< As Integrator::tolerance.
};

/// A body in a substep.
struct SubstepBody {
  BodyId id = 0;
  MovingBody* moving = nullptr;
  bool touching = false;  ///< A contact acts on it.

  hydro::BodyState start;  ///< State that is moved on, with its correction (E9).
  std::optional<ProcessingCorrection> correction;  ///< Of a free body.
  Motion halfway;                                  ///< After half a drift, before the update.
  std::optional<Matrix6d> rig_inertia;             ///< What (E24) adds to S, in W.
  Matrix6d added_B = Matrix6d::Zero();             ///< A at the end that the update is taken with.
  hydro::BodyState added_at;                       ///< The pose that it is that of.
  MidpointState midpoint;                          ///< Of `halfway`.
  VelocityUpdate update;                           ///< By loads and reactions.
  Vector6d predicted = Vector6d::Zero();           ///< Δu to linearise the loads about, in W.
  Vector6d reaction_B = Vector6d::Zero();          ///< R of joints and contacts, in B.
  std::optional<Eigen::Vector3d> load_acceleration_W;  ///< As that of Motion.
  Motion end;                                          ///< The result.
  double reaction_work = 0;                            ///< Work of R over the substep [J].
  double row_work = 0;                                 ///< That of rows, a part of it [J].
  double inflow_work = 0;  ///< Energy that water has brought into its pockets [J].
  bool abrupt = false;     ///< Loads changed by much on the way: the substep is to be judged.

  const Body& body() const { return moving->body; }
};

struct Island {
  std::vector<SubstepBody*> bodies;  ///< Ascending ids.
  std::vector<Contact> contacts;
  std::vector<ForceRow> rows;            ///< Of lines and drives.
  std::vector<JointReaction> reactions;  ///< Of joints.
  bool constrained =
      true;  ///< False: there are no contacts, rows, and joints that are not reduced.
};

/// Drifts the body to the middle of a substep of length h [s], where contacts are looked for.
void drift_halfway(SubstepBody& member, double time, double h);

/// Finds the motion of each body of the island at the end of the substep; moves none.
/// A constrained island must have been drifted halfway.
/// @param time   At the start of the substep [s].
/// @throws MotionFault, OdeFault
void take_substep(const StepContext& context, Island& island, double time, double h);

}  // namespace engine

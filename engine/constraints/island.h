#pragma once

#include <optional>
#include <vector>

#include "engine/constraints/force_row.h"
#include "engine/constraints/joint_reaction.h"
#include "engine/contacts/contacts.h"
#include "engine/motion/processing_correction.h"
#include "engine/motion/velocity_update.h"

/// @file
/// Bodies in a substep, and the islands that joints, contacts and lines make of them.

namespace engine {

/// A body in a substep.
struct SubstepBody {
  BodyId id = 0;
  MovingBody* moving = nullptr;
  bool touching = false;  ///< A contact acts on it.

  hydro::BodyState start;  ///< State that is moved on, with its correction (E9).
  std::optional<ProcessingCorrection> correction;  ///< Only for a free body.
  Motion halfway;                                  ///< After half a drift, before the update.
  std::optional<Matrix6d> rig_inertia;             ///< Term that (E24) adds to S, in W.
  Matrix6d added_B = Matrix6d::Zero();             ///< A at the end that the update is taken with.
  hydro::BodyState added_at;                       ///< The pose that it is that of.
  MidpointState midpoint;                          ///< Midpoint that belongs to `halfway`.
  VelocityUpdate update;                           ///< By loads and reactions.
  Vector6d predicted = Vector6d::Zero();           ///< Δu to linearise the loads about, in W.
  Vector6d reaction_B = Vector6d::Zero();          ///< R of joints and contacts, in B.
  std::optional<Eigen::Vector3d> load_acceleration_W;  ///< As that of Motion.
  Motion end;                                          ///< The result.
  double row_work = 0;                                 ///< Work of rows over the substep [J].
  double inflow_work = 0;           ///< Energy that water has brought into its pockets [J].
  bool needs_energy_check = false;  ///< Loads changed by much on the way.

  const Body& body() const { return moving->body; }
};

struct Island {
  std::vector<SubstepBody*> bodies;  ///< Ascending ids.
  std::vector<Contact> contacts;
  std::vector<ForceRow> rows;            ///< Rows of lines and drives.
  std::vector<JointReaction> reactions;  ///< Reactions of joints.
  bool constrained =
      true;  ///< False: there are no contacts, rows, and joints that are not reduced.
};

}  // namespace engine

#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "engine/base/spec.h"
#include "engine/contacts/broad_phase.h"
#include "hydro/statics/equilibrium.h"

/// @file
/// Bodies that fixed joints hold together, as one body that floats.
///
/// Frames   W  world.   B  of a body.   G  of a group: origin at the centre of mass of all its
///          bodies, axes of one of them, which leads.

namespace assembly {

/// Bodies that fixed joints hold together.
struct RigidGroup {
  std::vector<engine::BodyId> bodies;  ///< Ascending.
  std::string joint_to_world;          ///< A fixed joint to the world; empty if there is none.
};

/// Bodies 0 … count − 1 in groups that pairs connect, in the order of their first bodies. A body
/// without a pair is a group of its own; one of a pair with the world is not connected by it.
std::vector<std::vector<engine::BodyId>> groups_by(std::vector<engine::Pair> pairs,
                                                   std::size_t count);

/// Poses of the bodies of a group at the start in the frame of one of them, which leads.
std::vector<Eigen::Isometry3d> poses_in_lead(const std::vector<engine::BodySpec>& bodies,
                                             const RigidGroup& group, engine::BodyId lead);

/// Returns the groups in the order of their first bodies. A body without a fixed joint is a group
/// of its own.
std::vector<RigidGroup> rigid_groups(const engine::SimulationSpec& spec);

/// A group of bodies as one.
struct FloatingGroup {
  double mass = 0;                      ///< Without the water inside [kg].
  hydro::TriMesh mesh_G;                ///< The closed surfaces of all bodies with buoyancy.
  std::vector<hydro::Tank> tanks;       ///< The water in their pockets.
  std::vector<Eigen::Isometry3d> X_GB;  ///< In the order of the group's bodies.
};

/// Joins the bodies of a group in their poses at the start. A group of one body has the numbers of
/// that body to the last bit.
/// @param lead   Body of the group whose axes G has.
FloatingGroup floating_group(const engine::SimulationSpec& spec, const RigidGroup& group,
                             engine::BodyId lead);

/// True if the water carries a body.
bool has_buoyancy(const engine::BodySpec& body);

}  // namespace assembly

#pragma once

#include "engine/motion/moving_body.h"

/// @file
/// The energy of bodies in still water.
///
/// E = ½ u·(M + A) u + m g z + U, with u the velocity relative to the water, z the height of the
/// centre of mass and U the work done against buoyancy (buoyancy_energy.h). In water that stands
/// still, level or under a height field, drag takes from E, and so does added mass, which leaves
/// some energy in the water; so does calm air. Lift and applied loads may add to it by their work.

namespace engine {

/// ½ u·(M + A) u with the added mass of the motion and u relative to a frame of this velocity [J].
double kinetic_energy(const Body& body, const Motion& motion, const Eigen::Vector3d& frame);

/// m g z + U, and that of the water in its pockets [J]
double potential_energy(const Body& body, const Motion& motion);

/// True if the loads that may add to the body's energy are known: water and air stand still, or
/// carry along, at one velocity, a body without locks and joints.
bool must_not_gain_energy(const Body& body);

}  // namespace engine

#pragma once

#include "engine/base/spec.h"

/// @file
/// Locked degrees of freedom, in world axes.
///
/// A locked translation keeps the coordinate of the centre of mass and its velocity at zero. A
/// locked rotation keeps that component of the angular velocity at zero; with two of them the body
/// turns about the third world axis alone, with all three not at all. One locked rotation is a
/// condition on the velocity only: turns about the other two axes can add up to one about the
/// third.

namespace engine {

/// True if all six are locked: the body is immovable.
bool immovable(const DofMask& locked);

/// True if at least one is locked.
bool partly_locked(const DofMask& locked);

/// The part of a turn about the unit vector `axis`: its twist, in a decomposition into swing and
/// twist.
Eigen::Quaterniond twist(const Eigen::Quaterniond& turn, const Eigen::Vector3d& axis);

/// The state without velocity in locked degrees of freedom.
hydro::BodyState without_locked_motion(const DofMask& locked, hydro::BodyState state);

/// The nearest state that the locks of a body allow which started as `initial`: locked coordinates
/// are exactly those of `initial`, locked velocities zero.
hydro::BodyState project_onto_locks(const DofMask& locked, const hydro::BodyState& initial,
                                    hydro::BodyState state);

}  // namespace engine

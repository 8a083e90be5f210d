#pragma once

#include <optional>
#include <vector>

#include "engine/base/spec.h"

/// @file
/// The states of rest in still water of bodies that something holds.
///
/// Joints with their springs and stops, lines, locks and constant loads hold a body in an attitude
/// that it would not have alone: a flap on a hinge stands, a moored float lies deeper. The pose of
/// rest is found by the engine itself, from the pose of the start: the bodies move through still
/// water without drag, and whenever their kinetic energy begins to fall they are stopped (kinetic
/// damping, Cundall 1976). So a hinge, a rope or a stop is here what it is in the run.

namespace assembly {

/// Bodies that joints or lines connect with each other.
struct HeldGroup {
  std::vector<engine::BodyId> bodies;  ///< Ascending.
  /// Holder of the body, as a fault names it: a joint, a line, a lock or a load; empty: the water
  /// alone.
  std::string holder;
};

/// The groups in the order of their first bodies. Fixed joints between bodies alone hold nothing.
std::vector<HeldGroup> held_groups(const engine::SimulationSpec& spec);

/// A group at rest.
struct Rest {
  /// All bodies', in the order of the specification; outside the group those of the start.
  std::vector<hydro::BodyState> states;
  std::vector<double> coordinates;  ///< q of all joints, from the start [rad, m].
};

/// Finds the rest of a group. None where the group does not come to rest within 20,000
/// steps of a tenth of its own time √(radius/g), or moves by more than ten of its radii: nothing
/// near holds it.
std::optional<Rest> find_rest(const engine::SimulationSpec& spec, const HeldGroup& group);

}  // namespace assembly

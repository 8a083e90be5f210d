#pragma once

#include "engine/body.h"

/// @file
/// The energy of bodies in still water.
///
/// E = ½ u·(M + A) u + m g z + U, with u the velocity relative to the water, z the height of the
/// centre of mass and U the work done against buoyancy (hydro/buoyancy_energy.h). Without applied
/// loads and lift, in water with a level surface that does not rise, no load adds to E: drag, and
/// what the added mass leaves in the water, take from it. (Lift pushes inward on a whole body and
/// can do either.)

namespace engine {

/// ½ u·(M + A) u with the added mass in force [J].
double kinetic_energy(const Body& body, const Surroundings& around, const Motion& motion);
/// m g z + U [J]
double potential_energy(const Body& body, const Surroundings& around,
                        const hydro::BodyState& state);
/// E of a body with the added mass in force [J].
double energy(const Body& body, const Surroundings& around, const Motion& motion);

/// True if nothing but its own motion can add to a body's energy.
bool must_not_gain_energy(const Body& body, const Surroundings& around);

/// E of all bodies in the given states, each with the added mass of its pose [J]. For still water.
double total_energy(const SimulationSpec& spec, const std::vector<hydro::BodyState>& states);

}  // namespace engine

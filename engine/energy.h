#pragma once

#include "engine/body.h"

/// @file
/// The energy of bodies in still water.
///
/// E = ½ u·(M + A) u + m g z + U, with u the velocity relative to the water, z the height of the
/// centre of mass and U the work done against buoyancy (hydro/statics/buoyancy_energy.h). In water
/// with a level surface that does not rise, no load adds to E: drag, and what the added mass leaves
/// in the water, take from it. Lift pushes inward on a whole body and can do either; its work and
/// that of applied loads is counted.

namespace engine {

/// ½ u·(M + A) u with the added mass in force [J].
double kinetic_energy(const Body& body, const Surroundings& around, const Motion& motion);
/// m g z + U [J]
double potential_energy(const Body& body, const Surroundings& around,
                        const hydro::BodyState& state);
/// E of a body with the added mass in force [J].
double energy(const Body& body, const Surroundings& around, const Motion& motion);

/// Energy below which a change is round-off of larger ones: 1e-9 of the weights of the body and of
/// the water in its place times its size [J].
double least_energy_scale(const Body& body, const Surroundings& around);

/// True if the water stands still, or carries a body along that nothing holds: what adds to its
/// energy is known.
bool must_not_gain_energy(const Body& body, const Surroundings& around);

/// True if lift or applied loads can add to it: then no earlier energy bounds the present one.
bool is_driven(const Body& body);

/// What lift and applied loads, as they were last found, may have added to a body's energy on its
/// way between two states a time h [s] apart; 0 if they took from it [J].
double work_done(const Body& body, const Surroundings& around, const hydro::BodyState& before,
                 const hydro::BodyState& after, double h);

/// E of all bodies in the given states, each with the added mass of its pose [J]. For still water.
double total_energy(const SimulationSpec& spec, const std::vector<hydro::BodyState>& states);

}  // namespace engine

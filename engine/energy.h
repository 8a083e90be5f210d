#pragma once

#include "engine/moving_body.h"

/// @file
/// The energy of bodies in still water.
///
/// E = ½ u·(M + A) u + m g z + U, with u the velocity relative to the water, z the height of the
/// centre of mass and U the work done against buoyancy (buoyancy_energy.h). In water with a level
/// surface that does not rise no load adds to E: drag takes from it, and so does added mass, which
/// leaves some in the water. Lift may do either; its work and that of applied loads is counted.

namespace engine {

/// ½ u·(M + A) u with the added mass of the motion [J].
double kinetic_energy(const Body& body, const Environment& environment, const Motion& motion);

/// m g z + U [J]
double potential_energy(const Body& body, const Environment& environment,
                        const hydro::BodyState& state);

/// Energy whose changes are round-off: 1e-9 of the weights of the body and of the water in its
/// place, times its size [J].
double least_energy_scale(const Body& body, const Environment& environment);

/// True if everything that adds to the body's energy is known: the water stands still, or carries
/// along a body that nothing holds.
bool must_not_gain_energy(const Body& body, const Environment& environment);

/// True if lift or applied loads may add to the energy: no earlier energy then bounds the present.
bool is_driven(const MovingBody& moving);

/// Largest work that lift and applied loads, as they were last found, may have done between two
/// states a time h [s] apart; 0 if they took energy [J].
double work_done(const MovingBody& moving, const Environment& environment,
                 const hydro::BodyState& before, const hydro::BodyState& after, double h);

}  // namespace engine

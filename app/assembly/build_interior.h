#pragma once

#include <string>
#include <vector>

#include "app/assembly/build_shape.h"
#include "engine/base/spec.h"
#include "hydro/statics/equilibrium.h"

namespace assembly {

/// Sets the interior of a body whose mesh and orientation at the start are there: how it is filled,
/// and the mesh that the sea outside sees. Costs nothing but a test for a convex body.
void build_interior(const scene::Body& body, engine::BodySpec& spec);

/// Puts water, openings and pumps into a body in its pose at time 0. Faults go to the log: water
/// where there is no pocket or more than it holds, an opening far from a wall or with the sea on
/// both sides, a pump of no pocket.
/// @param com_M   Centre of mass in the mesh frame.
void fill_interior(const scene::Body& body, const Eigen::Vector3d& com_M,
                   const std::string& key_path, engine::BodySpec& spec, BuildLog& log);

/// Warns of bodies whose hollows have a rim under water at the start, through which they fill.
std::vector<std::string> interior_warnings(const engine::SimulationSpec& spec);

/// Mass of the water in a body at the start [kg]. @param density   Density of the water [kg/m^3].
double mass_of_water_in(const engine::BodySpec& spec, double density);
/// The same with the mass of the body.
double mass_afloat(const engine::BodySpec& spec, double density);

/// The water in a body as tanks, for its equilibrium. Water that is given by its level has the
/// volume that it has in the attitude of `spec`.
std::vector<hydro::Tank> tanks_of(const engine::BodySpec& spec);

}  // namespace assembly

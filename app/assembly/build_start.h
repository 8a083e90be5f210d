#pragma once

#include <vector>

#include "app/assembly/build_shape.h"
#include "engine/base/spec.h"

namespace assembly {

/// Puts bodies with `start: equilibrium` afloat at rest, together with those that fixed joints hold
/// to them: from its given orientation the body settles in still water at the scene's level, as one
/// with the others, and is then turned back to its heading. The origin of its mesh frame keeps x
/// and y of `position`. A body that does not float is a fault, and so is a second body of a group
/// with the key `start`. Bodies that a lock or a joint to the world holds stay where they are.
/// @param spec   Its bodies and joints must be set; the function changes states at the start.
void put_afloat(const std::vector<Eigen::Vector3d>& centers_of_mass, engine::SimulationSpec& spec,
                BuildLog& log);

/// Moves bodies with `start: equilibrium` that something else than the water holds to their rest,
/// with all bodies that joints and lines connect to them (rest_states.h). A body that does not come
/// to rest is a fault.
/// @param spec   With its rig.
void put_to_rest(engine::SimulationSpec& spec, BuildLog& log);

/// Turns bodies with `heel` from there, together with those that fixed joints hold to them.
void heel_over(engine::SimulationSpec& spec, BuildLog& log);

/// Returns for each body whether `start: equilibrium`, its own or that of a body fixed to it, gives
/// its pose.
std::vector<bool> starts_afloat(const scene::Scene& scene, const engine::SimulationSpec& spec);

/// Mass of a body afloat [kg].
struct MassAfloat {
  double body = 0;
  double water = 0;  ///< The water inside.

  double sum() const { return body + water; }
};

/// Explains why a body of this mass does not float in water of this density; empty if it floats.
/// @param volume   Volume of the body [m^3].
std::string why_not_afloat(const MassAfloat& mass, double volume, double density);

}  // namespace assembly

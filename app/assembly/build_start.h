#pragma once

#include "app/assembly/build_shape.h"
#include "engine/spec.h"

namespace assembly {

/// Puts a body afloat at rest (`start: equilibrium`): from its given orientation it settles in
/// still water at the scene's level and is then turned back to its heading. The mesh frame's origin
/// keeps x and y of `position`. A body that does not float is a fault.
/// @param body   Mass, mesh and orientation must be set; the function completes its state.
void put_afloat(const Eigen::Vector3d& position, const Eigen::Vector3d& com_M,
                const std::string& key_path, engine::BodySpec& body, BuildLog& log);

/// Explains why a body of this mass does not float in water of this density; empty if it floats.
/// @param volume   Volume of the body [m^3].
std::string why_not_afloat(double mass, double volume, double density);

}  // namespace assembly

#pragma once

#include "app/assembly/build_shape.h"
#include "engine/spec.h"

namespace assembly {

/// Puts a body afloat at rest (`start: equilibrium`): its orientation becomes that of the
/// equilibrium that its own leads to in still water at the scene's level, turned back to its
/// heading; the height follows, and x and y of the mesh frame's origin are those of `position`. A
/// body that does not float is a fault.
/// @param body   Mass, mesh and orientation are set; its state is completed.
void put_afloat(const Eigen::Vector3d& position, const Eigen::Vector3d& com_M,
                const std::string& key_path, engine::BodySpec& body, BuildLog& log);

/// Why a body of this mass does not float in water of this density; empty if it does.
/// @param volume   Of the body [m^3].
std::string why_not_afloat(double mass, double volume, double density);

}  // namespace assembly

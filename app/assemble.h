#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "engine/spec.h"

namespace app {

/// A scene with its meshes loaded and all that follows from them: ready to be simulated.
struct Assembly {
  engine::SimulationSpec spec;
  std::vector<Eigen::Vector3d> centers_of_mass;  ///< Per body, in the mesh frame [m].
  std::vector<std::string> notes;  ///< What the user should know: a mesh was turned outward, ….
};

/// Loads the meshes and height fields a scene names, checks them, and finds masses, centres of mass
/// and inertias.
/// @throws InputError with every fault found, at the place of its key in the scene.
Assembly assemble(const Scene& scene);

}  // namespace app

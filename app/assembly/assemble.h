#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/assembly/added_mass_store.h"
#include "app/scene/scene.h"
#include "engine/spec.h"
#include "hydro/added_mass/surface_added_mass.h"

namespace app {

/// A closed mesh about the centroid of its volume, wherever the body's centre of mass is: bodies
/// that differ in that share a solution.
struct CenteredMesh {
  hydro::TriMesh mesh_C;
  Eigen::Vector3d com_C = Eigen::Vector3d::Zero();  ///< The body's centre of mass [m].
};

/// The added mass that a body has, and where it came from.
struct AddedMassReport {
  AddedMassScene::Model model = AddedMassScene::Model::deep;
  /// Of the wholly submerged body, about its centre of mass, body axes [kg, kg m, kg m^2].
  hydro::Matrix6d matrix = hydro::Matrix6d::Zero();
  std::optional<StoredAddedMass> stored;                   ///< Of `deep`: what it was solved from.
  std::shared_ptr<const hydro::SurfaceAddedMass> surface;  ///< Of `surface`.
};

/// A scene with its meshes loaded and all that follows from them: ready to be simulated.
struct Assembly {
  engine::SimulationSpec spec;
  std::vector<Eigen::Vector3d> centers_of_mass;  ///< Per body, in the mesh frame [m].
  /// Per body what its added mass is of; without vertices if its mesh is no solid.
  std::vector<CenteredMesh> solids;
  /// Per body, once `add_added_mass` was called; none for a body without added mass.
  std::vector<std::optional<AddedMassReport>> added_mass;
  std::vector<std::string> notes;  ///< What the user should know: a mesh was turned outward, ….
};

/// Loads the meshes and height fields a scene names, checks them, and finds masses, centres of mass
/// and inertias. Bodies have no added mass yet: see assemble_added_mass.h.
/// @throws InputError with every fault found, at the place of its key in the scene.
Assembly assemble(const Scene& scene);

}  // namespace app

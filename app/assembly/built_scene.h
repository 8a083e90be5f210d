#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/assembly/added_mass_store.h"
#include "app/scene/scene.h"
#include "engine/spec.h"

namespace hydro {
class SurfaceAddedMass;
}

namespace assembly {

/// A closed mesh about the centroid of its volume, wherever the body's centre of mass is: bodies
/// that differ in that share a solution.
struct CenteredMesh {
  hydro::TriMesh mesh_C;
  Eigen::Vector3d com_C = Eigen::Vector3d::Zero();  ///< The body's centre of mass [m].
};

/// The added mass that a body has, and where it came from.
struct AddedMassReport {
  scene::AddedMass::Model model = scene::AddedMass::Model::deep;
  /// Of the wholly submerged body, about its centre of mass, body axes [kg, kg m, kg m^2].
  hydro::Matrix6d matrix = hydro::Matrix6d::Zero();
  std::optional<StoredAddedMass> stored;                   ///< Of `deep`: what it was solved from.
  std::shared_ptr<const hydro::SurfaceAddedMass> surface;  ///< Of `surface`.
};

/// A scene with its meshes loaded and all that follows from them, ready to be simulated.
struct BuiltScene {
  engine::SimulationSpec spec;
  std::vector<Eigen::Vector3d> centers_of_mass;  ///< Per body, in the mesh frame [m].
  /// Per body what its added mass is of; without vertices if its mesh is no solid.
  std::vector<CenteredMesh> solids;
  /// Per body; none for a body without added mass.
  std::vector<std::optional<AddedMassReport>> added_mass;
  double added_mass_seconds = 0;   ///< What it took to find the added mass [s].
  std::vector<std::string> notes;  ///< For the author: a mesh was turned outward, ….
};

}  // namespace assembly

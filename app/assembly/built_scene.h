#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/assembly/added_mass_store.h"
#include "app/assembly/mesh_frame.h"
#include "app/assembly/radiation_choice.h"
#include "app/assembly/radiation_store.h"
#include "app/scene/scene.h"
#include "engine/base/spec.h"
#include "hydro/measured_elevation.h"

/// @file
/// A scene ready to be simulated.

namespace hydro {
class SurfaceAddedMass;
class ThinShip;
}  // namespace hydro

namespace assembly {

/// A closed mesh with its origin at the centroid of its volume, so that bodies which differ only in
/// their centre of mass share a solution.
struct CenteredMesh {
  hydro::TriMesh mesh_C;                            ///< Closed and outward [m].
  Eigen::Vector3d com_C = Eigen::Vector3d::Zero();  ///< The body's centre of mass [m].
};

/// The added mass of a body and its origin.
struct AddedMassReport {
  /// `automatic` stands for that of the mean pose of a body with radiation.
  scene::AddedMass::Model model = scene::AddedMass::Model::deep;
  /// Added mass of the submerged body about its centre of mass, body axes [kg, kg m, kg m^2].
  hydro::Matrix6d matrix = hydro::Matrix6d::Zero();
  std::optional<StoredAddedMass> stored;                   ///< Solution of `deep`.
  std::shared_ptr<const hydro::SurfaceAddedMass> surface;  ///< Model of `surface`.
};

/// The waves that a body makes and scatters.
struct RadiationReport {
  RadiationChoice choice;  ///< Whether and how the body makes waves.
  /// None until it is solved, and for a body whose choice has a database.
  std::optional<StoredRadiation> stored;
  std::shared_ptr<const hydro::FloatingBody> model;  ///< None until it is solved.
  double sources_seconds = 0;  ///< Wall time of its sources in simulated water [s].
};

/// The resistance of a hull along its motion.
struct ResistanceReport {
  /// Where the force comes from.
  scene::Resistance::Source source = scene::Resistance::Source::none;
  hydro::MeanPose pose;  ///< At rest.
  double volume = 0;     ///< Volume that the body displaces there [m^3].
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();  ///< Centroid of that volume [m].
  /// The hull of the theory; null for a file, and for a body whose resistance another one of its
  /// hull has.
  std::shared_ptr<const hydro::ThinShip> ship;
  double seconds = 0;       ///< Wall time of the theory's solution [s].
  bool from_store = false;  ///< True if another process solved it.
};

/// Measures of irregular waves.
struct IrregularSea {
  double significant_height = 0;           ///< H_s [m].
  double peak_period = 0;                  ///< T_p [s].
  int waves = 0;                           ///< Number of waves that represent them.
  std::optional<hydro::ElevationFit> fit;  ///< Fit of waves to a measured elevation.
};

/// A scene ready to be simulated, with its meshes and everything derived from them.
struct BuiltScene {
  engine::SimulationSpec spec;                        ///< Input of engine::Simulation.
  std::vector<Eigen::Vector3d> centers_of_mass;       ///< Per body, in the mesh frame [m].
  std::vector<std::vector<MeshSource>> mesh_sources;  ///< Per body the files of its meshes.
  /// Per body the mesh of its added mass; without vertices if its mesh is no solid.
  std::vector<CenteredMesh> solids;
  /// Per body; none for a body without added mass.
  std::vector<std::optional<AddedMassReport>> added_mass;
  std::vector<RadiationReport> radiation;    ///< Per body.
  std::vector<ResistanceReport> resistance;  ///< Per body.
  /// Wall time of added mass, radiation and resistance [s].
  double added_mass_seconds = 0;
  std::optional<IrregularSea> irregular_sea;  ///< None without irregular waves.
  std::vector<std::string> notes;  ///< Notes for the author, for example on a reversed mesh.
  /// Advice on keys that cannot give what their author expects; see sea_warnings.h.
  std::vector<std::string> warnings;
};

}  // namespace assembly

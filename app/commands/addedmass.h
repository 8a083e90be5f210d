#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/scene/reader.h"
#include "hydro/added_mass/added_mass.h"

namespace app {

struct AddedMassCommand {
  std::filesystem::path file;     ///< A scene if its extension is .yaml or .yml, else a mesh.
  std::optional<double> density;  ///< Density of the water [kg/m^3]; none: the scene's, or 1000.
  std::vector<scene::Override> overrides;                   ///< Overrides of a scene.
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats of meshes that are read.
  scene::MeshFrame frame;                                   ///< Axes and unit of a mesh.
  hydro::AddedMassOptions options;
  bool store = true;  ///< Solutions are read from the store and written to it.
  bool json = false;
};

/// Prints the added mass of a mesh or of a scene's bodies, each submerged and alone.
/// @return the exit code
int addedmass(const AddedMassCommand& command);

}  // namespace app

#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <vector>

#include "app/scene/reader.h"

namespace app {

struct RadiationCommand {
  std::filesystem::path file;  ///< A scene if its extension is .yaml or .yml, else a mesh.
  double density = 1000;       ///< Density of the water about a mesh [kg/m^3].
  double depth = std::numeric_limits<double>::infinity();  ///< Depth of the water about a mesh [m].
  double relative_density = 0.5;  ///< Density of a mesh's uniform body over the water's [-].
  std::vector<scene::Override> overrides;  ///< Overrides of a scene.
  std::vector<double> frequencies;         ///< [rad/s]; empty: those that a run solves for.
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats of meshes that are read.
  scene::MeshFrame frame;                                   ///< Axes and unit of a mesh.
  bool store = true;  ///< Solutions are read from the store and written to it.
  bool json = false;
  bool csv = false;
  std::filesystem::path wamit;      ///< Stem of files .1, .3 and .hst; empty: none are written.
  std::filesystem::path capytaine;  ///< Dataset .nc that is written; empty: none.
  std::filesystem::path plot;       ///< Picture .svg that is written; empty: none.
};

/// Prints added mass, damping and the loads of waves on a floating mesh or a scene's bodies.
/// @return the exit code
int radiation(const RadiationCommand& command);

}  // namespace app

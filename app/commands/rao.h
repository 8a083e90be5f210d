#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene/reader.h"

namespace app {

struct RaoCommand {
  std::filesystem::path scene;
  std::vector<double> headings;  ///< Directions in which waves travel, ascending [deg].
  std::vector<double> periods;   ///< [s]
  std::string body;              ///< Name of the only body; empty: all that make waves.
  bool runs = false;             ///< Beside linear theory, runs are measured.
  double slope = 0.02;           ///< Amplitude times wave number of the waves of runs [-], > 0.
  std::vector<scene::Override> overrides;
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats of meshes that are read.
  bool store = true;  ///< Solutions are read from the store and written to it.
  bool json = false;
  bool csv = false;
  std::filesystem::path out;  ///< CSV that is written; empty: none.
};

/// Prints response amplitude operators of a scene's bodies by linear theory, and measured in runs.
/// @return the exit code
int rao(const RaoCommand& command);

}  // namespace app

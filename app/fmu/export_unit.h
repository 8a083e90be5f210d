#pragma once

#include <filesystem>

#include "app/fmu/packed_scene.h"

namespace fmu {

struct ExportOptions {
  SceneSource scene;
  std::filesystem::path out;  ///< File `.fmu`.
  bool quiet = false;
};

/// Writes a scene as a unit for co-simulation (FMI 3.0). @return the exit code
/// @throws scene::InputError, std::runtime_error for a file that cannot be written or is missing
int export_unit(const ExportOptions& options);

}  // namespace fmu

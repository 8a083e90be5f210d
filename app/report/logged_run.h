#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/assembly/built_scene.h"
#include "app/logs/force_log.h"
#include "app/logs/interior_csv.h"
#include "app/logs/table_log.h"
#include "app/logs/trajectory.h"
#include "app/scene/scene.h"

namespace app {

/// Files that a run left in its folder, and its scene, which is read again.
struct LoggedRun {
  std::filesystem::path path;
  nlohmann::ordered_json summary;  ///< Null if the run was killed before it wrote one.
  scene::Scene scene;              ///< The scene that was run.
  assembly::BuiltScene built;
  std::vector<std::string> overrides;  ///< Overrides of scene keys, as on the command line.
  Trajectory trajectory;
  std::size_t rows = 0;            ///< Rows per body that all logs have for all bodies.
  std::optional<ForceLog> forces;  ///< None if forces were not logged.
  InteriorLog interiors;           ///< Water in bodies with hollows.
  std::vector<TableRows> tables;   ///< Tables of the run's lines, joints, machines and controls.
};

/// @param scene   Present path of the scene; empty: the path at the time of the run.
/// @throws InputError if a required file is missing or a file is damaged.
LoggedRun read_run(const std::filesystem::path& folder, const std::filesystem::path& scene,
                   scene::MeshFormats formats = scene::MeshFormats::common);

}  // namespace app

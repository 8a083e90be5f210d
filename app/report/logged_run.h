#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/assembly/built_scene.h"
#include "app/logs/force_log.h"
#include "app/logs/trajectory.h"
#include "app/scene/scene.h"

namespace app {

/// What a run has left in its folder, and its scene read again.
struct LoggedRun {
  std::filesystem::path path;
  nlohmann::ordered_json summary;  ///< Null if the run was killed before it wrote one.
  scene::Scene scene;              ///< As it was run.
  assembly::BuiltScene built;
  std::vector<std::string> overrides;  ///< Of the scene's keys, as on the command line.
  Trajectory trajectory;
  std::size_t rows = 0;            ///< Of each body: those that every log has of every body.
  std::optional<ForceLog> forces;  ///< None unless they were logged.
};

/// @param scene   Where the scene lies now; empty: where it was run.
/// @throws InputError if a part that is needed is missing, or one that is there is broken.
LoggedRun read_run(const std::filesystem::path& folder, const std::filesystem::path& scene);

}  // namespace app

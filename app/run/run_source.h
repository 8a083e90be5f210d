#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/scene/override.h"
#include "app/scene/scene.h"

namespace app {

/// Where the scene of a run was read from, its text, and what the command line put over it: all
/// that it can be read again from, wherever the program is started then.
struct RunSource {
  std::filesystem::path file;  ///< Absolute.
  std::string text;
  std::vector<std::string> overrides;  ///< Each `KEY.PATH=VALUE`.
};

RunSource run_source(const scene::Scene& scene, const std::vector<scene::Override>& overrides);

/// The scene as it was run. @param file   Where it lies now; what it names is relative to that.
/// @throws InputError
scene::Scene read_again(const RunSource& source, const std::filesystem::path& file);

/// The overrides as the command line's were. @throws InputError
std::vector<scene::Override> overrides_of(const RunSource& source);

nlohmann::ordered_json to_json(const RunSource& source);
/// @throws nlohmann::json::exception if it is not what to_json has made.
RunSource source_from(const nlohmann::ordered_json& json);

}  // namespace app

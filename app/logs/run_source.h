#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/override.h"
#include "app/scene/scene.h"

namespace app {

/// The file and text of a run's scene and its overrides. The scene can be read again from them in
/// any working directory.
struct RunSource {
  std::filesystem::path file;  ///< Absolute.
  std::string text;
  std::vector<std::string> overrides;  ///< Each `KEY.PATH=VALUE`.
  scene::MeshFormats mesh_formats = scene::MeshFormats::common;
};

RunSource run_source(const scene::Scene& scene, const std::vector<scene::Override>& overrides);

/// Returns the scene as it was run.
/// @param file   Present path of the scene; paths in it are relative to its folder.
/// @throws InputError
scene::Scene read_again(const RunSource& source, const std::filesystem::path& file);

/// Returns the overrides of the command line. @throws InputError
std::vector<scene::Override> overrides_of(const RunSource& source);

nlohmann::ordered_json to_json(const RunSource& source);
/// Reverses to_json. @throws nlohmann::json::exception if the JSON has another form.
RunSource source_from(const nlohmann::ordered_json& json);

/// Reads the summary of a run; null if there is no such file. @throws InputError if it is none
nlohmann::ordered_json read_summary(const std::filesystem::path& file);

/// Returns the source in a summary; none if it has none.
/// @param file   Named in faults. @throws InputError if the source has another form
std::optional<RunSource> source_in(const nlohmann::ordered_json& summary,
                                   const std::filesystem::path& file);

}  // namespace app

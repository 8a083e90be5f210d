#include "app/logs/run_source.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "app/scene/reader.h"

namespace app {

RunSource run_source(const scene::Scene& scene, const std::vector<scene::Override>& overrides) {
  RunSource source{.file = std::filesystem::absolute(scene.file).lexically_normal(),
                   .text = scene.text,
                   .overrides = {},
                   .mesh_formats = scene.mesh_formats};
  for (const scene::Override& o : overrides) source.overrides.push_back(o.key_path + "=" + o.value);
  return source;
}

scene::Scene read_again(const RunSource& source, const std::filesystem::path& file) {
  return scene::parse(source.text, file, overrides_of(source), source.mesh_formats);
}

std::vector<scene::Override> overrides_of(const RunSource& source) {
  std::vector<scene::Override> overrides;
  for (const std::string& o : source.overrides) overrides.push_back(scene::parse_override(o));
  return overrides;
}

nlohmann::ordered_json to_json(const RunSource& source) {
  nlohmann::ordered_json json = {
      {"file", source.file.string()}, {"overrides", source.overrides}, {"text", source.text}};
  if (source.mesh_formats == scene::MeshFormats::any) json["any_format"] = true;
  return json;
}

RunSource source_from(const nlohmann::ordered_json& json) {
  return {.file = json.at("file").get<std::string>(),
          .text = json.at("text").get<std::string>(),
          .overrides = json.at("overrides").get<std::vector<std::string>>(),
          .mesh_formats = json.value("any_format", false) ? scene::MeshFormats::any
                                                          : scene::MeshFormats::common};
}

nlohmann::ordered_json read_summary(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return nullptr;
  std::ifstream stream(file);
  nlohmann::ordered_json summary = nlohmann::ordered_json::parse(stream, nullptr, false);
  if (!summary.is_object())
    throw scene::InputError(file,
                            "is no summary that plimsoll run has written: not JSON, or cut off");
  return summary;
}

std::optional<RunSource> source_in(const nlohmann::ordered_json& summary,
                                   const std::filesystem::path& file) {
  if (!summary.is_object() || !summary.contains("source")) return std::nullopt;
  try {
    return source_from(summary["source"]);
  } catch (const nlohmann::ordered_json::exception&) {
    throw scene::InputError(
        file, "source: expected file, text and overrides, as plimsoll run writes them");
  }
}

}  // namespace app

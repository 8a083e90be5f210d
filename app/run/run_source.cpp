#include "app/run/run_source.h"

#include <nlohmann/json.hpp>

#include "app/scene/reader.h"

namespace app {

RunSource run_source(const scene::Scene& scene, const std::vector<scene::Override>& overrides) {
  RunSource source{.file = std::filesystem::absolute(scene.file).lexically_normal(),
                   .text = scene.text,
                   .overrides = {}};
  for (const scene::Override& o : overrides) source.overrides.push_back(o.key_path + "=" + o.value);
  return source;
}

scene::Scene read_again(const RunSource& source, const std::filesystem::path& file) {
  return scene::parse(source.text, file, overrides_of(source));
}

std::vector<scene::Override> overrides_of(const RunSource& source) {
  std::vector<scene::Override> overrides;
  for (const std::string& o : source.overrides) overrides.push_back(scene::parse_override(o));
  return overrides;
}

nlohmann::ordered_json to_json(const RunSource& source) {
  return {{"file", source.file.string()}, {"overrides", source.overrides}, {"text", source.text}};
}

RunSource source_from(const nlohmann::ordered_json& json) {
  return {.file = json.at("file").get<std::string>(),
          .text = json.at("text").get<std::string>(),
          .overrides = json.at("overrides").get<std::vector<std::string>>()};
}

}  // namespace app

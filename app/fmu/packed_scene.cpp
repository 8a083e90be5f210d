#include "app/fmu/packed_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/assembly/build.h"
#include "app/assembly/stored_solutions.h"
#include "app/base/atomic_file.h"
#include "app/base/running_hash.h"
#include "app/base/thread_count.h"
#include "app/fmu/companion_files.h"
#include "app/fmu/file_bytes.h"
#include "app/fmu/unit_files.h"
#include "app/scene/key_catalogue.h"
#include "app/scene/reader.h"
#include "app/scene/yaml_reader.h"
#include "app/scene/yaml_text.h"

namespace fmu {
namespace {

namespace fs = std::filesystem;

/// Returns the paths of keys whose values are files: `bodies[].mesh.file`.
std::set<std::string> file_keys() {
  std::set<std::string> paths;
  for (const scene::KeyDescription& key : scene::key_catalogue().keys)
    for (const scene::ValueShape& shape : key.shapes)
      if (shape.kind == scene::ValueShape::Kind::file) paths.insert(key.path);
  return paths;
}

/// Gives the files of a scene new names.
class Packer {
 public:
  explicit Packer(const fs::path& scene) : folder_(scene.parent_path()), keys_(file_keys()) {}

  /// @param path   Path of the value in the catalogue.
  void rename(scene::YamlNode& node, const std::string& path) {
    if (node.is(scene::YamlNode::Kind::scalar) && !node.text.empty() && keys_.contains(path))
      node.text = name_of((folder_ / node.text).lexically_normal());
    for (scene::YamlNode& item : node.items) rename(item, path + "[]");
    for (scene::YamlEntry& entry : node.entries)
      rename(entry.value, path.empty() ? entry.key : path + "." + entry.key);
  }

  std::vector<PackedFile> take() { return std::move(files_); }

 private:
  std::string name_of(const fs::path& source) {
    const auto known = std::ranges::find(files_, source, &PackedFile::source);
    if (known != files_.end()) return known->name;
    const std::string folder = fmt::format("{}/{}/", kSceneFiles, folders_++);
    const std::string name = folder + source.filename().string();
    files_.push_back({source, name});
    for (const Companion& one : companions_of(source))
      files_.push_back({one.source, folder + one.name});
    return name;
  }

  fs::path folder_;
  std::set<std::string> keys_;
  std::vector<PackedFile> files_;
  int folders_ = 0;
};

/// Returns a token that another scene, other files and another version of the program change.
std::string new_token(const PackedScene& packed) {
  app::RunningHash hash;
  const auto add = [&](const std::string& text) { hash.add(text + '\0'); };
  add(packed.text);
  for (const PackedFile& file : packed.files) {
    add(file.name);
    add(bytes_of(file.source));
  }
  return fmt::format("plimsoll-{}-{:016x}", PLIMSOLL_VERSION, hash.value());
}

}  // namespace

PackedScene packed_scene(const fs::path& file, const std::vector<scene::Override>& overrides) {
  scene::YamlNode root = scene::parse_yaml(scene::resolved_text(file, overrides), file);
  Packer packer(file);
  packer.rename(root, "");
  return {.text = scene::yaml_text(root), .files = packer.take()};
}

void write_resources(const SceneSource& source, const fs::path& folder, app::Reporter& reporter) {
  const scene::Scene scene = scene::read(source.file, source.overrides, source.formats);
  const auto cache = assembly::cache_folder();
  assembly::AddedMassStore store(cache);
  const assembly::BuiltScene built =
      assembly::build_on_threads(app::thread_count(0), scene, store, reporter);
  for (const std::string& warning : built.warnings)
    reporter.note(fmt::format("{}: warning: {}", scene.file.string(), warning));
  const PackedScene packed = packed_scene(source.file, source.overrides);
  app::write_whole(folder / kSceneFile, packed.text);
  app::write_whole(folder / kTokenFile, new_token(packed) + "\n");
  for (const PackedFile& file : packed.files)
    app::write_whole(folder / file.name, bytes_of(file.source));
  if (cache) assembly::copy_solutions(scene, built, *cache, folder / kSolutions);
}

}  // namespace fmu

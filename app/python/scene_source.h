#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/scene/reader.h"

namespace engine {
class Hulls;
}

namespace python {

/// A scene that has been read, and what is built from it once a simulation needs it.
class SceneSource {
 public:
  /// Reads a scene file. @throws scene::InputError
  SceneSource(const std::filesystem::path& file, std::vector<scene::Override> overrides,
              scene::MeshFormats formats);
  /// Reads a text. @param file   Named in faults; paths in the scene are relative to its folder.
  SceneSource(std::string text, const std::filesystem::path& file,
              std::vector<scene::Override> overrides, scene::MeshFormats formats);

  const scene::Scene& scene() const { return scene_; }
  const std::vector<scene::Override>& overrides() const { return overrides_; }

  /// Returns what is built from the scene, with its hulls. The first call reads meshes and finds
  /// the added mass, from the store or anew, which may take minutes; later ones return the same.
  /// @throws scene::InputError
  const assembly::BuiltScene& built(int threads);

  /// Returns the specification of a simulation. @param forces   Its loads will be asked for, though
  /// the scene may not log them: a body that is held in all six has its added mass then.
  engine::SimulationSpec spec(int threads, bool forces);

  /// As built() for each of several scenes, whose bodies of one mesh share a hull and a solution.
  static void build_together(const std::vector<std::shared_ptr<SceneSource>>& scenes, int threads);

 private:
  const assembly::BuiltScene& built_with(assembly::AddedMassStore& store, engine::Hulls& hulls,
                                         int threads);

  scene::Scene scene_;
  std::vector<scene::Override> overrides_;
  std::mutex building_;
  std::optional<assembly::BuiltScene> built_;
  std::optional<engine::SimulationSpec> with_forces_;  ///< Where that differs.
};

}  // namespace python

#include "app/python/scene_source.h"

#include <algorithm>
#include <utility>

#include "app/assembly/build.h"
#include "app/python/threads.h"
#include "engine/motion/hulls.h"
#include "engine/motion/locks.h"

namespace python {

SceneSource::SceneSource(const std::filesystem::path& file, std::vector<scene::Override> overrides,
                         scene::MeshFormats formats)
    : scene_(scene::read(file, overrides, formats)), overrides_(std::move(overrides)) {}

SceneSource::SceneSource(std::string text, const std::filesystem::path& file,
                         std::vector<scene::Override> overrides, scene::MeshFormats formats)
    : scene_(scene::parse(std::move(text), file, overrides, formats)),
      overrides_(std::move(overrides)) {}

const assembly::BuiltScene& SceneSource::built(int threads) {
  assembly::AddedMassStore store(assembly::cache_folder());
  engine::Hulls hulls;
  return built_with(store, hulls, threads);
}

engine::SimulationSpec SceneSource::spec(int threads, bool forces) {
  const engine::SimulationSpec& known = built(threads).spec;
  const bool lacks = std::ranges::any_of(known.bodies, [](const engine::BodySpec& body) {
    return engine::immovable(body.locked) && body.wet && !body.added_mass;
  });
  if (!forces || scene_.log_forces || !lacks) return known;
  const std::lock_guard lock(building_);
  if (!with_forces_) {
    scene::Scene asking = scene_;
    asking.log_forces = true;
    assembly::AddedMassStore store(assembly::cache_folder());
    with_forces_ =
        shared_threads(threads).execute([&] { return assembly::build(asking, store).spec; });
  }
  return *with_forces_;
}

void SceneSource::build_together(const std::vector<std::shared_ptr<SceneSource>>& scenes,
                                 int threads) {
  assembly::AddedMassStore store(assembly::cache_folder());
  engine::Hulls hulls;
  for (const std::shared_ptr<SceneSource>& source : scenes)
    source->built_with(store, hulls, threads);
}

const assembly::BuiltScene& SceneSource::built_with(assembly::AddedMassStore& store,
                                                    engine::Hulls& hulls, int threads) {
  const std::lock_guard lock(building_);
  if (!built_) {
    built_ = shared_threads(threads).execute([&] { return assembly::build(scene_, store); });
    engine::keep_hulls(built_->spec, hulls);
  }
  return *built_;
}

}  // namespace python

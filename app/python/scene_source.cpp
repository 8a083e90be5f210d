#include "app/python/scene_source.h"

#include <utility>

#include "app/assembly/build.h"
#include "app/python/threads.h"
#include "engine/hulls.h"

namespace python {
namespace {

assembly::BuiltScene built_on(int threads, const scene::Scene& scene,
                              assembly::AddedMassStore& store) {
  return shared_threads(threads).execute([&] { return assembly::build(scene, store); });
}

}  // namespace

SceneSource::SceneSource(const std::filesystem::path& file, std::vector<scene::Override> overrides)
    : scene_(scene::read(file, overrides)), overrides_(std::move(overrides)) {}

SceneSource::SceneSource(std::string text, const std::filesystem::path& file,
                         std::vector<scene::Override> overrides)
    : scene_(scene::parse(std::move(text), file, overrides)), overrides_(std::move(overrides)) {}

const assembly::BuiltScene& SceneSource::built(int threads) {
  const std::lock_guard lock(building_);
  if (!built_) {
    assembly::AddedMassStore store(assembly::cache_folder());
    engine::Hulls hulls;
    built_ = built_on(threads, scene_, store);
    engine::keep_hulls(built_->spec, hulls);
  }
  return *built_;
}

void SceneSource::build_together(const std::vector<std::shared_ptr<SceneSource>>& scenes,
                                 int threads) {
  assembly::AddedMassStore store(assembly::cache_folder());
  engine::Hulls hulls;
  for (const std::shared_ptr<SceneSource>& source : scenes) {
    const std::lock_guard lock(source->building_);
    if (source->built_) continue;
    source->built_ = built_on(threads, source->scene_, store);
    engine::keep_hulls(source->built_->spec, hulls);
  }
}

}  // namespace python

#include "app/export/export.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "app/assembly/build.h"
#include "app/base/atomic_file.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/output_error.h"
#include "app/base/thread_count.h"
#include "app/pictures/logged_shots.h"
#include "app/pictures/paints.h"
#include "app/scene/diagnostics.h"

namespace app {

int export_run(const ExportOptions& options) {
  if (options.out.extension() != ".glb")
    throw scene::InputError(options.out,
                            "is of no format; expected .glb for a run, .fmu for a scene");
  scene::Scene scene = logged_scene(options.run, options.scene, options.overrides, options.formats);
  if (!scene.render) scene.render.emplace();
  assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  built.spec.threads = thread_count(0);
  const ShotSelector selected = logged_shots(options.run, scene, built, options.fps);
  const Paints paints = read_paints(scene, built);
  for (const std::string& warning : paints.warnings)
    say(fmt::format("{}: warning: {}", scene.file.string(), warning));
  std::string bytes;
  std::size_t nodes = 0;
  try {
    const Glb glb = animated_scene(scene, built, paints, selected.shots(), options.animation);
    nodes = glb.document["nodes"].size();
    bytes = glb.bytes();
  } catch (const std::length_error& error) {
    throw scene::InputError(
        options.out, std::string(error.what()) + "; a smaller --fps or --water makes it smaller");
  }
  write_whole(options.out, bytes);
  if (!options.quiet)
    say(fmt::format("{}: {:.1f} MB, {} nodes", options.out.string(),
                    static_cast<double>(bytes.size()) / 1e6, nodes));
  return kDone;
}

}  // namespace app

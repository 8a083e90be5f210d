#include "app/python/run_folder.h"

#include "app/logs/run_files.h"
#include "app/run/summary.h"

namespace python {

RunFolder::RunFolder(const scene::Scene& scene, const assembly::BuiltScene& built,
                     const std::vector<scene::Override>& overrides, app::LogFormat format,
                     const std::filesystem::path& path, int threads)
    : scene_(scene),
      built_(built),
      overrides_(overrides),
      folder_(path),
      log_(scene, built, format, folder_.path(), threads) {
  std::filesystem::remove(folder_.path() / app::kSummaryFile);
}

void RunFolder::finish(const engine::Simulation& simulation) {
  log_.finish();
  const app::RunErrors errors{simulation.constraint_errors(), simulation.works(),
                              simulation.counts()};
  std::vector<std::string> warnings = built_.warnings;
  for (std::string& warning : app::error_warnings(built_.spec, errors))
    warnings.push_back(std::move(warning));
  app::write_summary({.scene = scene_,
                      .built = built_,
                      .overrides = overrides_,
                      .steps = simulation.steps(),
                      .simulated = simulation.time(),
                      .timings = simulation.timings(),
                      .skips = simulation.skips(),
                      .rig = totals_,
                      .errors = errors,
                      .warnings = warnings,
                      .wall = clock_.seconds(),
                      .wall_log = log_.seconds(),
                      .pictures_skipped = "another program stepped the simulation"},
                     folder_.path() / app::kSummaryFile);
}

}  // namespace python

#pragma once

#include <filesystem>
#include <memory>

#include "app/assembly/built_scene.h"
#include "app/base/wall_clock.h"
#include "app/logs/output_folder.h"
#include "app/run/rig_totals.h"
#include "app/run/state_log.h"
#include "app/scene/override.h"

namespace python {

/// The folder to which a simulation that somebody steps is logged, as `plimsoll run` logs its own.
class RunFolder {
 public:
  /// Opens the log. The arguments must outlive this. @throws scene::InputError
  RunFolder(const scene::Scene& scene, const assembly::BuiltScene& built,
            const std::vector<scene::Override>& overrides, app::LogFormat format,
            const std::filesystem::path& path, int threads);

  /// Logs the present state if it is due.
  void keep(const engine::Simulation& simulation) { log_.keep(simulation, totals_); }
  void before_step(const engine::Simulation& simulation) { log_.before_step(simulation.states()); }

  /// Writes all rows and `summary.json`. @throws app::OutputError
  void finish(const engine::Simulation& simulation);

 private:
  const scene::Scene& scene_;
  const assembly::BuiltScene& built_;
  const std::vector<scene::Override>& overrides_;
  app::OutputFolder folder_;
  app::StateLog log_;
  app::RigTotals totals_;
  app::WallClock clock_;
};

}  // namespace python

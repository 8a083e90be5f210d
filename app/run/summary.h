#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/assembly/built_scene.h"
#include "app/pictures/pictures.h"
#include "app/run/constraint_errors.h"
#include "app/run/rig_totals.h"
#include "app/scene/reader.h"
#include "engine/simulation.h"

namespace app {

/// Energy of simulated water at the end of a run.
struct WaterEnergy {
  double waves = 0;     ///< In the waves of the grid [J].
  double absorbed = 0;  ///< Taken by the damping at the grid's edges and inside hulls [J].
};

/// Contents of `summary.json`.
struct RunSummary {
  const scene::Scene& scene;
  const assembly::BuiltScene& built;
  const std::vector<scene::Override>& overrides;  ///< Overrides of the scene's keys.
  std::string ended = "completed";                ///< Or `interrupted`, `failed`.
  std::string error;                              ///< Error of a failed run.
  long steps = 0;
  double simulated = 0;  ///< [s]
  engine::Timings timings;
  engine::Skips skips;
  std::optional<WaterEnergy> water;   ///< None without simulated water that bodies feel.
  RigTotals rig;                      ///< Totals of lines and machines.
  RunErrors errors;                   ///< Errors of constraints, works and counts.
  std::vector<std::string> warnings;  ///< Warnings of the scene, then those of the run.
  double wall = 0;                    ///< Total, including the added mass [s].
  double wall_log = 0;                ///< [s]
  double wall_render = 0;             ///< [s]
  std::optional<double> resumed_at;   ///< Time of the checkpoint it was resumed from [s].
  std::optional<PictureReport> pictures;
  std::string pictures_skipped;  ///< Reason why there are none.
};

/// Returns the keys of the loads on a body that are not computed.
std::vector<std::string> unused_loads(const engine::BodySpec& body);

/// Writes the file; a failure leaves an old one unchanged. @throws OutputError if it cannot be
/// written.
void write_summary(const RunSummary& summary, const std::filesystem::path& file);

}  // namespace app

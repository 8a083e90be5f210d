#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/logs/log.h"
#include "app/logs/make_log.h"
#include "app/logs/run_source.h"
#include "app/pictures/shot_selector.h"
#include "app/pictures/video.h"
#include "app/run/rig_totals.h"
#include "engine/base/spec.h"
#include "engine/simulation_state.h"

/// @file
/// Checkpoint of a run, from which it can be resumed after it was killed.

namespace app {

/// The choices of the command line that a resumed run keeps.
struct CheckpointChoices {
  double every = 0;  ///< Wall time between two checkpoints [s].
  LogFormat format = LogFormat::csv;
  bool render = true;
  VideoOptions video;
};

struct Checkpoint {
  RunSource source;
  std::string inputs;  ///< digest_of() the simulation that was built from the scene.
  CheckpointChoices choices;
  LogPosition log;                    ///< Rows of the run up to the checkpoint.
  long shots = 0;                     ///< Number of states to be drawn up to the checkpoint.
  std::vector<std::string> warnings;  ///< Warnings of the run up to the checkpoint.
  RigTotals rig;                      ///< Totals of the steps up to the checkpoint.
  nlohmann::ordered_json watch;       ///< State of the watch of its motion (motion_watch.h).
  std::string waves;                  ///< State of the bodies' waves in pictures; empty: none.
  engine::SimulationState state;
};

/// Returns a digest of what the files that a scene names put into its specification. Two
/// specifications of one scene with the same digest give the same motion from the same state.
std::string digest_of(const engine::SimulationSpec& spec);

/// Writes the checkpoint of a run into its folder; a failure leaves the old one unchanged. @throws
/// OutputError
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

/// Reads the checkpoint in a folder.
/// @throws InputError if there is none, or if it has another version or is cut off.
Checkpoint read_checkpoint(const std::filesystem::path& folder);

/// Removes the checkpoint of a run that has ended, and its states to be drawn.
void remove_checkpoint(const std::filesystem::path& folder);

}  // namespace app

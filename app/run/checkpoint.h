#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/logs/log.h"
#include "app/logs/make_log.h"
#include "app/pictures/shot_selector.h"
#include "app/pictures/video.h"
#include "app/run/run_source.h"
#include "engine/simulation_state.h"
#include "engine/spec.h"

/// @file
/// What a run saves of itself while it goes on, so that it can be resumed after it was killed.

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
  std::string inputs;  ///< digest_of() what the scene was built to.
  CheckpointChoices choices;
  LogPosition log;  ///< Rows that belong to the run up to here.
  long shots = 0;   ///< States to be drawn that belong to it.
  engine::SimulationState state;
};

/// A digest of everything that a simulation is made of: two specifications with the same one move
/// alike from the same state.
std::string digest_of(const engine::SimulationSpec& spec);

/// Writes the checkpoint of a run into its folder, whole or not at all. @throws OutputError
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

/// @throws InputError if there is none, or it is of another version, or cut off.
Checkpoint read_checkpoint(const std::filesystem::path& folder);

/// Removes the checkpoint of a run that has ended, and the states that wait to be drawn.
void remove_checkpoint(const std::filesystem::path& folder);

}  // namespace app

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/run/run.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace app {

/// Values of the options of `run`.
struct RunArguments {
  RunOptions options;  ///< Without `scene`.
  std::vector<std::filesystem::path> scenes;
};

/// Adds the command `run`, whose values are stored in `arguments`.
/// @param sets   The arguments of `--set`.
void add_run(CLI::App& program, RunArguments& arguments, std::vector<std::string>& sets);

/// Adds `--threads`. @param more   Stands in the description.
void add_threads(CLI::App* command, int& threads, const char* more = "");

/// Adds `--video` and `--fps`. @return `--video`
CLI::Option* add_video(CLI::App* command, VideoOptions& video);

/// Runs the scenes one after the other, each into a folder of its own: out/ or `options.out`, and
/// the scene's name; a single one into `options.out` itself. An interruption ends all of them.
/// @return the largest of their exit codes
/// @throws InputError with the faults of all scenes before the first one is run
int run_scenes(const RunArguments& arguments);

}  // namespace app

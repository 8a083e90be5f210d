#include "app/cli/run_cli.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "app/assembly/build.h"
#include "app/base/exit_code.h"
#include "app/cli/common_options.h"
#include "app/cli/guarded.h"
#include "app/pictures/video_check.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

LogFormat parse_format(const std::string& word) {
  if (word == "csv") return LogFormat::csv;
  if (word == "hdf5") return LogFormat::hdf5;
  throw scene::InputError("--format", fmt::format("found {}, expected csv or hdf5", word));
}

/// Folder of one of several scenes.
std::filesystem::path folder_of(const std::filesystem::path& scene, const RunOptions& options) {
  return (options.out.empty() ? "out" : options.out) / scene.stem();
}

/// Checks that several scenes can be run one after the other.
/// @throws InputError with the faults of all
void check_scenes(const RunArguments& arguments) {
  const RunOptions& options = arguments.options;
  if (options.video.wanted())
    throw scene::InputError("--video", fmt::format("found {} scenes, expected one for a video",
                                                   arguments.scenes.size()));
  std::vector<scene::Fault> faults;
  std::map<std::filesystem::path, std::filesystem::path> takers;
  for (const std::filesystem::path& file : arguments.scenes) {
    const std::filesystem::path out = folder_of(file, options);
    const auto [first, is_new] = takers.emplace(out, file);
    if (!is_new)
      faults.push_back({{file},
                        "",
                        fmt::format("its results would replace those of {} in {}; expected scenes "
                                    "of different names",
                                    first->second.string(), out.string())});
    try {
      assembly::build_without_added_mass(scene::read(file, options.overrides, options.formats));
    } catch (const scene::InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  if (!faults.empty()) throw scene::InputError(faults);
}

}  // namespace

void add_threads(CLI::App* command, int& threads, const char* more) {
  command
      ->add_option(
          "--threads", threads,
          fmt::format("Number of threads, 1 to 256{}; results do not depend on it [all cores]",
                      more))
      ->check(CLI::Range(1, 256).description(""))
      ->type_name("N");
}

CLI::Option* add_video(CLI::App* command, VideoOptions& video) {
  CLI::Option* file =
      command
          ->add_option_function<std::string>(
              "--video",
              [&video](const std::string& argument) {
                const VideoOptions given = video_options(argument);
                video.file = given.file;
                video.camera = given.camera;
              },
              "Also make a video (.mp4, .webm or .gif); several cameras make one each, "
              "FILE-CAMERA, and CAMERA=FILE makes that of one")
          ->type_name("FILE");
  command->add_option("--fps", video.fps, "Pictures per second of the video, 1 to 120 [25]")
      ->check(CLI::Range(1, 120).description(""))
      ->type_name("N")
      ->needs(file);
  return file;
}

void add_run(CLI::App& program, RunArguments& a, std::vector<std::string>& sets) {
  RunOptions& o = a.options;
  CLI::App* command = program.add_subcommand("run", "Run scenes: trajectory, pictures, summary");
  CLI::Option* scene =
      command->add_option("scenes", a.scenes, "Scene files (YAML), run one after the other")
          ->type_name("FILE");
  CLI::Option* out = command->add_option(
      "--out", o.out,
      "Folder for the results, of several scenes for the folder of each [out/<scene>]");
  out->type_name("DIR");
  CLI::Option* set = add_sets(command, sets);
  CLI::Option* any_format = add_any_format(command, o.formats);
  CLI::Option* format = command->add_option_function<std::string>(
      "--format", [&o](const std::string& word) { o.format = parse_format(word); },
      "Format of the log: csv, or hdf5 for large runs [csv]");
  format->type_name("FORMAT");
  command->add_flag_callback(
      "--no-render", [&o] { o.render = false; }, "Draw no pictures");
  CLI::Option* video = add_video(command, o.video);
  command
      ->add_option("--checkpoint", o.checkpoint,
                   "Save the run at this interval of wall time, so that --resume can continue it")
      ->check(CLI::Range(1e-3, 1e6).description(""))
      ->type_name("SECONDS");
  CLI::Option* resume = command->add_option(
      "--resume", o.resume, "Instead of a scene: continue the run in DIR from its checkpoint");
  resume->type_name("DIR");
  for (CLI::Option* other : {scene, out, set, any_format, format, video}) resume->excludes(other);
  command->callback([scene, resume] {
    if (scene->empty() && resume->empty()) throw CLI::RequiredError("scenes");
  });
  add_threads(command, o.threads, "; with 2 or more an additional one writes files");
  command->add_flag("--quiet", o.quiet, "Print no progress and no report");
}

int run_scenes(const RunArguments& arguments) {
  RunOptions options = arguments.options;
  if (arguments.scenes.size() < 2) {
    if (!arguments.scenes.empty()) options.scene = arguments.scenes.front();
    return run(options);
  }
  check_scenes(arguments);
  int worst = kDone;
  for (const std::filesystem::path& file : arguments.scenes) {
    options.scene = file;
    options.out = folder_of(file, arguments.options);
    worst = std::max(worst, guarded("", [&] { return run(options); }));
    if (worst == kInterrupted) break;
  }
  return worst;
}

}  // namespace app

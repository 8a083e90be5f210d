#include "app/run/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <utility>

#include "app/assembly/build.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/base/output_error.h"
#include "app/base/progress.h"
#include "app/base/terminal_reporter.h"
#include "app/base/thread_count.h"
#include "app/base/wall_clock.h"
#include "app/logs/hdf5_file.h"
#include "app/logs/output_folder.h"
#include "app/logs/run_files.h"
#include "app/logs/run_source.h"
#include "app/pictures/bodies_waves.h"
#include "app/pictures/interiors.h"
#include "app/pictures/picture_files.h"
#include "app/pictures/pictures.h"
#include "app/pictures/shot_selector.h"
#include "app/pictures/video_check.h"
#include "app/run/checkpoint.h"
#include "app/run/closing_lines.h"
#include "app/run/log_subject.h"
#include "app/run/motion_watch.h"
#include "app/run/piece_warning.h"
#include "app/run/resolved_scene.h"
#include "app/run/run_need.h"
#include "app/run/state_log.h"
#include "app/run/step_cost.h"
#include "app/run/summary.h"
#include "app/scene/diagnostics.h"
#include "engine/simulation.h"

namespace app {
namespace {

/// A run: the simulation and its output.
class Run {
 public:
  /// @param last   Checkpoint to resume from; null for a new run.
  Run(const RunOptions& options, const scene::Scene& scene, const assembly::BuiltScene& built,
      const OutputFolder& folder, const Checkpoint* last)
      : options_(options),
        scene_(scene),
        built_(built),
        folder_(folder),
        summary_{.scene = scene, .built = built, .overrides = options.overrides},
        progress_(options.quiet),
        simulation_(built.spec),
        watch_(built),
        log_(scene, built, options.format, folder.path(), built.spec.threads,
             last ? std::optional(last->log) : std::nullopt),
        shots_(scene.render ? scene.render->every : 0, scene.duration,
               options.video.pictures_a_second()) {
    summary_.warnings = built.warnings;
    if (wants_pictures()) {
      if (const hydro::SimulatedWater* felt = simulation_.water())
        shots_.show_felt_waves(felt);
      else
        shots_.show_waves(bodies_waves(scene, built.spec));
    }
    ShotSpool store;
    if (options.checkpoint > 0 && wants_pictures())
      store = ShotSpool(folder.path() / kShotFile, last ? static_cast<std::size_t>(last->shots) : 0,
                        built.spec.bodies.size());
    if (last)
      go_on_from(*last, std::move(store));
    else
      shots_.keep_in(std::move(store));
    if (!options.quiet) cost_ = measured_cost(simulation_);
    simulation_.stop_if([this] { return interrupt_.overdue(); });
  }

  int execute() {
    remove_earlier_results();
    if (!options_.quiet) introduce();
    int code = simulate();
    summary_.pictures_skipped = reason_for_no_pictures(code);
    if (summary_.pictures_skipped.empty()) code = draw(code);
    progress_.clear();
    // The summary would make a folder anew that was removed.
    if (code == kDone) folder_.check_place();
    if (!folder_.is_in_place()) return code;
    summary_.wall = built_.added_mass_seconds + clock_.seconds();
    if (!options_.quiet) report(code);
    write_summary(summary_, summary_file());
    // A run that was interrupted, or stopped by a full disk, can be resumed.
    if (code == kDone || code == kCannotGoOn) remove_checkpoint(folder_.path());
    return code;
  }

 private:
  void go_on_from(const Checkpoint& last, ShotSpool store) {
    simulation_.restore(last.state);
    const double time = simulation_.time();
    log_.take_as_logged(time);
    shots_.resume(time, simulation_.states(), drawn_rig(simulation_.rig()), std::move(store));
    shots_.restore_waves(last.waves);
    summary_.resumed_at = time;
    summary_.warnings = last.warnings;
    summary_.rig = last.rig;
    watch_.restore(last.watch);
  }

  void introduce() const {
    for (const std::string& line :
         resolved_scene(scene_, built_, simulation_.skips(), reason_for_no_pictures(kDone)))
      say(line);
    if (cost_) say("  cost at the start: " + cost_text(*cost_, built_.spec));
    say_warnings(built_.warnings);
  }

  void say_warnings(const std::vector<std::string>& warnings) const {
    for (const std::string& warning : warnings)
      say(fmt::format("{}: warning: {}", scene_.file.string(), warning));
  }

  bool wants_pictures() const { return scene_.render && options_.render; }
  std::filesystem::path summary_file() const { return folder_.path() / kSummaryFile; }

  /// Removes the results of an earlier run, so that the folder describes one run even if this one
  /// is killed or draws nothing. The trajectory has been replaced already.
  void remove_earlier_results() const {
    std::filesystem::remove(summary_file());
    remove_pictures(folder_.path());
    std::filesystem::remove(folder_.path() / kReportFile);
  }

  /// Simulates and logs to the end. Returns the exit code so far.
  int simulate() {
    int code = kDone;
    try {
      code = step_to_end();
    } catch (const OutputError& error) {
      code = failed(kWrongInput, error.what());
    }
    summary_.steps = simulation_.steps();
    summary_.simulated = simulation_.time();
    summary_.timings = simulation_.timings();
    summary_.skips = simulation_.skips();
    if (const hydro::SimulatedWater* water = simulation_.water())
      summary_.water = {.waves = built_.spec.sea->density * water->waves().energy(),
                        .absorbed = built_.spec.sea->density * water->absorbed()};
    summary_.errors = {simulation_.constraint_errors(), simulation_.works(), simulation_.counts()};
    for (std::string& warning : error_warnings(built_.spec, summary_.errors))
      summary_.warnings.push_back(std::move(warning));
    summary_.wall_log = log_.seconds();
    return code;
  }

  /// Returns the exit code so far. @throws OutputError if a row cannot be written, even if a later
  /// step failed.
  int step_to_end() {
    const long steps = step_count(scene_.duration, scene_.step);
    try {
      if (!summary_.resumed_at) keep();
      while (simulation_.steps() < steps && !interrupt_.interrupted()) {
        log_.before_step(simulation_.states());
        if (!step()) break;
        watch();
        keep();
        if (progress_.due()) show_progress();
        if (options_.checkpoint > 0 && since_checkpoint_.seconds() > options_.checkpoint)
          save_checkpoint();
      }
    } catch (const engine::SimulationError& error) {
      finish_log();
      return failed(kCannotGoOn, error.what());
    }
    if (options_.checkpoint > 0 && interrupt_.interrupted()) save_checkpoint();
    finish_log();
    return simulation_.steps() < steps ? interrupted() : kDone;
  }

  /// Takes a step. One that takes long after a signal is left; a run with checkpoints then has the
  /// state before it. @return false if it was left
  bool step() {
    std::optional<engine::SimulationState> before;
    if (options_.checkpoint > 0) before = simulation_.state();
    try {
      simulation_.step();
    } catch (const engine::StepStopped&) {
      if (before) simulation_.restore(*before);
      return false;
    }
    return true;
  }

  /// @throws OutputError, also if no one will find the log
  void finish_log() {
    folder_.check_place();
    log_.finish();
  }

  /// Saves the rows and shots so far, then the checkpoint.
  void save_checkpoint() {
    const LogPosition position = log_.save();
    shots_.save();
    write_checkpoint(folder_.path(), {.source = run_source(scene_, options_.overrides),
                                      .inputs = digest_of(built_.spec),
                                      .choices = {.every = options_.checkpoint,
                                                  .format = options_.format,
                                                  .render = options_.render,
                                                  .video = options_.video},
                                      .log = position,
                                      .shots = static_cast<long>(shots_.shots().size()),
                                      .warnings = summary_.warnings,
                                      .rig = summary_.rig,
                                      .watch = watch_.state(),
                                      .waves = shots_.state_of_waves(),
                                      .state = simulation_.state()});
    since_checkpoint_ = WallClock();
  }

  int interrupted() {
    summary_.ended = "interrupted";
    return kInterrupted;
  }

  /// Prints an error. The summary keeps the first one.
  int failed(ExitCode code, const std::string& error) {
    summary_.ended = "failed";
    if (summary_.error.empty()) summary_.error = error;
    progress_.clear();
    say("error: " + error);
    return code;
  }

  void watch() {
    for (std::string& warning : watch_.after_step(simulation_.time(), simulation_.states()))
      summary_.warnings.push_back(std::move(warning));
  }

  /// Logs the state and stores it for a picture, if either is due.
  void keep() {
    log_.keep(simulation_, summary_.rig);
    if (wants_pictures())
      shots_.add(
          simulation_.time(), simulation_.states(),
          [this] { return drawn_interiors(simulation_.interiors()); },
          [this] { return drawn_rig(simulation_.rig()); });
  }

  void show_progress() {
    progress_.show(progress_text(scene_.file.stem().string(), simulation_.time(), scene_.duration,
                                 clock_.seconds()));
  }

  /// Returns the reason; empty if there will be pictures.
  std::string reason_for_no_pictures(int code) const {
    if (!scene_.render) return "the scene has no render block";
    if (!options_.render) return "--no-render";
    if (code == kInterrupted) return "the run was interrupted";
    if (code == kWrongInput) return "the trajectory could not be written";
    return "";
  }

  /// Draws the shots at the end of the run. A failed run is drawn up to its failure and keeps its
  /// exit code.
  int draw(int code) {
    const WallClock clock;
    const auto progress = [&](int done, int all) {
      if (progress_.due())
        progress_.show(fmt::format("{}: picture {} of {}", scene_.file.stem().string(), done, all));
      return !interrupt_.interrupted();
    };
    try {
      summary_.pictures =
          draw_pictures(scene_, built_, shots_.shots(), {folder_.path(), options_.video}, progress);
    } catch (const std::exception& error) {
      summary_.pictures_skipped = "they could not be drawn";
      const int own = failed(kWrongInput, error.what());
      return code == kDone ? own : code;
    }
    summary_.warnings.insert(summary_.warnings.end(), summary_.pictures->warnings.begin(),
                             summary_.pictures->warnings.end());
    summary_.wall_render = clock.seconds();
    return code == kDone && !summary_.pictures->complete ? interrupted() : code;
  }

  void report(int code) const {
    if (code == kInterrupted)
      say(fmt::format("interrupted at {:.2f} s of {:g} s; what was done is in {}",
                      summary_.simulated, scene_.duration, folder_.path().string()));
    if (code == kInterrupted && std::filesystem::exists(folder_.path() / kCheckpointFile))
      say(fmt::format("plimsoll run --resume {} continues from there", folder_.path().string()));
    if (code == kInterrupted && options_.video.wanted() && !summary_.pictures &&
        options_.checkpoint == 0)
      say("no video was made; plimsoll render can make it from the log");
    say_warnings({summary_.warnings.begin() + static_cast<long>(built_.warnings.size()),
                  summary_.warnings.end()});
    for (const std::string& line : closing_lines(summary_, folder_.path())) say(line);
  }

  const RunOptions& options_;
  const scene::Scene& scene_;
  const assembly::BuiltScene& built_;
  const OutputFolder& folder_;
  RunSummary summary_;
  WallClock clock_;
  WallClock since_checkpoint_;
  ProgressLine progress_;
  engine::Simulation simulation_;
  MotionWatch watch_;
  InterruptGuard interrupt_;  ///< Before there is a log, a signal may end the program at once.
  StateLog log_;
  ShotSelector shots_;
  std::optional<StepCost> cost_;  ///< None where no one reads it.
};

void check_video_of_run(const RunOptions& options, const scene::Scene& scene,
                        const std::filesystem::path& out) {
  if (!options.video.wanted()) return;
  if (!options.render)
    throw scene::InputError("--video", "needs pictures, and --no-render draws none");
  if (!scene.render)
    throw scene::InputError(scene.file,
                            "has no render block, so there are no pictures for --video; "
                            "`render: {}` adds one");
  check_video(options.video, *scene.render, out, thread_count(options.threads));
}

/// Returns the options of the original run, but `threads`, `quiet` and, if given, `checkpoint` from
/// the new command line.
RunOptions resumed_options(const RunOptions& given, const Checkpoint& last) {
  return {.scene = last.source.file,
          .out = given.resume,
          .overrides = overrides_of(last.source),
          .format = last.choices.format,
          .checkpoint = given.checkpoint > 0 ? given.checkpoint : last.choices.every,
          .resume = given.resume,
          .formats = last.source.mesh_formats,
          .render = last.choices.render && given.render,
          .video = last.choices.video,
          .threads = given.threads,
          .quiet = given.quiet};
}

int run(const RunOptions& options, const Checkpoint* last) {
  const std::string no_hdf5 = why_no_hdf5();
  if (options.format == LogFormat::hdf5 && !no_hdf5.empty())
    throw scene::InputError("--format hdf5", no_hdf5);
  const scene::Scene scene = last ? read_again(last->source, last->source.file)
                                  : scene::read(options.scene, options.overrides, options.formats);
  const std::filesystem::path out = options.out.empty() ? "out" / scene.file.stem() : options.out;
  check_video_of_run(options, scene, out);
  TerminalReporter reporter(options.quiet);
  assembly::AddedMassStore store(assembly::cache_folder());
  assembly::BuiltScene built =
      assembly::build_on_threads(thread_count(options.threads), scene, store, reporter);
  for (std::string& warning :
       run_warnings(scene, log_subject(scene, built), options.format, out, options.render))
    built.warnings.push_back(std::move(warning));
  if (std::optional<std::string> warning = piece_warning(built.spec))
    built.warnings.push_back(std::move(*warning));
  if (last && digest_of(built.spec) != last->inputs)
    throw scene::InputError(scene.file,
                            "a mesh or another file that the scene names has changed since the "
                            "checkpoint: the run cannot go on, run the scene anew");
  const OutputFolder folder(out);
  if (!last) remove_checkpoint(folder.path());
  const int code = Run(options, scene, built, folder, last).execute();
  assembly::keep_solutions(built, store, reporter);
  return code;
}

}  // namespace

int run(const RunOptions& options) {
  if (options.resume.empty()) return run(options, nullptr);
  const Checkpoint last = read_checkpoint(options.resume);
  return run(resumed_options(options, last), &last);
}

}  // namespace app

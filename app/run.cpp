#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "app/assemble.h"
#include "app/commands.h"
#include "app/faults.h"
#include "app/interrupt.h"
#include "app/output_folder.h"
#include "app/pictures.h"
#include "app/progress.h"
#include "app/render/image.h"
#include "app/schedule.h"
#include "app/summary.h"
#include "app/trajectory.h"
#include "engine/simulation.h"

namespace app {
namespace {

/// Seconds since it was made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// One run: the simulation and what is kept of it.
class Run {
 public:
  Run(const RunOptions& options, const Scene& scene, const Assembly& assembly,
      const OutputFolder& folder)
      : options_(options),
        scene_(scene),
        assembly_(assembly),
        folder_(folder),
        summary_{.scene = scene, .spec = assembly.spec},
        progress_(options.quiet),
        log_due_(scene.log_every.value_or(0)),
        shot_due_(scene.render ? scene.render->every : 0) {}

  int execute() {
    int code = simulate();
    if (code != kInterrupted && wants_pictures()) code = draw(code);
    if (!scene_.render) summary_.pictures_skipped = "the scene has no render block";
    if (scene_.render && !options_.render) summary_.pictures_skipped = "--no-render";
    progress_.clear();
    summary_.wall = clock_.seconds();
    write_summary(summary_, folder_.path() / "summary.json");
    if (!options_.quiet) report(code);
    return code;
  }

 private:
  bool wants_pictures() const { return scene_.render && options_.render; }

  int simulate() {
    engine::Simulation simulation(assembly_.spec);
    TrajectoryWriter writer(folder_.path() / "trajectory.csv", names());
    const long steps = std::lround(std::ceil(scene_.duration / scene_.step * (1 - 1e-12)));
    int code = kDone;
    try {
      keep(simulation, writer);
      while (simulation.steps() < steps && !interrupt_.interrupted()) {
        simulation.step();
        keep(simulation, writer);
        show_progress(simulation);
      }
      if (simulation.steps() < steps) {
        code = kInterrupted;
        summary_.ended = "interrupted";
        summary_.pictures_skipped = "the run was interrupted";
      }
    } catch (const engine::SimulationError& error) {
      code = kCannotGoOn;
      summary_.ended = "failed";
      summary_.error = error.what();
    }
    summary_.steps = simulation.steps();
    summary_.simulated = simulation.time();
    summary_.timings = simulation.timings();
    summary_.skips = simulation.skips();
    return code;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const engine::BodySpec& body : assembly_.spec.bodies) names.push_back(body.name);
    return names;
  }

  /// Logs the state and remembers it for a picture, if either is due.
  void keep(const engine::Simulation& simulation, TrajectoryWriter& writer) {
    const double time = simulation.time();
    if (log_due_.due(time)) {
      const Stopwatch stopwatch;
      writer.add(time, simulation.states());
      summary_.wall_log += stopwatch.seconds();
    }
    if (wants_pictures() && is_frame_time(time, scene_.duration) && shot_due_.due(time))
      shots_.push_back({time, simulation.states()});
  }

  void show_progress(const engine::Simulation& simulation) {
    const double wall = clock_.seconds();
    const double done = simulation.time() / scene_.duration;
    progress_.show(fmt::format("{}: {:.2f} of {:g} s  {:3.0f} %  {:.1f} x real time  {:.0f} s left",
                               scene_.file.stem().string(), simulation.time(), scene_.duration,
                               100 * done, simulation.time() / wall, wall / done - wall));
  }

  /// Draws the shots. Pictures come last: a run that failed keeps its own code.
  int draw(int code) {
    const Stopwatch stopwatch;
    const auto progress = [&](int done, int all) {
      progress_.show(fmt::format("{}: picture {} of {}", scene_.file.stem().string(), done, all));
      return !interrupt_.interrupted();
    };
    summary_.pictures = draw_pictures(scene_, assembly_, shots_, folder_.path(), progress);
    summary_.wall_render = stopwatch.seconds();
    if (code == kDone && summary_.pictures->frames < static_cast<int>(shots_.size())) {
      summary_.ended = "interrupted";
      return kInterrupted;
    }
    return code;
  }

  void report(int code) const {
    if (code == kCannotGoOn) fmt::print(stderr, "error: {}\n", summary_.error);
    if (code == kInterrupted)
      fmt::print(stderr, "interrupted at {:.2f} s of {:g} s; what was done is in {}\n",
                 summary_.simulated, scene_.duration, folder_.path().string());
    const engine::Timings& t = summary_.timings;
    fmt::print(stderr,
               "{}: {} steps, {:g} s simulated in {:.2f} s "
               "(hydro {:.2f}, collision {:.2f}, engine {:.2f}, log {:.2f}, pictures {:.2f})\n",
               folder_.path().string(), summary_.steps, summary_.simulated, summary_.wall, t.hydro,
               t.collision, t.engine, summary_.wall_log, summary_.wall_render);
  }

  const RunOptions& options_;
  const Scene& scene_;
  const Assembly& assembly_;
  const OutputFolder& folder_;
  RunSummary summary_;
  Stopwatch clock_;
  ProgressLine progress_;
  InterruptGuard interrupt_;
  Schedule log_due_;
  Schedule shot_due_;
  std::vector<Shot> shots_;
};

int thread_count(int wanted) {
  if (wanted > 0) return wanted;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

int run(const RunOptions& options) {
  const Scene scene = read_scene(options.scene, options.overrides);
  Assembly assembly = assemble(scene);
  assembly.spec.threads = thread_count(options.threads);
  if (!options.quiet)
    for (const std::string& note : assembly.notes)
      fmt::print(stderr, "{}: note: {}\n", scene.file.string(), note);
  const std::filesystem::path out = options.out.empty() ? "out" / scene.file.stem() : options.out;
  const OutputFolder folder(out);
  return Run(options, scene, assembly, folder).execute();
}

}  // namespace app

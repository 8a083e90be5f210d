#include "app/view/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/assembly/build.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/program_files.h"
#include "app/base/schedule.h"
#include "app/base/terminal_reporter.h"
#include "app/base/thread_count.h"
#include "app/pictures/cameras.h"
#include "app/render/png.h"
#include "app/view/live_scene.h"
#include "app/view/status.h"
#include "app/view/window.h"

namespace app {
namespace {

constexpr double kFrameTime = 1.0 / 60;  ///< Shortest clock time between pictures [s].
constexpr double kIdleTime = 0.25;       ///< Clock time between polls while nothing moves [s].
constexpr double kLongestSteps = 0.1;    ///< Clock time for steps between two pictures [s].

std::string title_of(const scene::Scene& scene) {
  return "Plimsoll: " + (scene.title.empty() ? scene.file.stem().string() : scene.title);
}

render::Camera first_camera(const scene::Scene& scene, const assembly::BuiltScene& built) {
  return camera_at_start(cameras_of(*scene.render).front(), built);
}

/// A window in which a scene runs until the user closes it.
class LiveView {
 public:
  LiveView(const ViewOptions& options, const scene::Scene& scene, const assembly::BuiltScene& built,
           Window& window)
      : options_(options),
        window_(window),
        live_(scene, built),
        controls_(first_camera(scene, built), scene.step,
                  [this](const Ray& ray) {
                    const engine::Simulation& simulation = live_.simulation();
                    return first_hit(ray, simulation.spec().bodies, simulation.states());
                  }),
        last_step_(options.snapshot.empty() ? -1 : step_count(options.after, scene.step)) {}

  int execute() {
    show();
    clock_ = Clock::now();
    while (!done_ && !window_.closed() && !controls_.quit()) {
      bool changed = take_events();
      changed = advance() || changed;
      if (changed || window_.size() != shown_size_) show();
    }
    return kDone;
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool take_events() {
    const PlaybackClock& playback = controls_.playback();
    const std::chrono::duration<double> since = Clock::now() - clock_;
    const double wait =
        playback.paused() ? kIdleTime : std::max(playback.until_next(), kFrameTime) - since.count();
    const std::vector<Event> events = window_.events(wait);
    for (const Event& event : events) controls_.take(event);
    return !events.empty();
  }

  /// Takes the steps that the clock asks for. Returns true if the scene has changed.
  bool advance() {
    const bool restart = controls_.take_restart();
    if (restart) live_.restart();
    live_.hold(controls_.held());
    const auto now = Clock::now();
    const std::chrono::duration<double> since = now - std::exchange(clock_, now);
    long steps = controls_.playback().steps_due(since.count());
    if (last_step_ >= 0) steps = std::min(steps, last_step_ - live_.simulation().steps());
    const long taken = steps > 0 ? live_.advance(steps, kLongestSteps) : 0;
    controls_.playback().note(since.count(), taken);
    return restart || taken > 0;
  }

  void show() {
    const auto [width, height] = shown_size_ = window_.size();
    if (width == 0 || height == 0) return;
    render::Image image =
        live_.picture(controls_.camera(), width, height, playback_text(controls_.playback()));
    add_help(image, controls_.help());
    window_.draw(image);
    if (live_.simulation().steps() == last_step_) {
      render::write_png(window_.read(), options_.snapshot);
      done_ = true;
    }
    window_.present();
  }

  const ViewOptions& options_;
  Window& window_;
  LiveScene live_;
  Controls controls_;
  long last_step_;  ///< Step of the snapshot; -1: none.
  bool done_ = false;
  std::array<int, 2> shown_size_ = {0, 0};
  Clock::time_point clock_;  ///< Time at which steps were last asked for.
};

}  // namespace

int view(const ViewOptions& options) {
  if (const std::string reason = why_no_window(); !reason.empty()) {
    say("error: " + reason);
    return kWrongInput;
  }
  scene::Scene scene = scene::read(options.scene, options.overrides, options.formats);
  if (!scene.render) scene.render.emplace();
  Window window(title_of(scene), scene.render->size[0], scene.render->size[1]);
  TerminalReporter reporter(false);
  assembly::AddedMassStore store(assembly::cache_folder());
  assembly::BuiltScene built =
      assembly::build_on_threads(thread_count(options.threads), scene, store, reporter);
  built.spec.record_work = false;
  const int code = LiveView(options, scene, built, window).execute();
  assembly::keep_solutions(built, store, reporter);
  return code;
}

}  // namespace app

#include "app/view/view.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/assembly/assemble_added_mass.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/program_files.h"
#include "app/base/schedule.h"
#include "app/base/thread_count.h"
#include "app/pictures/cameras.h"
#include "app/render/png.h"
#include "app/view/stage.h"
#include "app/view/status.h"
#include "app/view/window.h"

namespace app {
namespace {

constexpr double kFrameTime = 1.0 / 60;  ///< Of the clock, from picture to picture at best [s].
constexpr double kIdleTime = 0.25;       ///< Between looks at the window while nothing moves [s].
constexpr double kLongestSteps = 0.1;    ///< Of the clock, from picture to picture [s].

std::string title_of(const Scene& scene) {
  return "Plimsoll: " + (scene.title.empty() ? scene.file.stem().string() : scene.title);
}

render::Camera first_camera(const Scene& scene) {
  const CameraScene camera = cameras_of(*scene.render).front();
  return {camera.from, camera.to, camera.field_of_view};
}

/// A window in which a scene goes on until somebody closes it.
class LiveView {
 public:
  LiveView(const ViewOptions& options, const Scene& scene, const Assembly& assembly, Window& window)
      : options_(options),
        window_(window),
        stage_(scene, assembly),
        controls_(first_camera(scene), scene.step,
                  [this](const Ray& ray) {
                    const engine::Simulation& simulation = stage_.simulation();
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
    const Pace& pace = controls_.pace();
    const std::chrono::duration<double> since = Clock::now() - clock_;
    const double wait =
        pace.paused() ? kIdleTime : std::max(pace.until_next(), kFrameTime) - since.count();
    const std::vector<Event> events = window_.events(wait);
    for (const Event& event : events) controls_.take(event);
    return !events.empty();
  }

  /// Takes the steps that the clock asks for. Returns true if the scene has changed.
  bool advance() {
    const bool restart = controls_.take_restart();
    if (restart) stage_.restart();
    stage_.hold(controls_.held());
    const auto now = Clock::now();
    const std::chrono::duration<double> since = now - std::exchange(clock_, now);
    long steps = controls_.pace().steps_due(since.count());
    if (last_step_ >= 0) steps = std::min(steps, last_step_ - stage_.simulation().steps());
    const long taken = steps > 0 ? stage_.advance(steps, kLongestSteps) : 0;
    controls_.pace().note(since.count(), taken);
    return restart || taken > 0;
  }

  void show() {
    const auto [width, height] = shown_size_ = window_.size();
    if (width == 0 || height == 0) return;
    render::Image image =
        stage_.picture(controls_.camera(), width, height, pace_text(controls_.pace()));
    add_help(image, controls_.help());
    window_.draw(image);
    if (stage_.simulation().steps() == last_step_) {
      render::write_png(window_.read(), options_.snapshot);
      done_ = true;
    }
    window_.present();
  }

  const ViewOptions& options_;
  Window& window_;
  Stage stage_;
  Controls controls_;
  long last_step_;  ///< That a picture is kept of; -1: none.
  bool done_ = false;
  std::array<int, 2> shown_size_ = {0, 0};
  Clock::time_point clock_;  ///< When steps were last asked for.
};

}  // namespace

int view(const ViewOptions& options) {
  if (const std::string reason = why_no_window(); !reason.empty()) {
    say("error: " + reason);
    return kWrongInput;
  }
  Scene scene = read_scene(options.scene, options.overrides);
  Assembly assembly = assemble(scene);
  assembly.spec.threads = thread_count(options.threads);
  assembly.spec.record_work = false;
  if (!scene.render) {
    const render::Camera camera = framing(assembly.spec);
    scene.render.emplace().camera = {
        .from = camera.from, .to = camera.to, .field_of_view = camera.field_of_view};
  }
  for (const std::string& note : assembly.notes)
    say(fmt::format("{}: note: {}", scene.file.string(), note));
  Window window(title_of(scene), scene.render->size[0], scene.render->size[1]);
  AddedMassStore store(cache_folder());
  tbb::task_arena threads(assembly.spec.threads);
  threads.execute([&] { add_added_mass(scene, assembly, store, false); });
  const int code = LiveView(options, scene, assembly, window).execute();
  keep_surface_nodes(assembly, store);
  return code;
}

}  // namespace app

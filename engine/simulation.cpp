#include "engine/simulation.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "engine/applied_load.h"
#include "engine/faults.h"
#include "engine/locks.h"
#include "engine/stiff_drag.h"
#include "engine/wetness.h"
#include "engine/world.h"
#include "hydro/parallel.h"

namespace engine {
namespace {

/// Adds the wall time of its scope to a sum [s].
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& sum_;
  Clock::time_point start_ = Clock::now();
};

std::string message(double time, const std::string& body, const std::string& what) {
  if (body.empty()) return fmt::format("at t = {:g} s: {}", time, what);
  return fmt::format("body '{}' at t = {:g} s: {}", body, time, what);
}

/// What the water acts on, with the last load it had.
struct Floater {
  BodyId body = 0;
  hydro::Hull hull;
  Eigen::AlignedBox3d box_B;
  std::optional<hydro::BodyState> loaded_state;  ///< That `loads` belongs to.
  hydro::Loads loads;
  bool jointed = false;
};

bool has_joint(const SimulationSpec& spec, BodyId body) {
  return std::any_of(spec.joints.begin(), spec.joints.end(), [&](const JointSpec& joint) {
    return joint.first == body || joint.second == body;
  });
}

bool changes_with_time(const hydro::Sea& sea) {
  return std::holds_alternative<hydro::WaveSurface>(sea.surface);
}

std::vector<Floater> make_floaters(const SimulationSpec& spec) {
  std::vector<Floater> floaters;
  if (!spec.sea) return floaters;
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    const BodySpec& body = spec.bodies[i];
    if (!feels_water(body)) continue;
    floaters.push_back({.body = static_cast<BodyId>(i),
                        .hull = hydro::make_hull(body.mesh_B),
                        .box_B = hydro::bounding_box(body.mesh_B),
                        .jointed = has_joint(spec, static_cast<BodyId>(i))});
  }
  return floaters;
}

World make_world(const SimulationSpec& spec) {
  if (!(spec.step > 0 && std::isfinite(spec.step))) {
    throw std::invalid_argument(fmt::format("the step is {} s, not positive", spec.step));
  }
  World world(spec.gravity);
  for (const BodySpec& body : spec.bodies) world.add_body(body);
  for (const JointSpec& joint : spec.joints) world.add_joint(joint);
  world.add_ground(spec.ground);
  return world;
}

}  // namespace

SimulationError::SimulationError(double time, std::string body, const std::string& what)
    : std::runtime_error(message(time, body, what)), time_(time), body_(std::move(body)) {}

struct Simulation::Impl {
  explicit Impl(SimulationSpec description);

  void step();

  double time() const { return static_cast<double>(steps) * spec.step; }
  std::size_t count() const { return spec.bodies.size(); }
  const BodySpec& body(std::size_t i) const { return spec.bodies[i]; }

  // The stages of a step, in their order.
  void find_applied_loads();
  void find_water_loads();
  void find_water_load(Floater& floater);
  void damp_stiff_drag(const Floater& floater);
  void apply_loads();
  void collide();
  void advance();
  void hold_locks();
  void accept_states();

  hydro::BodyState next_state(std::size_t i) const { return world.state(static_cast<BodyId>(i)); }
  [[noreturn]] void give_up(const OdeFault& fault);

  SimulationSpec spec;
  World world;
  tbb::task_arena threads;
  std::vector<Floater> floaters;
  double highest_water = 0;
  std::vector<hydro::BodyState> states;
  std::vector<BodyLoads> loads;  ///< Of the step that is being taken.
  long steps = 0;
  bool broken = false;  ///< The mechanics engine stopped in the middle of a step.
  Timings timings;
  Skips skips;
  std::vector<long> stiff_steps;
};

Simulation::Impl::Impl(SimulationSpec description)
    : spec(std::move(description)),
      world(make_world(spec)),
      threads(std::max(1, spec.threads)),
      floaters(make_floaters(spec)) {
  if (spec.sea) highest_water = hydro::surface_bounds(*spec.sea).highest;
  for (std::size_t i = 0; i < count(); ++i) states.push_back(next_state(i));
  loads.resize(count());
  skips.collision = !world.can_collide();
  skips.water = floaters.empty();
  skips.dry_steps.assign(count(), 0);
  skips.resting_steps.assign(count(), 0);
  stiff_steps.assign(count(), 0);
}

void Simulation::Impl::step() {
  if (broken) throw SimulationError(time(), "", "the simulation has stopped on an earlier error");
  try {
    find_applied_loads();
    find_water_loads();
    apply_loads();
    collide();
    advance();
    hold_locks();
    accept_states();
  } catch (const OdeFault& fault) {
    give_up(fault);
  }
  ++steps;
}

void Simulation::Impl::find_applied_loads() {
  for (std::size_t i = 0; i < count(); ++i) {
    loads[i] = {};
    if (immovable(body(i).locked)) continue;
    for (const AppliedLoad& load : body(i).loads) {
      loads[i].applied.push_back(wrench(load, states[i], time()));
    }
  }
}

void Simulation::Impl::find_water_loads() {
  const Stopwatch stopwatch(timings.hydro);
  threads.execute([&] {
    hydro::parallel_for(floaters.size(), [&](std::size_t i) { find_water_load(floaters[i]); });
  });
}

void Simulation::Impl::find_water_load(Floater& floater) {
  const auto i = static_cast<std::size_t>(floater.body);
  if (lowest_point(floater.box_B, states[i]) >= highest_water) {
    ++skips.dry_steps[i];
    return;
  }
  if (floater.loaded_state == states[i] && !changes_with_time(*spec.sea)) {
    ++skips.resting_steps[i];
  } else {
    floater.loads =
        hydro::compute_loads(floater.hull, states[i], *spec.sea, time(), body(i).coefficients);
    floater.loaded_state = states[i];
  }
  loads[i].water = floater.loads;
  // A body in a joint moves with what it is tied to; its own mass says nothing about its stiffness.
  if (!floater.jointed) damp_stiff_drag(floater);
}

void Simulation::Impl::damp_stiff_drag(const Floater& floater) {
  const auto i = static_cast<std::size_t>(floater.body);
  const hydro::Wrench drag = floater.loads.pressure_drag + floater.loads.viscous_drag;
  const double stiffness = drag_stiffness(body(i), states[i], spec.sea->current, drag, spec.step);
  if (!(stiffness > kStiffDrag)) return;
  hydro::Wrench load = loads[i].total();
  load.force.z() -= body(i).mass * spec.gravity;
  loads[i].damping =
      implicit_part(body(i), floater.hull, states[i], *spec.sea, time(), load, spec.step);
  ++stiff_steps[i];
}

void Simulation::Impl::apply_loads() {
  for (std::size_t i = 0; i < count(); ++i) {
    if (const auto fault = load_fault(loads[i])) {
      throw SimulationError(time(), body(i).name, *fault);
    }
    if (immovable(body(i).locked)) continue;
    if (const auto fault = motion_fault(body(i), states[i], loads[i].total(), spec.step)) {
      throw SimulationError(time(), body(i).name,
                            fmt::format("{} after the step; {}", *fault, largest_load(loads[i])));
    }
  }
  for (std::size_t i = 0; i < count(); ++i) {
    world.apply(static_cast<BodyId>(i), loads[i].total());
  }
}

void Simulation::Impl::collide() {
  if (skips.collision) return;
  const Stopwatch stopwatch(timings.collision);
  world.collide(spec.step);
}

void Simulation::Impl::advance() {
  const Stopwatch stopwatch(timings.engine);
  world.advance(spec.step);
}

void Simulation::Impl::hold_locks() {
  for (std::size_t i = 0; i < count(); ++i) {
    const DofMask& locked = body(i).locked;
    if (!partly_held(locked)) continue;
    world.set_state(static_cast<BodyId>(i), held(locked, body(i).initial, next_state(i)));
  }
}

void Simulation::Impl::accept_states() {
  std::vector<hydro::BodyState> next;
  next.reserve(count());
  for (std::size_t i = 0; i < count(); ++i) {
    next.push_back(next_state(i));
    if (const auto fault = state_fault(next.back())) {
      broken = true;
      throw SimulationError(time() + spec.step, body(i).name,
                            *fault + "; " + largest_load(loads[i]));
    }
  }
  states = std::move(next);
}

void Simulation::Impl::give_up(const OdeFault& fault) {
  broken = true;
  for (std::size_t i = 0; i < count(); ++i) {
    if (const auto state = state_fault(next_state(i))) {
      throw SimulationError(
          time(), body(i).name,
          fmt::format("{}; {} ({})", *state, largest_load(loads[i]), fault.what()));
    }
  }
  throw SimulationError(time(), "", fault.what());
}

Simulation::Simulation(SimulationSpec spec) {
  try {
    impl_ = std::make_unique<Impl>(std::move(spec));
  } catch (const OdeFault& fault) {
    throw SimulationError(0, "", fault.what());
  }
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const SimulationSpec& Simulation::spec() const { return impl_->spec; }
double Simulation::time() const { return impl_->time(); }
long Simulation::steps() const { return impl_->steps; }
const std::vector<hydro::BodyState>& Simulation::states() const { return impl_->states; }
const Timings& Simulation::timings() const { return impl_->timings; }
const Skips& Simulation::skips() const { return impl_->skips; }
const std::vector<long>& Simulation::stiff_steps() const { return impl_->stiff_steps; }

void Simulation::step() { impl_->step(); }

}  // namespace engine

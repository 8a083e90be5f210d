#include "engine/simulation.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/body.h"
#include "engine/encounter.h"
#include "engine/ode_step.h"
#include "engine/split_step.h"
#include "engine/stopwatch.h"
#include "engine/world.h"
#include "hydro/parallel.h"

namespace engine {
namespace {

std::string message(double time, const std::string& body, const std::string& what) {
  if (body.empty()) return fmt::format("at t = {:g} s: {}", time, what);
  return fmt::format("body '{}' at t = {:g} s: {}", body, time, what);
}

/// True if there are two things that could meet.
bool has_a_pair(const SimulationSpec& spec) {
  const auto collide = std::count_if(spec.bodies.begin(), spec.bodies.end(), [](const auto& body) {
    return body.collision != CollisionShape::none;
  });
  return collide + (std::holds_alternative<std::monostate>(spec.ground) ? 0 : 1) > 1;
}

World make_world(const SimulationSpec& spec) {
  if (!(spec.step > 0 && std::isfinite(spec.step))) {
    throw std::invalid_argument(fmt::format("the step is {} s, not positive", spec.step));
  }
  World world(spec.gravity);
  const bool meets = has_a_pair(spec);
  for (const BodySpec& body : spec.bodies) world.add_body(body, meets);
  // Before the joints: some keep the compliance that the world has when they are made.
  if (spec.integrator.method == Integrator::Method::split) world.only_constrain();
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
  void pull(BodyId body, const std::optional<Pull>& pull);
  std::vector<BodyForces> forces();

  double time() const { return static_cast<double>(steps) * spec.step; }
  std::size_t count() const { return spec.bodies.size(); }

  // The stages of a step, in their order.
  void advance();
  void accept_states();
  void warn();
  void note_costs();

  double load_seconds() const;
  [[noreturn]] void give_up(const OdeFault& fault);

  SimulationSpec spec;
  World world;
  tbb::task_arena threads;
  Surroundings around;
  std::vector<Body> bodies;
  std::unique_ptr<SplitStep> split;
  std::vector<hydro::BodyState> states;
  long steps = 0;
  bool broken = false;  ///< A step stopped halfway.
  Timings timings;
  double loads_so_far = 0;  ///< load_seconds() after the last step.
  Skips skips;
  std::vector<Path> paths;
  std::vector<std::string> warnings;
};

Simulation::Impl::Impl(SimulationSpec description)
    : spec(std::move(description)),
      world(make_world(spec)),
      threads(std::max(1, spec.threads)),
      around(surroundings(spec)),
      bodies(make_bodies(spec)) {
  for (const Body& body : bodies) states.push_back(body.motion.state);
  skips.collision = !world.can_collide();
  skips.water = std::none_of(bodies.begin(), bodies.end(),
                             [](const Body& body) { return body.wet || body.adds; });
  skips.dry_steps.assign(count(), 0);
  skips.resting_steps.assign(count(), 0);
  skips.asleep_steps.assign(count(), 0);
  paths.resize(count());
  const ForEach for_each = [this](std::size_t n, const std::function<void(std::size_t)>& f) {
    threads.execute([&] { hydro::parallel_for(n, f); });
  };
  split = std::make_unique<SplitStep>(Stepping{.world = world,
                                               .bodies = bodies,
                                               .around = around,
                                               .for_each = for_each,
                                               .collides = !skips.collision,
                                               .tolerance = spec.integrator.tolerance},
                                      spec.integrator.sleep);
}

void Simulation::Impl::step() {
  if (broken) throw SimulationError(time(), "", "the simulation has stopped on an earlier error");
  broken = true;
  try {
    advance();
    accept_states();
  } catch (const MotionFault& fault) {
    throw SimulationError(time(), fault.body(), fault.what());
  } catch (const OdeFault& fault) {
    give_up(fault);
  }
  broken = false;
  ++steps;
  if (warnings.empty()) warn();
}

void Simulation::Impl::pull(BodyId body, const std::optional<Pull>& pull) {
  std::optional<Pull>& held = bodies[static_cast<std::size_t>(body)].pull;
  held = pull;
  if (!held) return;
  held->rate = std::min(held->rate, kFastestPull / spec.step);
  split->rouse(body);
}

void Simulation::Impl::advance() {
  if (spec.books)
    for (Body& body : bodies)
      body.motion.ledger->added_impulse = body.motion.ledger->constraint_impulse = Vector6d::Zero();
  const double collisions_before = world.collision_seconds();
  double wall = 0;
  {
    const Stopwatch stopwatch(wall);
    if (spec.integrator.method == Integrator::Method::split)
      split->advance(time(), spec.step);
    else
      ode_step(world, bodies, around, time(), spec.step, !skips.collision);
  }
  // Loads of several bodies are found at once: what they take of the step is an average. That of
  // one body is its own, whatever the number of threads.
  const double collision = world.collision_seconds() - collisions_before;
  const double loads_before = std::exchange(loads_so_far, load_seconds());
  const auto at_once =
      std::clamp(static_cast<double>(count()), 1.0, std::max(1.0, 1.0 * spec.threads));
  const double loads = std::min(wall - collision, (loads_so_far - loads_before) / at_once);
  timings.collision += collision;
  timings.hydro += loads;
  timings.engine += wall - collision - loads;
}

void Simulation::Impl::accept_states() {
  for (std::size_t i = 0; i < count(); ++i) states[i] = bodies[i].motion.state;
}

std::vector<BodyForces> Simulation::Impl::forces() {
  if (!spec.books) throw std::logic_error("the simulation keeps no books of forces");
  std::vector<BodyForces> forces(count());
  threads.execute([&] {
    hydro::parallel_for(count(), [&](std::size_t i) {
      forces[i] = forces_on(bodies[i], around, time(), spec.step,
                            split->sleep().asleep(static_cast<BodyId>(i)));
    });
  });
  return forces;
}

void Simulation::Impl::warn() {
  for (const Body& body : bodies) {
    const auto warning = encounter_warning(body, around, spec.step);
    if (!warning) continue;
    warnings.push_back(*warning);
    return;
  }
}

void Simulation::Impl::note_costs() {
  for (std::size_t i = 0; i < count(); ++i) {
    const Cost& cost = bodies[i].cost;
    skips.dry_steps[i] = cost.dry;
    skips.resting_steps[i] = cost.resting;
    skips.asleep_steps[i] = split->sleep().steps(static_cast<BodyId>(i));
    paths[i] = {.free = cost.free_steps,
                .constrained = cost.constrained_steps,
                .pieces = cost.substeps,
                .implicit = cost.implicit,
                .iterations = cost.iterations,
                .unconverged = cost.unconverged,
                .braked = cost.braked};
  }
}

double Simulation::Impl::load_seconds() const {
  double sum = 0;
  for (const Body& body : bodies) sum += body.cost.load_seconds;
  return sum;
}

void Simulation::Impl::give_up(const OdeFault& fault) {
  for (std::size_t i = 0; i < count(); ++i) {
    const auto state = state_fault(world.state(static_cast<BodyId>(i)));
    if (!state) continue;
    throw SimulationError(
        time(), spec.bodies[i].name,
        fmt::format("{}; {} ({})", *state, largest_load(bodies[i].loads), fault.what()));
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
std::vector<BodyForces> Simulation::forces() const { return impl_->forces(); }
const Timings& Simulation::timings() const { return impl_->timings; }
const Skips& Simulation::skips() const {
  impl_->note_costs();
  return impl_->skips;
}
const std::vector<Path>& Simulation::paths() const {
  impl_->note_costs();
  return impl_->paths;
}
const std::vector<std::string>& Simulation::warnings() const { return impl_->warnings; }

void Simulation::pull(BodyId body, const std::optional<Pull>& pull) { impl_->pull(body, pull); }
void Simulation::step() { impl_->step(); }

}  // namespace engine

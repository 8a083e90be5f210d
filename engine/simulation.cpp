#include "engine/simulation.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/body_check.h"
#include "engine/base/constants.h"
#include "engine/base/stopwatch.h"
#include "engine/contacts/bed_suction.h"
#include "engine/motion/locks.h"
#include "engine/motion/water_coupling.h"
#include "engine/record/time_book.h"
#include "engine/rig/rig.h"
#include "engine/state_data.h"
#include "engine/step/ode_step.h"
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
  if (!(spec.step > 0 && std::isfinite(spec.step)))
    throw std::invalid_argument(fmt::format("the step is {} s, not positive", spec.step));
  World world(spec.gravity);
  world.set_surfaces(ContactSurfaces(spec));
  const bool meets = has_a_pair(spec);
  for (const BodySpec& body : spec.bodies) world.add_body(body, meets);
  // Joints take some of the world's compliance when they are made, so this comes before them.
  for (const JointSpec& joint : spec.joints) world.add_joint(joint);
  world.add_ground(spec.ground);
  return world;
}

std::vector<MovingBody> make_moving_bodies(const SimulationSpec& spec, const Rig& rig) {
  std::vector<MovingBody> moving;
  moving.reserve(spec.bodies.size());
  for (Body& body : make_bodies(spec)) {
    const auto id = static_cast<BodyId>(moving.size());
    body.rigged = rig.acts_on(id);
    body.dynamic_line = rig.has_dynamic_line(id);
    body.driven_by_rows = rig.constrains(id);
    if (body.driven_by_rows) body.reduced_joint.reset();
    const hydro::BodyState initial = without_locked_motion(body.spec->locked, body.spec->initial);
    Motion motion = motion_at(body, spec, initial, 0);
    moving.push_back({.id = id, .body = std::move(body), .motion = std::move(motion)});
    if (rig.machines().drives(id)) moving.back().machines = &rig.machines();
    moving.back().set_points = &rig.set_points();
    if (spec.suction && moving.back().body.movable) moving.back().motion.suction.emplace();
  }
  return moving;
}

}  // namespace

SimulationError::SimulationError(double time, std::string body, const std::string& what)
    : std::runtime_error(message(time, body, what)), time_(time), body_(std::move(body)) {}

struct Simulation::Impl {
  explicit Impl(SimulationSpec description);

  double time() const { return static_cast<double>(steps) * spec.step; }
  MovingBody& body(BodyId id);
  const SetPointSpec& set_point(SetPointId id) const;
  std::vector<BodyForces> forces();
  SimulationState state() const;
  void restore(const SimulationState::Data& data);

  RigReadings readings() const;
  void begin_step();
  void move_lines();
  void accept_step(const std::vector<Overlap>& overlaps);
  [[noreturn]] void give_up(const OdeFault& fault);

  SimulationSpec spec;
  World world;
  Rig rig;
  tbb::task_arena threads;
  std::vector<MovingBody> bodies;
  StepContext context;
  Stepper stepper;
  std::vector<hydro::BodyState> states;
  long steps = 0;
  bool broken = false;  ///< A step stopped halfway.
  TimeBook times;
  StopCheck stop;
  ConstraintErrors errors;
  std::optional<WaterCoupling> water;
  std::optional<SimulationState> start;
};

Simulation::Impl::Impl(SimulationSpec description)
    : spec(std::move(description)),
      world(make_world(spec)),
      rig(spec),
      threads(std::max(1, spec.threads)),
      bodies(make_moving_bodies(spec, rig)),
      context{.world = world,
              .rig = rig,
              .bodies = bodies,
              .gravity = spec.gravity,
              .parallel_for =
                  [this](std::size_t n, const std::function<void(std::size_t)>& f) {
                    threads.execute([&] { hydro::parallel_for(n, f); });
                  },
              .collides = world.can_collide(),
              .tolerance = spec.integrator.tolerance,
              .stop = &stop},
      stepper(context, spec.step) {
  check_suction(spec);
  if (spec.suction) begin_suction(world, *spec.suction, spec.step, bodies);
  for (const MovingBody& moving : bodies) states.push_back(moving.motion.state);
  errors.joints.resize(spec.joints.size());
  if (spec.sea && spec.water) water.emplace(spec);
  start = state();
}

MovingBody& Simulation::Impl::body(BodyId id) {
  if (id < 0 || id >= static_cast<BodyId>(bodies.size()))
    throw std::invalid_argument(fmt::format("there is no body {}", id));
  return bodies[id];
}

const SetPointSpec& Simulation::Impl::set_point(SetPointId id) const {
  if (id < 0 || id >= static_cast<SetPointId>(spec.set_points.size()))
    throw std::invalid_argument(fmt::format("there is no set point {}", id));
  return spec.set_points[id];
}

/// Adds the reactions of reduced joints, which no solver finds, from the records of work.
RigReadings Simulation::Impl::readings() const {
  RigReadings readings = rig.readings(states, time(), spec.step);
  for (std::size_t i = 0; i < spec.joints.size(); ++i) {
    for (const BodyId id : {spec.joints[i].first, spec.joints[i].second}) {
      if (id == kWorld || !bodies[id].body.reduced_joint || !bodies[id].motion.work) continue;
      const double sign = id == spec.joints[i].second ? 1 : -1;
      const Vector6d R = sign / spec.step * bodies[id].motion.work->constraint_impulse;
      JointReading& joint = readings.joints[i];
      const Eigen::Vector3d arm = states[id].position - joint.place_W;
      joint.force_W = R.head<3>();
      joint.moment_W = R.tail<3>() + arm.cross(joint.force_W);
    }
  }
  return readings;
}

void Simulation::Impl::begin_step() {
  rig.begin_step(states, time(), spec.step);
  for (MovingBody& moving : bodies)
    if (moving.motion.work) moving.motion.work->start_step();
  if (water) water->begin_step(steps, bodies, times.water());
}

/// Takes what is coupled to the bodies once a step to the ends of their ways.
void Simulation::Impl::move_lines() {
  if (!rig.has_dynamic_lines()) return;
  std::vector<hydro::BodyState> ends;
  for (const MovingBody& moving : bodies) ends.push_back(moving.motion.state);
  rig.follow(ends);
}

void Simulation::Impl::accept_step(const std::vector<Overlap>& overlaps) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    states[i] = bodies[i].motion.state;
    bodies[i].inputs.loads.clear();
  }
  for (const std::size_t line : rig.end_step(states, time(), spec.step))
    for (const BodyId body : {spec.lines[line].first.body, spec.lines[line].second.body})
      if (body != kWorld) stepper.forget(body);
  errors.add(overlaps);
  if (water) water->end_step(steps, bodies, times.water());
  ++steps;
  if (spec.suction) advance_suction(*spec.suction, stepper.contact_forces(), spec.step, bodies);
  errors.add(world.frames_of_joints(), states, time());
}

std::vector<BodyForces> Simulation::Impl::forces() {
  if (!spec.record_work) throw std::logic_error("the simulation keeps no record of work");
  std::vector<BodyForces> forces(bodies.size());
  const std::vector<hydro::Wrench> lines = rig.loads_now(states, time());
  context.parallel_for(bodies.size(), [&](std::size_t i) {
    forces[i] = forces_on(bodies[i], lines[i], time(), spec.step);
  });
  return forces;
}

SimulationState Simulation::Impl::state() const {
  auto data = std::make_shared<SimulationState::Data>();
  data->steps = steps;
  for (const MovingBody& moving : bodies)
    data->bodies.push_back({.motion = moving.motion,
                            .inputs = moving.inputs,
                            .counts = moving.counts,
                            .water_state = moving.cache.carried_water == moving.motion.carried_water
                                               ? moving.cache.water_state
                                               : std::nullopt});
  data->stepper = stepper.state();
  data->rig = rig.state();
  data->errors = errors;
  if (water) data->water = water->state();
  return SimulationState(std::move(data));
}

void Simulation::Impl::restore(const SimulationState::Data& data) {
  if (data.bodies.size() != bodies.size() || !stepper.fits(data.stepper) || !rig.fits(data.rig))
    throw std::invalid_argument(
        fmt::format("the state is that of another scene: it has {} bodies, the simulation {}",
                    data.bodies.size(), bodies.size()));
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (const char* difference = misfit(bodies[i], data.bodies[i].motion))
      throw std::invalid_argument(fmt::format(
          "the state is that of another scene: body '{}' has {}", spec.bodies[i].name, difference));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].motion = data.bodies[i].motion;
    bodies[i].motion.carried_water = completed(bodies[i].body, data.bodies[i].motion.carried_water);
    bodies[i].inputs = data.bodies[i].inputs;
    bodies[i].counts = data.bodies[i].counts;
    restore_cache(bodies[i], data.bodies[i].water_state);
    states[i] = bodies[i].motion.state;
  }
  if (water) water->restore(data.water);
  stepper.restore(data.stepper);
  steps = data.steps;
  rig.restore(data.rig, time(), spec.step);
  errors = data.errors;
  broken = false;
}

void Simulation::Impl::give_up(const OdeFault& fault) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto state = state_fault(world.state(static_cast<BodyId>(i)));
    if (!state) continue;
    throw SimulationError(
        time(), spec.bodies[i].name,
        fmt::format("{}; {} ({})", *state, largest_load(bodies[i].cache.loads), fault.what()));
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

std::vector<Works> Simulation::works() const {
  std::vector<Works> works;
  for (const MovingBody& moving : impl_->bodies)
    if (moving.motion.work) works.push_back(works_of(moving.body, moving.motion));
  return works;
}

std::vector<InteriorState> Simulation::interiors() const {
  std::vector<InteriorState> interiors;
  for (const MovingBody& moving : impl_->bodies)
    interiors.push_back(interior_state(moving, time()));
  return interiors;
}
RigReadings Simulation::rig() const { return impl_->readings(); }
const hydro::SimulatedWater* Simulation::water() const {
  return impl_->water ? &impl_->water->water() : nullptr;
}
const Timings& Simulation::timings() const { return impl_->times.timings(); }

const ConstraintErrors& Simulation::constraint_errors() const { return impl_->errors; }

Skips Simulation::skips() const {
  const auto feels_water = [](const MovingBody& moving) {
    return moving.body.wet || moving.body.has_added_mass;
  };
  return {.collision = !impl_->context.collides,
          .water = std::none_of(impl_->bodies.begin(), impl_->bodies.end(), feels_water)};
}

std::vector<Counts> Simulation::counts() const {
  std::vector<Counts> counts;
  for (const MovingBody& moving : impl_->bodies) counts.push_back(moving.counts);
  return counts;
}

void Simulation::apply(BodyId body, const hydro::Wrench& wrench, Frame frame,
                       const Eigen::Vector3d& at_B) {
  MovingBody& moving = impl_->body(body);
  if (!wrench.force.allFinite() || !wrench.moment.allFinite() || !at_B.allFinite())
    throw std::invalid_argument(
        fmt::format("the load on body '{}' is not finite", moving.body.spec->name));
  moving.inputs.loads.push_back({.force = wrench.force,
                                 .torque = wrench.moment,
                                 .in_body_frame = frame == Frame::body,
                                 .at_B = at_B});
}

void Simulation::set(const std::string& set_point, double value) {
  set(impl_->rig.set_points().find(set_point), value);
}

void Simulation::set(SetPointId set_point, double value) {
  const std::string& name = impl_->set_point(set_point).name;
  if (!std::isfinite(value))
    throw std::invalid_argument(fmt::format("the value of '{}' is not finite", name));
  impl_->rig.set_points().set(set_point, value);
}

void Simulation::release(const std::string& set_point) {
  release(impl_->rig.set_points().find(set_point));
}

void Simulation::release(SetPointId set_point) {
  impl_->set_point(set_point);
  impl_->rig.set_points().set(set_point, std::nullopt);
}

std::optional<double> Simulation::set_value(SetPointId set_point) const {
  impl_->set_point(set_point);
  return impl_->rig.set_points().states()[set_point].outside;
}

void Simulation::pull(BodyId body, const std::optional<Pull>& pull) {
  std::optional<Pull>& input = impl_->body(body).inputs.pull;
  input = pull;
  if (input) input->rate = std::min(input->rate, kFastestPull / impl_->spec.step);
}

void Simulation::set_motion(BodyId body, const hydro::BodyState& state) {
  MovingBody& moving = impl_->body(body);
  check_initial_state(*moving.body.spec, state);
  const hydro::BodyState allowed = displaced(moving.body, state, Vector6d::Zero());
  moving.motion = motion_at(moving.body, impl_->spec, allowed, impl_->time());
  impl_->stepper.forget(body);
  impl_->states[body] = moving.motion.state;
  impl_->rig.settle(body, impl_->states, impl_->time());
}

SimulationState Simulation::state() const {
  if (impl_->broken)
    throw SimulationError(time(), "", "a step has failed, so there is no state to save");
  return impl_->state();
}
void Simulation::restore(const SimulationState& state) { impl_->restore(state.data()); }
void Simulation::reset() { impl_->restore(impl_->start->data()); }

void Simulation::stop_if(StopCheck stop) { impl_->stop = std::move(stop); }

void Simulation::step() {
  Impl& impl = *impl_;
  if (impl.broken)
    throw SimulationError(time(), "", "the simulation has stopped on an earlier error");
  impl.broken = true;
  impl.begin_step();
  const double collision_before = impl.world.collision_seconds();
  double wall = 0;
  std::vector<Overlap> overlaps;
  try {
    const Stopwatch stopwatch(wall);
    if (impl.spec.integrator.method == Integrator::Method::split)
      overlaps = impl.stepper.advance(time());
    else
      overlaps = ode_step(impl.context, time(), impl.spec.step);
    impl.move_lines();
  } catch (const MotionFault& fault) {
    throw SimulationError(time(), fault.body(), fault.what());
  } catch (const OdeFault& fault) {
    impl.give_up(fault);
  }
  impl.times.add(impl.bodies, impl.spec.threads, wall,
                 impl.world.collision_seconds() - collision_before);
  impl.accept_step(overlaps);
  impl.broken = false;
}

}  // namespace engine

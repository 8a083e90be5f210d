#include "engine/simulation_state.h"

#include <limits>

#include "hydro/added_mass/added_mass.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "tests/engine/prelude.h"

/// A run that is continued from a restored state against one that was never interrupted.

namespace {

using engine::SimulationState;

constexpr long kSaved = 15;  // Steps before the state is taken.
constexpr long kEnd = 32;

hydro::Sea waves() {
  hydro::Sea sea{.gravity = kGravity};
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.15, 6, 0.3, 0.2, kGravity),
                                    hydro::deep_water_wave(0.05, 3, -0.5, 1, kGravity)}};
  return sea;
}

std::shared_ptr<const hydro::AddedMassModel> wetted(const hydro::TriMesh& mesh_B) {
  return std::make_shared<hydro::WettedAddedMass>(
      mesh_B, hydro::solve_added_mass(mesh_B, {.tolerance = 0.1}));
}

/// A box with all loads of the water.
BodySpec floating_box(const Vector3d& position) {
  BodySpec box = support::box_body("box", {2, 1.4, 0.6}, 500, position);
  box.wet = true;
  box.coefficients.lift = 0.1;
  box.initial.orientation = Eigen::AngleAxisd(0.2, Vector3d(1, 2, 3).normalized());
  box.initial.angular_velocity = {0.3, -0.2, 0.5};
  return box;
}

BodySpec with_added_mass(BodySpec body) {
  static const auto model = wetted(body.mesh_B);
  body.added_mass = model;
  return body;
}

SimulationSpec in_waves(std::vector<BodySpec> bodies) {
  SimulationSpec spec = support::dry_world(std::move(bodies), 1.0 / 30);
  spec.sea = waves();
  return spec;
}

SimulationSpec free_bodies() {
  BodySpec swung = with_added_mass(floating_box({8, 0, 1.5}));
  swung.loads = {{.force = {0, 500, 0}, .at_B = {1, 0, 0}, .sine = {{.frequency = 0.8}}}};
  BodySpec locked = with_added_mass(floating_box({0, 9, 0.3}));
  locked.locked = {true, true, false, false, false, true};
  return in_waves({with_added_mass(floating_box({0, 0, 0.4})), swung, locked});
}

SimulationSpec jointed_bodies() {
  SimulationSpec spec = in_waves({});
  for (int i = 0; i < 3; ++i) {
    BodySpec box = with_added_mass(floating_box({2.5 * i, 0, 0.2}));
    box.initial.orientation.setIdentity();
    spec.bodies.push_back(box);
  }
  spec.joints = {{.first = 0, .second = 1, .anchor_W = {1.25, 0, 0.2}},
                 {.type = JointSpec::Type::hinge,
                  .first = 1,
                  .second = 2,
                  .anchor_W = {3.75, 0, 0.2},
                  .axis_W = Vector3d::UnitY()}};
  return spec;
}

SimulationSpec touching_bodies() {
  SimulationSpec spec = in_waves({});
  for (int i = 0; i < 3; ++i) {
    BodySpec box = with_added_mass(floating_box({0.1 * i, 0, 0.2 + 0.9 * i}));
    box.collision = i == 1 ? CollisionShape::mesh : CollisionShape::box;
    spec.bodies.push_back(box);
  }
  spec.ground = engine::PlaneGround{-0.4};
  return spec;
}

/// Bodies on a hinge, a slider and a ball joint, another that the last one hits.
SimulationSpec reduced_joints() {
  SimulationSpec spec = in_waves({});
  int i = 0;
  for (const auto type : {JointSpec::Type::hinge, JointSpec::Type::slider, JointSpec::Type::ball}) {
    const Vector3d place(0, 5 * i, 0.2);
    spec.bodies.push_back(with_added_mass(floating_box(place)));
    spec.joints.push_back({.type = type,
                           .first = i++,
                           .anchor_W = place + Vector3d(-1.2, 0, 0.3),
                           .axis_W = Vector3d(0.1, 1, 0.3).normalized()});
  }
  spec.bodies.push_back(with_added_mass(floating_box({0.3, 10, 1.2})));
  spec.bodies[2].collision = spec.bodies[3].collision = CollisionShape::box;
  return spec;
}

/// Bodies that do not move in water that does not either: their loads are those of the step before.
SimulationSpec resting_bodies() {
  SimulationSpec spec = support::dry_world({}, 1.0 / 30);
  spec.sea = hydro::Sea{.gravity = kGravity};
  spec.gravity = 0;
  for (const double x : {0.0, 5.0}) {
    BodySpec box = support::box_body("box", {1, 1, 1}, 1000, {x, 0, -5});
    box.wet = true;
    box.coefficients.buoyancy = false;
    spec.bodies.push_back(box);
  }
  return spec;
}

SimulationSpec with_tolerance(SimulationSpec spec) {
  spec.integrator.tolerance = 1e-3;
  return spec;
}

SimulationSpec with_record(SimulationSpec spec) {
  spec.record_work = true;
  return spec;
}

SimulationSpec by_plain_method(SimulationSpec spec) {
  spec.integrator.method = engine::Integrator::Method::ode;
  for (BodySpec& body : spec.bodies) body.added_mass = nullptr;
  return spec;
}

struct Scene {
  const char* name;
  SimulationSpec (*spec)();
};

const Scene kScenes[] = {
    {"free", free_bodies},
    {"jointed", jointed_bodies},
    {"touching", touching_bodies},
    {"reduced joints", reduced_joints},
    {"resting", resting_bodies},
    {"free, within a tolerance", [] { return with_tolerance(free_bodies()); }},
    {"touching, within a tolerance", [] { return with_tolerance(touching_bodies()); }},
    {"jointed, with a record of work", [] { return with_record(jointed_bodies()); }},
    {"touching, with a record of work", [] { return with_record(touching_bodies()); }},
    {"touching, by the plain method", [] { return by_plain_method(touching_bodies()); }},
    {"jointed, by the plain method", [] { return by_plain_method(jointed_bodies()); }}};

/// What a program does before a step of a run: a pull and a load begin before the state is saved
/// and act after it.
void intervene(Simulation& simulation, long step) {
  if (step == kSaved - 10) simulation.pull(0, engine::Pull{.at_B = {0.5, 0, 0}, .to_W = {1, 2, 3}});
  if (step == kSaved + 8) simulation.pull(0, std::nullopt);
  if (step == kSaved || step == kSaved + 5)
    simulation.apply(1, {.force = {900, 0, 400}, .moment = {0, 90, 0}}, engine::Frame::body,
                     {0.2, 0.1, 0});
}

/// Steps to the end. @param intervened   What is done before the first step has been done.
std::string finished(Simulation& simulation, bool intervened) {
  while (simulation.steps() < kEnd) {
    if (!intervened) intervene(simulation, simulation.steps());
    intervened = false;
    simulation.step();
  }
  return simulation.state().to_bytes();
}

/// The state before step kSaved, after what is done before it.
SimulationState saved_state(Simulation& simulation) {
  while (simulation.steps() < kSaved) {
    intervene(simulation, simulation.steps());
    simulation.step();
  }
  intervene(simulation, kSaved);
  return simulation.state();
}

/// True without printing two long strings of bytes if not.
bool same(const std::string& a, const std::string& b) { return a == b; }

class ContinuedRun : public testing::TestWithParam<Scene> {};

TEST_P(ContinuedRun, HasTheSameBytesAtAnyNumberOfThreads) {
  SCOPED_TRACE(GetParam().name);
  SimulationSpec spec = GetParam().spec();
  Simulation whole(spec);
  const std::string end = finished(whole, false);
  for (const int threads : {1, 2}) {
    SCOPED_TRACE(threads);
    spec.threads = threads;
    Simulation first(spec);
    const SimulationState state = saved_state(first);
    EXPECT_TRUE(same(finished(first, true), end)) << "not interrupted";
    first.restore(state);
    EXPECT_TRUE(same(finished(first, true), end)) << "restored into the same simulation";
    Simulation second(spec);
    second.restore(SimulationState::from_bytes(state.to_bytes()));
    EXPECT_TRUE(same(finished(second, true), end)) << "restored from bytes into a new one";
  }
}

INSTANTIATE_TEST_SUITE_P(SimulationState, ContinuedRun, testing::ValuesIn(kScenes));

TEST(SimulationState, RestoresASimulationThatHasGoneAnotherWay) {
  for (const Scene& scene : kScenes) {
    SCOPED_TRACE(scene.name);
    const SimulationSpec spec = scene.spec();
    Simulation first(spec);
    const SimulationState state = saved_state(first);
    const std::string end = finished(first, true);
    Simulation other(spec);
    BodyState thrown = spec.bodies[0].initial;
    thrown.position += Vector3d(0.3, -0.2, 0.5);
    thrown.angular_velocity = {2, 1, -1};
    other.set_motion(0, thrown);
    other.pull(1, engine::Pull{.to_W = {0, 0, 3}});
    for (int i = 0; i < 40; ++i) other.step();
    other.restore(state);
    EXPECT_EQ(other.steps(), kSaved);
    EXPECT_TRUE(same(other.state().to_bytes(), state.to_bytes()));
    EXPECT_TRUE(same(finished(other, true), end));
  }
}

TEST(SimulationState, KnowsTheLoadsThatTheNextStepNeedNotFind) {
  Simulation simulation(resting_bodies());
  for (int i = 0; i < 5; ++i) simulation.step();
  const long before = simulation.counts()[0].resting;
  EXPECT_GT(before, 0);
  simulation.restore(simulation.state());
  simulation.step();
  EXPECT_GT(simulation.counts()[0].resting, before);
}

TEST(SimulationState, ComesBackFromItsBytesAsItWas) {
  for (const Scene& scene : kScenes) {
    SCOPED_TRACE(scene.name);
    Simulation simulation(scene.spec());
    const SimulationState state = saved_state(simulation);
    const SimulationState back = SimulationState::from_bytes(state.to_bytes());
    EXPECT_EQ(back.steps(), kSaved);
    EXPECT_TRUE(same(back.to_bytes(), state.to_bytes()));
  }
}

TEST(SimulationState, IsNotChangedByTheStepsAfterIt) {
  Simulation simulation(free_bodies());
  const SimulationState state = saved_state(simulation);
  const std::string bytes = state.to_bytes();
  finished(simulation, true);
  EXPECT_TRUE(same(state.to_bytes(), bytes));
}

/// The bytes of a small state that has all its parts.
std::string small_state() {
  Simulation simulation(with_record(free_bodies()));
  simulation.pull(0, engine::Pull{});
  for (int i = 0; i < 4; ++i) simulation.step();
  simulation.apply(0, {.force = {1, 2, 3}});
  return simulation.state().to_bytes();
}

TEST(SimulationState, RefusesBytesThatAreCutAnywhere) {
  const std::string bytes = small_state();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_THROW(SimulationState::from_bytes(std::string_view(bytes).substr(0, size)),
                 std::invalid_argument)
        << size << " of " << bytes.size();
}

TEST(SimulationState, RefusesBytesThatAreLongerOrOfAnotherKind) {
  const std::string bytes = small_state();
  EXPECT_THROW(SimulationState::from_bytes(bytes + '\0'), std::invalid_argument);
  EXPECT_THROW(SimulationState::from_bytes(bytes + bytes), std::invalid_argument);
  EXPECT_THROW(SimulationState::from_bytes(' ' + bytes), std::invalid_argument);
  EXPECT_THROW(SimulationState::from_bytes("time,box.x\n0,1\n"), std::invalid_argument);
  EXPECT_THROW(SimulationState::from_bytes(std::string(bytes.size(), '\xff')),
               std::invalid_argument);
}

TEST(SimulationState, RefusesBytesOfWhichOneHasChanged) {
  const std::string bytes = small_state();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x41);
    ASSERT_THROW(SimulationState::from_bytes(changed), std::invalid_argument) << i;
  }
}

TEST(SimulationState, OfOtherBodiesIsRefused) {
  Simulation three(free_bodies());
  SimulationSpec spec = free_bodies();
  spec.bodies.pop_back();
  Simulation two(spec);
  EXPECT_THROW(two.restore(three.state()), std::invalid_argument);
  EXPECT_EQ(two.states()[0], spec.bodies[0].initial);
}

TEST(SimulationState, LetsASimulationGoOnAfterAnError) {
  SimulationSpec spec = free_bodies();
  spec.bodies[0].loads = {{.force = {1e15, 0, 0}, .start = 0.5}};
  Simulation simulation(spec);
  const SimulationState start = simulation.state();
  while (simulation.time() < 0.49) simulation.step();
  EXPECT_THROW(simulation.step(), engine::SimulationError);
  EXPECT_THROW(simulation.step(), engine::SimulationError);
  simulation.restore(start);
  EXPECT_NO_THROW(simulation.step());
  EXPECT_EQ(simulation.steps(), 1);
}

// A step that fails may have moved some of the bodies and not others.
TEST(SimulationState, CannotBeTakenAfterAnError) {
  SimulationSpec spec = free_bodies();
  spec.bodies[2].loads = {{.torque = {0, 0, std::numeric_limits<double>::quiet_NaN()}}};
  Simulation simulation(spec);
  EXPECT_THROW(simulation.step(), engine::SimulationError);
  EXPECT_THROW(simulation.state(), engine::SimulationError);
  simulation.reset();
  EXPECT_EQ(simulation.state().steps(), 0);
}

}  // namespace

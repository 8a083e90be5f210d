#include "engine/sleep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/energy.h"
#include "engine/simulation.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "tests/engine/specs.h"
#include "tests/support/tolerance.h"

/// Which islands fall asleep and wake, and how far that leaves them from those that stay awake.

namespace {

using Eigen::Vector3d;
using engine::BodySpec;
using engine::CollisionShape;
using engine::JointSpec;
using engine::Simulation;
using engine::SimulationSpec;
using support::kGravity;
using support::tolerance;

constexpr double kLimit = 1e-3;          // [m/s]
constexpr double kFrameTime = 1.0 / 60;  // [s]

SimulationSpec on_still_water(std::vector<BodySpec> bodies) {
  for (BodySpec& body : bodies) body.wet = true;
  SimulationSpec spec = support::dry_world(std::move(bodies), kFrameTime);
  spec.sea = hydro::Sea{.gravity = kGravity};
  return spec;
}

/// A box that floats flat, half immersed, `lift` above that.
BodySpec raft(const std::string& name, const Vector3d& size, double x, double lift = 0) {
  return support::box_body(name, size, 500, {x, 0, lift}, 2);
}

/// A raft of 4 m and its half diagonal.
const Vector3d kRaft(4, 4, 1);
const double kRaftRadius = kRaft.norm() / 2;
constexpr double kDraft = 0.5;  // [m]

/// How long a body of that radius has to be still [s]: half a roll with GM = radius/16.
double still_time(double radius) { return 4 * std::numbers::pi * std::sqrt(radius / kGravity); }

SimulationSpec with_sleep(SimulationSpec spec, double limit = kLimit) {
  spec.integrator.sleep = limit;
  return spec;
}

Simulation run_for(SimulationSpec spec, double time) {
  const double step = spec.step;
  return support::after(std::move(spec), support::steps_in(time, step));
}

bool at_rest(const hydro::BodyState& state) {
  return state.linear_velocity.isZero(0) && state.angular_velocity.isZero(0);
}

TEST(Sleep, ABodyAtRestAfloatSleepsAfterHalfAPeriodOfItsSlowestSwing) {
  Simulation simulation(with_sleep(on_still_water({raft("raft", kRaft, 0)})));
  const double wait = still_time(kRaftRadius);
  while (simulation.skips().asleep_steps[0] == 0 && simulation.time() < 2 * wait) simulation.step();
  // It is laid down at the end of a step and the next one is the first without it.
  EXPECT_NEAR(simulation.time(), wait, 2.01 * kFrameTime);
  EXPECT_TRUE(at_rest(simulation.states()[0]));
}

/// Drag of the square of the speed alone brings a raft that bobs by 0.1 m below this in 20 s.
constexpr double kSlowBob = 0.1;

SimulationSpec bobbing() { return on_still_water({raft("raft", kRaft, 0, 0.1)}); }

TEST(Sleep, ABobbingRaftStopsWithinTheSwingOfItsLimit) {
  const Simulation sleeping = run_for(with_sleep(bobbing(), kSlowBob), 60);
  const Simulation awake = run_for(bobbing(), 60);
  ASSERT_GT(sleeping.skips().asleep_steps[0], 1000);
  EXPECT_GT(awake.states()[0].linear_velocity.norm(), 0.1 * kSlowBob);
  const double swing = kSlowBob / std::sqrt(kGravity / kDraft);
  EXPECT_LT(std::abs(sleeping.states()[0].position.z()), tolerance(swing));
  EXPECT_LT(support::distance(sleeping.states()[0], awake.states()[0]), tolerance(2 * swing));
}

TEST(Sleep, ASleeperStaysWhereItIsAndFallingAsleepOnlyTakesEnergy) {
  const SimulationSpec spec = with_sleep(bobbing(), kSlowBob);
  Simulation simulation(spec);
  double before = 0;
  while (simulation.steps() == 0 || !at_rest(simulation.states()[0])) {
    before = engine::total_energy(spec, simulation.states());
    ASSERT_LT(simulation.time(), 60);
    simulation.step();
  }
  EXPECT_LE(engine::total_energy(spec, simulation.states()), before);
  const hydro::BodyState laid_down = simulation.states()[0];
  const engine::Path path = simulation.paths()[0];
  for (int i = 0; i < 1000; ++i) simulation.step();
  EXPECT_EQ(simulation.skips().asleep_steps[0], 1000);
  EXPECT_EQ(simulation.states()[0], laid_down);
  EXPECT_EQ(simulation.paths()[0].free, path.free);
  EXPECT_EQ(simulation.paths()[0].pieces, path.pieces);
}

TEST(Sleep, WhatIsFasterThanTheLimitOrTurnsStaysAwake) {
  BodySpec drifter = raft("drifter", kRaft, 0), spinner = raft("spinner", kRaft, 10);
  for (BodySpec* body : {&drifter, &spinner})
    body->coefficients = {
        .pressure_drag = {0, 0}, .lift = 0, .viscous_drag = {hydro::ViscousDrag::Law::none, 0}};
  drifter.initial.linear_velocity.x() = 1.01 * kLimit;
  // Its rim moves at the limit.
  spinner.initial.angular_velocity.z() = 1.01 * kLimit / kRaftRadius;
  const SimulationSpec spec = on_still_water({drifter, spinner});
  const Simulation simulation = run_for(with_sleep(spec), 20);
  EXPECT_EQ(simulation.skips().asleep_steps, (std::vector<long>{0, 0}));
  EXPECT_EQ(simulation.states(), run_for(spec, 20).states());
  const Simulation with_more = run_for(with_sleep(spec, 1.02 * kLimit), 20);
  EXPECT_GT(with_more.skips().asleep_steps[0], 0);
  EXPECT_GT(with_more.skips().asleep_steps[1], 0);
}

TEST(Sleep, NothingSleepsInWavesOrWithoutGravityOrWhenItDriftsWithACurrent) {
  SimulationSpec waves = on_still_water({raft("raft", kRaft, 0)});
  waves.sea->surface = hydro::WaveSurface{{hydro::deep_water_wave(0, 10, 0, 0, kGravity)}};
  SimulationSpec current = on_still_water({raft("raft", kRaft, 0)});
  current.sea->current.x() = 0.1;
  current.bodies[0].initial.linear_velocity.x() = 0.1;
  SimulationSpec weightless = support::dry_world({raft("raft", kRaft, 0)}, kFrameTime);
  weightless.gravity = 0;
  for (const SimulationSpec& spec : {waves, current, weightless}) {
    const Simulation simulation = run_for(with_sleep(spec), 20);
    EXPECT_EQ(simulation.skips().asleep_steps[0], 0);
    EXPECT_EQ(simulation.states(), run_for(spec, 20).states());
  }
}

TEST(Sleep, ALoadThatIsStillToChangeKeepsABodyAwake) {
  const double wait = still_time(kRaftRadius);
  const auto pushed = [&](const engine::AppliedLoad& load) {
    BodySpec body = raft("raft", kRaft, 0);
    body.loads = {load};
    return on_still_water({body});
  };
  const Vector3d push(100, 0, 0);
  const double late = 2 * wait;
  for (const SimulationSpec& spec :
       {pushed({.force = push, .start = late}), pushed({.force = 0 * push, .end = late}),
        pushed({.force = 0 * push, .sine = engine::AppliedLoad::Sine{.frequency = 1}})}) {
    EXPECT_EQ(run_for(with_sleep(spec), 1.2 * late).states(), run_for(spec, 1.2 * late).states());
  }
  // After the last change it sleeps like another.
  const SimulationSpec ends = pushed({.force = 0 * push, .end = late});
  EXPECT_EQ(run_for(with_sleep(ends), late + 0.9 * wait).skips().asleep_steps[0], 0);
  EXPECT_GT(run_for(with_sleep(ends), late + 1.1 * wait).skips().asleep_steps[0], 0);
}

/// A raft and a crate that is held up over it for 12 s.
SimulationSpec crate_over_raft() {
  BodySpec below = raft("raft", kRaft, 0);
  BodySpec crate = support::box_body("crate", {1, 1, 1}, 300, {0.3, 0.2, 2}, 2);
  crate.loads = {{.force = {0, 0, crate.mass * kGravity}, .end = 12}};
  below.collision = crate.collision = CollisionShape::box;
  return on_still_water({below, crate});
}

/// It falls onto the raft, which sleeps or does not.
void expect_to_wake(const SimulationSpec& spec) {
  Simulation simulation(with_sleep(spec)), awake(spec);
  double apart = 0;
  long slept = 0;
  while (simulation.time() < 16) {
    simulation.step();
    awake.step();
    for (std::size_t i = 0; i < 2; ++i)
      apart = std::max(apart, support::distance(simulation.states()[i], awake.states()[i]));
    if (simulation.time() < 12) slept = simulation.skips().asleep_steps[0];
  }
  EXPECT_NEAR(static_cast<double>(slept) * kFrameTime, 12 - still_time(kRaftRadius),
              3 * kFrameTime);
  EXPECT_GT(awake.paths()[0].constrained, 0);
  EXPECT_GT(simulation.states()[0].linear_velocity.norm(), 0.1 * kLimit);
  // It falls by 1 m until it is near.
  EXPECT_NEAR(static_cast<double>(simulation.skips().asleep_steps[0] - slept) * kFrameTime,
              std::sqrt(2 / kGravity), 3 * kFrameTime);
  // The raft lies where it floats but for round-off, which the impact and the swings after it make
  // no more than a million times as large.
  EXPECT_LT(apart, tolerance(1e-9));
}

TEST(Sleep, AFallingBoxWakesTheRaftThatItLandsOn) {
  expect_to_wake(crate_over_raft());
  SimulationSpec accurate = crate_over_raft();
  accurate.integrator.tolerance = 1e-3;
  expect_to_wake(accurate);
}

TEST(Sleep, WhatARaftStillBobbedByIsAllThatAnImpactOnASleeperDiffersBy) {
  SimulationSpec spec = crate_over_raft();
  constexpr double kBob = 0.01;  // [m]
  spec.bodies[0].initial.position.z() = kBob;
  Simulation simulation(with_sleep(spec, kSlowBob)), awake(spec);
  double before = 0, apart = 0;
  while (simulation.time() < 16) {
    simulation.step();
    awake.step();
    double& most = simulation.time() < 12 ? before : apart;
    for (std::size_t i = 0; i < 2; ++i)
      most = std::max(most, support::distance(simulation.states()[i], awake.states()[i]));
  }
  EXPECT_GT(simulation.skips().asleep_steps[0], 200);
  EXPECT_GT(before, 0.5 * kBob);
  EXPECT_LT(before, tolerance(2 * kBob));
  // The impact makes no more of it: the raft is pushed down from where it is, and stable.
  EXPECT_LT(apart, tolerance(2 * kBob));
}

TEST(Sleep, AFallingBoxWakesARaftOnAGuide) {
  SimulationSpec spec = crate_over_raft();
  spec.joints = {{.name = "guide",
                  .type = JointSpec::Type::slider,
                  .first = 0,
                  .second = engine::kWorld,
                  .axis_W = Vector3d::UnitZ()}};
  expect_to_wake(spec);
}

/// Three rafts on hinges, and one apart.
SimulationSpec chain() {
  SimulationSpec spec = on_still_water({raft("a", {2, 2, 1}, 0), raft("b", {2, 2, 1}, 2.5),
                                        raft("c", {2, 2, 1}, 5), raft("d", {2, 2, 1}, 30)});
  for (const int i : {0, 1})
    spec.joints.push_back({.name = "hinge",
                           .type = JointSpec::Type::hinge,
                           .first = i,
                           .second = i + 1,
                           .anchor_W = {1.25 + 2.5 * i, 0, 0},
                           .axis_W = Vector3d::UnitY()});
  return spec;
}

TEST(Sleep, AChainSleepsAndWakesAsOne) {
  SimulationSpec spec = chain();
  BodySpec crate = support::box_body("crate", {0.5, 0.5, 0.5}, 300, {5, 0, 3});
  crate.wet = true;
  const double falls = 20;
  crate.loads = {{.force = {0, 0, crate.mass * kGravity}, .end = falls}};
  spec.bodies.push_back(crate);
  for (BodySpec& body : spec.bodies) body.collision = CollisionShape::box;
  Simulation simulation(with_sleep(spec));
  while (simulation.time() < falls) simulation.step();
  const std::vector<long> before = simulation.skips().asleep_steps;
  EXPECT_GT(before[0], 0);
  EXPECT_EQ(before[1], before[0]);
  EXPECT_EQ(before[2], before[0]);
  EXPECT_GT(before[3], before[0]);  // it is smaller by itself
  EXPECT_EQ(before[4], 0);
  while (simulation.time() < falls + 3) simulation.step();
  const std::vector<long> woken = simulation.skips().asleep_steps;
  EXPECT_EQ(woken[1], woken[0]);
  EXPECT_EQ(woken[2], woken[0]);
  // The crate fell onto the last of the three; the one apart sleeps on.
  EXPECT_LT(woken[0] - before[0], support::steps_in(1, kFrameTime));
  EXPECT_EQ(woken[3] - before[3], support::steps_in(3, kFrameTime));
  EXPECT_GT(simulation.states()[0].linear_velocity.norm(), 0);
}

TEST(Sleep, OneThatMovesKeepsItsIslandAwake) {
  SimulationSpec spec = chain();
  spec.bodies[2].loads = {{.torque = {0, 1e-3, 0}, .sine = engine::AppliedLoad::Sine{1, 0}}};
  const Simulation simulation = run_for(with_sleep(spec), 30);
  EXPECT_EQ(simulation.skips().asleep_steps[0], 0);
  EXPECT_EQ(simulation.skips().asleep_steps[2], 0);
  EXPECT_GT(simulation.skips().asleep_steps[3], 0);
}

/// Crates in two heaps on the ground, three high.
SimulationSpec two_heaps() {
  SimulationSpec spec = support::dry_world({}, kFrameTime);
  spec.ground = engine::PlaneGround{-1};
  for (int i = 0; i < 12; ++i) {
    const int layer = i % 3, column = i / 3 % 2, heap = i / 6;
    spec.bodies.push_back(support::box_body("crate", {1, 1, 1}, 1500,
                                            {1.05 * column + 8 * heap, 0, -0.499 + 1.001 * layer}));
    spec.bodies.back().collision = CollisionShape::box;
  }
  return spec;
}

TEST(Sleep, AHeapDoesNotWakeItselfAndDoesNotDrift) {
  const SimulationSpec spec = with_sleep(two_heaps(), 0.01);
  Simulation simulation = run_for(spec, 20);
  for (const long steps : simulation.skips().asleep_steps) ASSERT_GT(steps, 0);
  const std::vector<hydro::BodyState> then = simulation.states();
  for (int i = 0; i < 600; ++i) simulation.step();
  for (std::size_t i = 0; i < then.size(); ++i) EXPECT_EQ(simulation.states()[i], then[i]) << i;
}

/// The heaps with a crate that falls on the first one at 20 s.
SimulationSpec struck_heap() {
  SimulationSpec spec = two_heaps();
  BodySpec crate = support::box_body("crate", {1, 1, 1}, 500, {0.3, 0.1, 4});
  crate.collision = CollisionShape::box;
  crate.loads = {{.force = {0, 0, crate.mass * kGravity}, .end = 20}};
  spec.bodies.push_back(crate);
  return with_sleep(spec, 0.01);
}

TEST(Sleep, AHeapThatIsHitWakesAndTheOtherSleepsOn) {
  Simulation simulation = run_for(struck_heap(), 20);
  const std::vector<long> before = simulation.skips().asleep_steps;
  for (int i = 0; i < 120; ++i) simulation.step();
  for (std::size_t i = 0; i < 12; ++i) {
    const long more = simulation.skips().asleep_steps[i] - before[i];
    EXPECT_GT(before[i], 0);
    if (i < 6)
      EXPECT_LT(more, 60) << i;
    else
      EXPECT_EQ(more, 120) << i;
  }
}

TEST(Sleep, DoesNotDependOnTheNumberOfThreads) {
  SimulationSpec spec = struck_heap();
  const Simulation one = run_for(spec, 22);
  spec.threads = 2;
  const Simulation two = run_for(spec, 22);
  EXPECT_EQ(one.states(), two.states());
  EXPECT_EQ(one.skips().asleep_steps, two.skips().asleep_steps);
}

TEST(Sleep, TheBooksHaveWhatFallingAsleepTookAndWhatHoldsTheSleeper) {
  SimulationSpec spec = with_sleep(bobbing(), kSlowBob);
  spec.books = true;
  BodySpec& body = spec.bodies[0];
  const double added = body.mass / 2;
  body.added_mass =
      std::make_shared<hydro::ConstantAddedMass>(body.mesh_B, added * hydro::Matrix6d::Identity());
  Simulation simulation(spec);
  const double start = simulation.forces()[0].kinetic_energy;
  double brake_before = 0;
  while (simulation.steps() == 0 || !at_rest(simulation.states()[0])) {
    brake_before = simulation.forces()[0].works.brake;
    ASSERT_LT(simulation.time(), 60);
    simulation.step();
  }
  const engine::BodyForces laid_down = simulation.forces()[0];
  const double taken = brake_before - laid_down.works.brake;
  EXPECT_GT(taken, 0);
  EXPECT_LT(taken, (body.mass + added) / 2 * kSlowBob * kSlowBob);
  for (int i = 0; i < 100; ++i) simulation.step();
  const engine::BodyForces end = simulation.forces()[0];
  EXPECT_EQ(end.kinetic_energy + end.added_kinetic_energy, 0);
  EXPECT_EQ(end.works.sum(), laid_down.works.sum());
  // The velocity that was dropped was off the moved one by (2) of free_step.h.
  const double offset = kFrameTime * kFrameTime / 24 * kGravity / kDraft;
  EXPECT_LT(std::abs(end.kinetic_energy - start - end.works.sum()),
            tolerance(2 * offset * (body.mass + added) / 2 * kSlowBob * kSlowBob));
  const hydro::Wrench sum = end.water.total() + end.weight + end.applied + end.constraint;
  const double weight = end.weight.force.norm();
  EXPECT_LT(sum.force.norm() + sum.moment.norm(), tolerance(1e-12 * weight));
  EXPECT_EQ(end.added_mass.force.norm() + end.added_mass.moment.norm(), 0);
}

}  // namespace

#include <atomic>
#include <cstring>
#include <thread>

#include "tests/engine/prelude.h"
#include "tests/support/repeats.h"

namespace {

bool same_bits(const Simulation& a, const Simulation& b) {
  const auto& first = a.states();
  const auto& second = b.states();
  const auto equal = [](const auto& x, const auto& y) {
    return std::memcmp(x.data(), y.data(), sizeof(double) * static_cast<std::size_t>(x.size())) ==
           0;
  };
  bool same = first.size() == second.size();
  for (std::size_t i = 0; same && i < first.size(); ++i) {
    same = equal(first[i].position, second[i].position) &&
           equal(first[i].orientation.coeffs(), second[i].orientation.coeffs()) &&
           equal(first[i].linear_velocity, second[i].linear_velocity) &&
           equal(first[i].angular_velocity, second[i].angular_velocity);
  }
  return same;
}

constexpr int kSteps = support::repeats(300);

/// Contacts, a joint, locks, loads and water at once.
SimulationSpec busy_world() {
  using engine::CollisionShape;
  std::vector<BodySpec> bodies;
  for (int i = 0; i < 6; ++i) {
    BodySpec body = support::box_body("body", {1, 1, 1}, 400 + 50 * i, {0.3 * i, 0.2 * i, 1.5 * i});
    body.collision = i % 2 ? CollisionShape::box : CollisionShape::mesh;
    body.wet = true;
    body.initial.angular_velocity = {0.1 * i, -0.2, 0.3};
    bodies.push_back(body);
  }
  bodies[2].locked[1] = true;
  bodies[3].loads = {{.force = {100, 0, 0}, .in_body_frame = true, .at_B = {0, 0.2, 0}}};
  SimulationSpec spec = support::dry_world(bodies, 1.0 / 60);
  spec.ground = support::slope(0.1, 0.3, 5);
  spec.joints = {{.name = "j",
                  .type = engine::JointSpec::Type::ball,
                  .first = 4,
                  .second = 5,
                  .anchor_W = {1.35, 0.9, 6.75}}};
  spec.sea.emplace();
  return spec;
}

TEST(Determinism, TwoRunsGiveTheSameBits) {
  const Simulation first = support::after(busy_world(), 2 * kSteps);
  EXPECT_TRUE(same_bits(first, support::after(busy_world(), 2 * kSteps)));
}

TEST(Determinism, SimulationsThatLiveTogetherDoNotTouchEachOther) {
  Simulation first(busy_world());
  Simulation second(busy_world());
  for (int i = 0; i < kSteps; ++i) {
    first.step();
    second.step();
  }
  EXPECT_TRUE(same_bits(first, second));
  EXPECT_TRUE(same_bits(first, support::after(busy_world(), kSteps)));
}

TEST(Determinism, DoesNotDependOnTheThreadThatSteps) {
  Simulation simulation(busy_world());
  std::thread([&simulation] {
    for (int i = 0; i < kSteps; ++i) simulation.step();
  }).join();
  EXPECT_TRUE(same_bits(simulation, support::after(busy_world(), kSteps)));
}

/// A heap of crates, enough for the iterative solver, and three pairs by themselves, afloat.
SimulationSpec heaps() {
  SimulationSpec spec = support::dry_world({}, 1.0 / 60);
  spec.sea.emplace();
  for (int i = 0; i < 42; ++i) {
    const int layer = i % 3, row = i / 3 % 3, column = i / 9;
    const double apart = column == 4 ? 10 : 0;
    BodySpec body =
        support::box_body("crate", {1, 1, 1}, 300 + 10 * i,
                          {0.99 * column + apart, (apart / 5 + 0.99) * row, 0.99 * layer});
    body.collision = engine::CollisionShape::box;
    body.wet = true;
    spec.bodies.push_back(body);
  }
  return spec;
}

TEST(Determinism, HeapsDoNotDependOnTheNumberOfThreads) {
  SimulationSpec spec = heaps();
  const Simulation one = support::after(spec, 120);
  spec.threads = 2;
  EXPECT_TRUE(same_bits(one, support::after(spec, 120)));
  for (std::size_t i = 0; i < one.counts().size(); ++i) EXPECT_GT(one.counts()[i].constrained, 0);
}

TEST(Determinism, ContactsDoNotDependOnBodiesFarAway) {
  SimulationSpec many = heaps();
  // The compliance of constraints follows the lightest and the heaviest body of all.
  for (BodySpec& body : many.bodies) {
    body.mass = many.bodies.back().mass;
    body.inertia_B = many.bodies.back().inertia_B;
  }
  SimulationSpec stack = many;
  stack.bodies.assign(many.bodies.end() - 3, many.bodies.end());
  const Simulation together = support::after(many, 120), alone = support::after(stack, 120);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_GT(alone.counts()[i].constrained, 60);
    const hydro::BodyState& far = together.states()[many.bodies.size() - 3 + i];
    EXPECT_EQ(alone.states()[i].position, far.position);
    EXPECT_EQ(alone.states()[i].orientation.coeffs(), far.orientation.coeffs());
  }
}

TEST(Simulations, ManyInOneProcessComeAndGo) {
  for (int i = 0; i < 200; ++i) EXPECT_EQ(support::after(busy_world(), 2).steps(), 2);
}

TEST(Simulations, CanBeMoved) {
  Simulation first(busy_world());
  for (int i = 0; i < 100; ++i) first.step();
  Simulation second(std::move(first));
  Simulation third(busy_world());
  third = std::move(second);
  for (int i = 0; i < 100; ++i) third.step();
  EXPECT_EQ(third.steps(), 200);
  EXPECT_TRUE(same_bits(third, support::after(busy_world(), 200)));
}

TEST(Skipping, CollisionNeedsTwoThingsOfWhichOneMoves) {
  using engine::CollisionShape;
  BodySpec a = support::box_body("a", {1, 1, 1}, 1, {0, 0, 0});
  BodySpec b = support::box_body("b", {1, 1, 1}, 1, {5, 0, 0});
  const auto skips = [](const SimulationSpec& spec) { return Simulation(spec).skips().collision; };
  a.collision = CollisionShape::mesh;
  EXPECT_TRUE(skips(support::dry_world({a, b}, 0.1)));  // b passes through everything
  b.collision = CollisionShape::sphere;
  EXPECT_FALSE(skips(support::dry_world({a, b}, 0.1)));
  a.locked = b.locked = {true, true, true, true, true, true};
  EXPECT_TRUE(skips(support::dry_world({a, b}, 0.1)));
  SimulationSpec grounded = support::dry_world({a}, 0.1);
  grounded.ground = engine::PlaneGround{0};
  EXPECT_TRUE(skips(grounded));
  grounded.bodies[0].locked = {};
  EXPECT_FALSE(skips(grounded));
}

TEST(Skipping, WaterNeedsASeaAndABodyThatFeelsIt) {
  BodySpec body = support::box_body("a", {1, 1, 1}, 1, {0, 0, 0});
  const auto skips = [](const SimulationSpec& spec) { return Simulation(spec).skips().water; };
  SimulationSpec spec = support::dry_world({body}, 0.1);
  spec.sea.emplace();
  EXPECT_TRUE(skips(spec));  // the body is not wet
  spec.bodies[0].wet = true;
  EXPECT_FALSE(skips(spec));
  spec.bodies[0].coefficients = {.buoyancy = false,
                                 .pressure_drag = {0, 0},
                                 .lift = 0,
                                 .viscous_drag = {hydro::ViscousDrag::Law::none, 0}};
  EXPECT_TRUE(skips(spec));
  spec.bodies[0].coefficients = {};
  spec.sea.reset();
  EXPECT_TRUE(skips(spec));
}

TEST(StoppedStep, CanBeTakenAgainFromTheStateBefore) {
  for (const bool busy : {true, false}) {
    const SimulationSpec spec =
        busy ? busy_world()
             : support::dry_world({support::box_body("a", {1, 1, 1}, 1, {0, 0, 0})}, 0.1);
    Simulation simulation = support::after(spec, kSteps / 10);
    const engine::SimulationState before = simulation.state();
    const Simulation there = support::after(spec, kSteps / 10);
    // It is stopped at each place where it may be, until the step gets to its end.
    int looks = 0;
    for (bool ended = false; !ended; ++looks) {
      std::atomic<int> left = looks;
      simulation.stop_if([&] { return left-- <= 0; });
      try {
        simulation.step();
        ended = true;
      } catch (const engine::StepStopped&) {
        EXPECT_TRUE(same_bits(simulation, there));
        EXPECT_THROW(simulation.step(), engine::SimulationError);
        simulation.restore(before);
      }
    }
    EXPECT_GT(looks, busy ? 12 : 1);
    EXPECT_TRUE(same_bits(simulation, support::after(spec, kSteps / 10 + 1)));
  }
}

TEST(Counts, HaveTheLoadEvaluationsAboveTheWater) {
  BodySpec body = support::box_body("a", {1, 1, 1}, 500, {0, 0, 2});
  body.wet = true;
  SimulationSpec spec = support::dry_world({body}, 0.01);
  spec.sea.emplace();
  Simulation simulation(spec);
  long dry = 0;
  for (int i = 0; i < 100; ++i) {
    // Loads are found halfway through a step.
    const double t = (i + 0.5) * 0.01;
    if (2 - support::kGravity * t * t / 2 >= 0.5) ++dry;
    simulation.step();
  }
  EXPECT_GT(dry, 40);
  EXPECT_LT(dry, 70);
  EXPECT_EQ(simulation.counts()[0].dry, dry);
}

TEST(Timing, GrowsForWhatIsDone) {
  const Simulation simulation = support::after(busy_world(), 10);
  EXPECT_GT(simulation.timings().collision, 0);
  EXPECT_GT(simulation.timings().hydro, 0);
  EXPECT_GT(simulation.timings().engine, 0);
  EXPECT_GT(simulation.timings().constraints, 0);
  const Simulation dry = support::after(
      support::dry_world({support::box_body("a", {1, 1, 1}, 1, {0, 0, 0})}, 0.1), 10);
  EXPECT_EQ(dry.timings().collision, 0);
  EXPECT_EQ(dry.timings().sea, 0);
  EXPECT_EQ(dry.timings().constraints, 0);
}

}  // namespace

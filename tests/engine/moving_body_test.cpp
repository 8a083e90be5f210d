#include "engine/motion/moving_body.h"

#include <limits>
#include <numbers>

#include "tests/engine/prelude.h"

/// The loads on a body: those of the scene, of a program and of the water.

namespace {

using engine::MovingBody;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

MovingBody only_body(const SimulationSpec& spec) { return support::moving_bodies(spec)[0]; }

TEST(AppliedLoads, ActFromTheirStartUpToTheirEnd) {
  SimulationSpec spec = support::dry_world({support::box_body("a", {1, 1, 1}, 1, {0, 0, 0})}, 0.1);
  spec.bodies[0].loads = {{.force = {2, 0, 0}, .start = 0.3, .end = 0.5}};
  const MovingBody body = only_body(spec);
  const auto force = [&](double time) {
    return engine::applied_loads(body, body.motion.state, time)[0].force.x();
  };
  EXPECT_EQ(force(0.29), 0);
  EXPECT_EQ(force(3 * 0.1), 2);  // 0.30000000000000004
  EXPECT_EQ(force(0.1 + 0.2 - 1e-16), 2);
  EXPECT_EQ(force(0.49), 2);
  EXPECT_EQ(force(0.5), 0);
}

TEST(AppliedLoads, TurnWithTheBodyAndHaveALever) {
  support::Random random(6);
  SimulationSpec spec = support::dry_world({support::box_body("a", {1, 1, 1}, 1, {0, 0, 0})}, 0.1);
  const Vector3d force = random.vector(1), torque = random.vector(1), at = random.vector(1);
  spec.bodies[0].loads = {
      {.force = force, .torque = torque, .in_body_frame = true, .at_B = at},
      {.force = force, .torque = torque, .at_B = at, .sine = engine::Sine{0.5, 0.2}}};
  const MovingBody body = only_body(spec);
  const BodyState state = random.state(1, 1);
  const Matrix3d R = state.orientation.toRotationMatrix();
  const std::vector<hydro::Wrench> loads = engine::applied_loads(body, state, 0.7);
  EXPECT_LT((loads[0].force - R * force).norm(), 1e-15);
  EXPECT_LT((loads[0].moment - R * (torque + at.cross(force))).norm(), 1e-14);
  const double sine = std::sin(std::numbers::pi * 0.7 + 0.2);
  EXPECT_LT((loads[1].force - sine * force).norm(), 1e-15);
  EXPECT_LT((loads[1].moment - sine * (torque + (R * at).cross(force))).norm(), 1e-14);
}

TEST(FoundLoads, OfABodyAtRestInStillWaterAreNotFoundTwice) {
  const SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  MovingBody body = only_body(spec);
  const BodyState state = body.motion.state;
  const hydro::Wrench first = engine::find_loads(body, state, 0);
  EXPECT_NEAR(first.force.z(), 0, 1e-9);  // Half of a box of half the water's density is wet.
  EXPECT_EQ(body.counts.resting, 0);
  EXPECT_EQ(engine::find_loads(body, state, 1).force, first.force);
  EXPECT_EQ(body.counts.resting, 1);
  engine::find_loads(body, {.position = {0, 0, -0.1}}, 1);
  EXPECT_EQ(body.counts.resting, 1);
}

TEST(FoundLoads, AboveTheWaterAreTheWeight) {
  const SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  MovingBody body = only_body(spec);
  const hydro::Wrench load = engine::find_loads(body, {.position = {0, 0, 0.6}}, 0);
  EXPECT_NEAR(load.force.z(), -500 * kGravity, 1e-9);
  EXPECT_EQ(body.counts.dry, 1);
}

TEST(FoundLoads, ThatAreNotFiniteAreToldWithTheBody) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  spec.bodies[0].loads = {{.force = {kInfinite, 0, 0}}};
  MovingBody body = only_body(spec);
  try {
    engine::find_loads(body, body.motion.state, 0);
    FAIL();
  } catch (const engine::MotionFault& fault) {
    EXPECT_EQ(fault.body(), "box");
    EXPECT_NE(std::string(fault.what()).find("applied"), std::string::npos) << fault.what();
  }
}

TEST(LoadCache, IsRestoredToWhatItsStateGives) {
  const SimulationSpec spec = support::box_in_still_water({0, 0, 0.1});
  MovingBody first = only_body(spec), second = only_body(spec);
  engine::find_loads(first, first.motion.state, 0);
  engine::restore_cache(second, first.cache.water_state);
  EXPECT_EQ(second.cache.loads.water.buoyancy.force, first.cache.loads.water.buoyancy.force);
  ASSERT_TRUE(second.cache.water_state);
  engine::restore_cache(second, std::nullopt);
  EXPECT_FALSE(second.cache.water_state);
}

}  // namespace

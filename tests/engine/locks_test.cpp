#include "engine/motion/locks.h"

#include "tests/engine/prelude.h"

namespace {

using engine::DofMask;

DofMask mask(int bits) {
  DofMask locked{};
  for (int i = 0; i < 6; ++i) locked[i] = (bits >> i) & 1;
  return locked;
}

/// A body that spins, flies and is pushed in all six degrees of freedom.
BodySpec driven_body(const DofMask& locked) {
  support::Random random(4);
  BodySpec body = support::box_body("driven", {1, 2, 3}, 100, {4, -5, 6});
  body.initial = random.state(5, 3);
  body.locked = locked;
  body.loads = {{.force = {900, 800, -700}, .torque = {500, -600, 700}, .at_B = {0.1, 0.2, 0.3}}};
  return body;
}

/// How far a state has left what the locks allow.
double violation(const DofMask& locked, const hydro::BodyState& start,
                 const hydro::BodyState& state) {
  double worst = 0;
  int rotations = 0;
  Vector3d free_axis = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    if (locked[i]) {
      worst = std::max({worst, std::abs(state.position[i] - start.position[i]),
                        std::abs(state.linear_velocity[i])});
    }
    if (locked[3 + i]) {
      worst = std::max(worst, std::abs(state.angular_velocity[i]));
      ++rotations;
    } else {
      free_axis[i] = 1;
    }
  }
  const Quaterniond turn = state.orientation * start.orientation.conjugate();
  if (rotations == 3) worst = std::max(worst, turn.vec().norm());
  if (rotations == 2) worst = std::max(worst, turn.vec().cross(free_axis).norm());
  return worst;
}

TEST(Locks, EveryCombinationHoldsUnderLoadAndLeavesTheRestFree) {
  for (int bits = 0; bits < 63; ++bits) {
    SCOPED_TRACE(bits);
    const BodySpec body = driven_body(mask(bits));
    Simulation simulation(support::dry_world({body}, 0.01));
    for (int i = 0; i < 200; ++i) {
      simulation.step();
      ASSERT_LE(violation(body.locked, body.initial, simulation.states()[0]), tolerance(1e-12));
    }
    const hydro::BodyState& state = simulation.states()[0];
    for (int i = 0; i < 3; ++i) {
      const double moved = std::abs(state.position[i] - body.initial.position[i]);
      EXPECT_TRUE(body.locked[i] || moved > 0.1);
      EXPECT_TRUE(body.locked[3 + i] || std::abs(state.angular_velocity[i]) > 1e-3);
    }
  }
}

TEST(Locks, OfAllSixMakeABodyImmovable) {
  const BodySpec body = driven_body(mask(63));
  const Simulation simulation = support::after(support::dry_world({body}, 0.01), 100);
  const hydro::BodyState& state = simulation.states()[0];
  EXPECT_EQ(state.position, body.initial.position);
  EXPECT_EQ(state.orientation.coeffs(), body.initial.orientation.coeffs());
  EXPECT_EQ(state.linear_velocity, Vector3d::Zero());
  EXPECT_EQ(state.angular_velocity, Vector3d::Zero());
}

TEST(Locks, DoNotSlowFreeDegreesOfFreedom) {
  BodySpec body = driven_body(mask(0b111010));  // free: surge and heave
  body.initial.linear_velocity = Vector3d::Zero();
  const Simulation simulation = support::after(support::dry_world({body}, 0.01), 100);
  const hydro::BodyState& state = simulation.states()[0];
  // Of the locked loads no more than the compliance of the locks may leak over, 1e-10.
  EXPECT_NEAR(state.linear_velocity.x(), 900 / body.mass, tolerance(1e-9));
  EXPECT_NEAR(state.linear_velocity.z(), -700 / body.mass - support::kGravity, tolerance(1e-9));
}

TEST(Locks, LetABodyTurnAboutTheOneFreeAxisAsItWouldAboutAnAxle) {
  BodySpec body = support::box_body("wheel", {1, 2, 3}, 100, {0, 0, 0});
  body.locked = mask(0b011111);  // free: yaw
  body.loads = {{.torque = {0, 0, 250}}};
  const Simulation simulation = support::after(support::dry_world({body}, 0.01), 100);
  EXPECT_NEAR(simulation.states()[0].angular_velocity.z(), 250 / body.inertia_B(2, 2),
              tolerance(1e-9));
}

TEST(Locks, HoldABodyThatIsStruck) {
  BodySpec post = support::box_body("post", {1, 1, 1}, 100, {0, 0, 0.5});
  post.locked = mask(0b111011);  // free: heave
  BodySpec ball = support::sphere_body("ball", 0.5, 1000, {-3, 0.1, 0.6});
  ball.initial.linear_velocity = {10, 0, 0};
  post.collision = ball.collision = engine::CollisionShape::box;
  const BodySpec start = post;
  Simulation simulation(support::dry_world({post, ball}, 0.01));
  for (int i = 0; i < 100; ++i) {
    simulation.step();
    ASSERT_LE(violation(start.locked, start.initial, simulation.states()[0]), tolerance(1e-12));
  }
  EXPECT_LT(simulation.states()[1].position.x(), -0.9);  // it was stopped
}

TEST(Locks, ProjectionKeepsTheTurnAboutTheFreeAxis) {
  support::Random random(5);
  hydro::BodyState start = random.state(1, 1);
  hydro::BodyState moved = start;
  moved.orientation = Eigen::AngleAxisd(1e-6, Vector3d::UnitX()) *
                      Eigen::AngleAxisd(2.5, Vector3d::UnitZ()) * start.orientation;
  const hydro::BodyState state = engine::project_onto_locks(mask(0b011000), start, moved);
  const Quaterniond expected(Eigen::AngleAxisd(2.5, Vector3d::UnitZ()) * start.orientation);
  // The turn of 1e-6 about the locked axis is taken out; what is left is of its second order.
  EXPECT_LT((state.orientation * expected.conjugate()).vec().norm(), tolerance(1e-12));
}

}  // namespace

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/specs.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using engine::AppliedLoad;
using engine::BodySpec;
using engine::Simulation;
using engine::SimulationSpec;
using support::tolerance;

constexpr double kStep = 0.01;

// Round-off of some hundred sums of numbers up to a hundred.
constexpr double kRoundOff = 1e-11;

SimulationSpec weightless(const BodySpec& body) {
  SimulationSpec spec = support::dry_world({body}, kStep);
  spec.gravity = 0;
  return spec;
}

BodySpec brick() { return support::box_body("brick", {1, 2, 3}, 100, {4, -5, 6}); }

TEST(FreeFall, FollowsSemiImplicitEulerToRoundOff) {
  BodySpec body = brick();
  body.initial.linear_velocity = {1, -2, 3};
  const long steps = 200;
  const double t = kStep * steps;
  const Simulation simulation = support::after(support::dry_world({body}, kStep), steps);
  const hydro::BodyState& state = simulation.states()[0];
  // v = v0 - g t at the end of each step, z = z0 + the sum of h v.
  const Vector3d expected = body.initial.position + t * body.initial.linear_velocity -
                            Vector3d(0, 0, support::kGravity * t * (t + kStep) / 2);
  EXPECT_LT((state.position - expected).norm(), tolerance(kRoundOff));
  EXPECT_NEAR(state.linear_velocity.z(), 3 - support::kGravity * t, tolerance(kRoundOff));
  EXPECT_DOUBLE_EQ(simulation.time(), t);
}

TEST(FreeFall, DoesNotTurnABodyWhoseMeshIsOffItsCentreOfMass) {
  BodySpec body = brick();
  body.mesh_B = hydro::translated(body.mesh_B, {3, 1, -2});
  body.collision = engine::CollisionShape::box;
  SimulationSpec spec = support::dry_world({body}, kStep);
  spec.ground = engine::PlaneGround{-100};
  const Simulation simulation = support::after(spec, 100);
  const hydro::BodyState& state = simulation.states()[0];
  EXPECT_EQ(state.angular_velocity.norm(), 0);
  EXPECT_NEAR(state.position.z(), 6 - support::kGravity * 1.0 * 1.01 / 2, tolerance(kRoundOff));
  EXPECT_EQ(state.position.x(), 4);
}

TEST(FreeSpin, AboutAPrincipalAxisIsSteadyAndTurnsByTheExactAngle) {
  support::Random random(1);
  BodySpec body = brick();
  body.initial.orientation = random.rotation();
  const Vector3d axis = body.initial.orientation * Vector3d::UnitZ();
  body.initial.angular_velocity = 7 * axis;
  const Simulation simulation = support::after(weightless(body), 300);
  const hydro::BodyState& state = simulation.states()[0];
  const Eigen::Quaterniond expected =
      Eigen::Quaterniond(Eigen::AngleAxisd(7 * 3.0, axis)) * body.initial.orientation;
  EXPECT_LT((state.angular_velocity - 7 * axis).norm(), tolerance(kRoundOff));
  EXPECT_LT(state.orientation.angularDistance(expected), tolerance(1e-7));  // acos near 1
}

TEST(FreeSpin, NeverGainsEnergyAboutAnUnsteadyAxis) {
  BodySpec body = brick();
  body.initial.angular_velocity = {0.1, 8, -0.1};  // near the middle axis: it tumbles
  Simulation simulation(weightless(body));
  double before = support::energy(simulation.spec(), simulation.states());
  for (int i = 0; i < 2000; ++i) {
    simulation.step();
    const double now = support::energy(simulation.spec(), simulation.states());
    ASSERT_LT(now, before * (1 + tolerance(1e-12)));
    before = now;
  }
}

double momentum_error(double step) {
  BodySpec body = brick();
  body.initial.angular_velocity = {1, 2, 3};
  SimulationSpec spec = weightless(body);
  spec.step = step;
  const Simulation simulation = support::after(spec, support::steps_in(1, step));
  return (support::spin(body, simulation.states()[0]) - support::spin(body, body.initial)).norm() /
         support::spin(body, body.initial).norm();
}

TEST(FreeSpin, KeepsAngularMomentumToFirstOrder) {
  const double ratio = momentum_error(0.01) / momentum_error(0.005);
  EXPECT_NEAR(ratio, 2, tolerance(0.1));  // the second-order term is some percent at these steps
  EXPECT_LT(momentum_error(0.005), tolerance(0.02));
}

// The body frame is turned by a rotation without symmetry, so that a transposed matrix or a
// quaternion in another order would show.
TEST(AppliedLoads, InTheBodyFrameTurnWithTheBody) {
  support::Random random(2);
  BodySpec body = brick();
  body.initial.orientation = random.rotation();
  const AppliedLoad load{.force = {300, -200, 100}, .in_body_frame = true};
  body.loads = {load};
  const Simulation simulation = support::after(weightless(body), 1);
  const Vector3d expected = body.initial.orientation * load.force * kStep / body.mass;
  EXPECT_LT((simulation.states()[0].linear_velocity - expected).norm(), tolerance(1e-15));
}

TEST(AppliedLoads, OffTheCentreOfMassTurnTheBody) {
  support::Random random(3);
  BodySpec body = brick();
  body.initial.orientation = random.rotation();
  const Eigen::Matrix3d R_WB = body.initial.orientation.toRotationMatrix();
  const AppliedLoad load{.force = {300, -200, 100}, .torque = {50, 60, 70}, .at_B = {0.5, 1, -1.5}};
  body.loads = {load};
  const Simulation simulation = support::after(weightless(body), 1);
  const Vector3d moment = load.torque + (R_WB * load.at_B).cross(load.force);
  const Vector3d expected = R_WB * body.inertia_B.inverse() * R_WB.transpose() * moment * kStep;
  EXPECT_LT((simulation.states()[0].angular_velocity - expected).norm(), tolerance(1e-13));
}

TEST(AppliedLoads, ActFromTheirStartUntilBeforeTheirEnd) {
  BodySpec body = brick();
  body.loads = {{.force = {600, 0, 0}, .start = 0.3, .end = 0.7}};
  const Simulation simulation = support::after(weightless(body), 100);
  // 40 steps, from the one that starts at 0.30 s to the one that starts at 0.69 s.
  EXPECT_NEAR(simulation.states()[0].linear_velocity.x(), 600 * 0.4 / body.mass,
              tolerance(kRoundOff));
}

TEST(AppliedLoads, WithASineGiveNoImpulseOverAPeriod) {
  BodySpec body = brick();
  AppliedLoad load{.force = {600, 0, 0}};
  load.sine = {.frequency = 0.5, .phase = std::numbers::pi / 2};
  body.loads = {load};
  Simulation simulation(weightless(body));
  double fastest = 0;
  for (int i = 0; i < 200; ++i) {
    simulation.step();
    fastest = std::max(fastest, simulation.states()[0].linear_velocity.x());
  }
  EXPECT_NEAR(simulation.states()[0].linear_velocity.x(), 0, tolerance(kRoundOff));
  // The integral of F cos(π t)/m peaks at F/(π m); the sum of steps is off by half a step's share.
  EXPECT_NEAR(fastest, 600 / (std::numbers::pi * body.mass), tolerance(600 * kStep / body.mass));
}

TEST(AppliedLoads, AddUp) {
  BodySpec body = brick();
  body.loads = {{.force = {600, 0, 0}}, {.force = {-600, 300, 0}}};
  const Simulation simulation = support::after(weightless(body), 100);
  const Vector3d expected(0, 300 / body.mass, 0);
  EXPECT_LT((simulation.states()[0].linear_velocity - expected).norm(), tolerance(kRoundOff));
}

}  // namespace

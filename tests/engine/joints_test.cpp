#include <numbers>

#include "tests/engine/prelude.h"

namespace {

using Type = JointSpec::Type;

constexpr double kLength = 2;  // from anchor to centre of mass [m]

/// A rod that hangs from the origin on a joint, released at an angle from the vertical.
SimulationSpec pendulum(double angle, double step, Type type = Type::hinge) {
  const Vector3d down(std::sin(angle), 0, -std::cos(angle));
  BodySpec rod = support::box_body("rod", {0.1, 0.1, kLength}, 1000, kLength * down);
  rod.initial.orientation = Eigen::AngleAxisd(-angle, Vector3d::UnitY());
  SimulationSpec spec = support::dry_world({rod}, step);
  spec.joints = {{.name = "pivot", .type = type, .first = 0, .axis_W = Vector3d::UnitY()}};
  return spec;
}

/// Angle of the pendulum from the vertical [rad].
double angle_of(const hydro::BodyState& state) {
  return std::atan2(state.position.x(), -state.position.z());
}

/// Period from the first two downward crossings of the vertical, interpolated between steps.
double measured_period(const SimulationSpec& spec) {
  Simulation simulation(spec);
  std::vector<double> crossings;
  double before = angle_of(simulation.states()[0]);
  while (crossings.size() < 2) {
    simulation.step();
    const double now = angle_of(simulation.states()[0]);
    if (before > 0 && now <= 0) {
      crossings.push_back(simulation.time() - spec.step * now / (now - before));
    }
    before = now;
  }
  return crossings[1] - crossings[0];
}

/// Exact period of a compound pendulum released at `angle`: 2π/ω over the arithmetic-geometric mean
/// of 1 and cos(angle/2).
double exact_period(const SimulationSpec& spec, double angle) {
  const BodySpec& rod = spec.bodies[0];
  const double inertia = rod.inertia_B(1, 1) + rod.mass * kLength * kLength;
  const double omega = std::sqrt(rod.mass * spec.gravity * kLength / inertia);
  double a = 1;
  double g = std::cos(angle / 2);
  for (int i = 0; i < 6; ++i) {
    const double mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
  }
  return 2 * std::numbers::pi / (omega * a);
}

double period_error(double step, Type type) {
  constexpr double kAngle = 1;
  const SimulationSpec spec = pendulum(kAngle, step, type);
  return std::abs(measured_period(spec) / exact_period(spec, kAngle) - 1);
}

// The constraint acts halfway through each step, as in the leapfrog method.
TEST(Universal, SwingsWithThePeriodOfThePendulumToSecondOrder) {
  EXPECT_LT(period_error(0.01, Type::universal), tolerance(2e-4));
  for (const double step : {0.01, 0.005})
    EXPECT_NEAR(period_error(step, Type::universal) / period_error(step / 2, Type::universal), 4,
                tolerance(0.2));
}

// Both are reduced joints. The crossing is found on the straight line through two steps, with an
// error of (ω h)³/60 of the angle.
TEST(HingeAndBall, SwingWithThePeriodOfThePendulum) {
  EXPECT_LT(period_error(0.01, Type::hinge), tolerance(1e-6));
  EXPECT_LT(period_error(0.01, Type::ball), tolerance(1e-6));
}

/// Largest distance of the rod's end from the pivot over 20 s, relative to the length.
double anchor_drift(const SimulationSpec& spec) {
  Simulation simulation(spec);
  double drift = 0;
  for (int i = 0; i < support::steps_in(20, spec.step); ++i) {
    simulation.step();
    const hydro::BodyState& state = simulation.states()[0];
    const Vector3d anchor = state.position + state.orientation * Vector3d(0, 0, kLength);
    drift = std::max(drift, anchor.norm() / kLength);
  }
  return drift;
}

// A step turns the body by ω h while its centre moves on straight: the pivot is off by (ω h)²/2 of
// the length, of which the joint takes back 0.8 in the next step.
TEST(Joints, KeepTheirAnchorWithinTheErrorOfAStep) {
  for (const Type type : {Type::hinge, Type::ball, Type::universal}) {
    SCOPED_TRACE(static_cast<int>(type));
    EXPECT_LT(anchor_drift(pendulum(0.5, 0.01, type)), tolerance(1e-4));
    EXPECT_LT(anchor_drift(pendulum(0.5, 0.005, type)), tolerance(2.5e-5));
  }
}

TEST(Hinge, TurnsAboutItsAxisOnly) {
  SimulationSpec spec = pendulum(0.3, 0.01);
  spec.bodies[0].initial.angular_velocity = {3, 0, 2};
  const Simulation simulation = support::after(spec, 500);
  const Quaterniond turn =
      simulation.states()[0].orientation * spec.bodies[0].initial.orientation.conjugate();
  // The hinge takes the velocity about other axes out but for its compliance, and turns it back.
  EXPECT_LT(std::hypot(turn.x(), turn.z()), tolerance(1e-6));
  EXPECT_LT(std::abs(simulation.states()[0].position.y()), tolerance(1e-6));
}

TEST(Ball, LetsABodySwingInEveryDirection) {
  SimulationSpec spec = pendulum(0.3, 0.01, Type::ball);
  spec.bodies[0].initial.linear_velocity = {0, 0.5, 0};
  spec.bodies[0].initial.angular_velocity = {0.25, 0, 0.3};
  Simulation simulation(spec);
  double reach = 0;
  for (int i = 0; i < 300; ++i) {
    simulation.step();
    reach = std::max(reach, std::abs(simulation.states()[0].position.y()));
  }
  EXPECT_GT(reach, 0.1);
}

TEST(Slider, FallsAlongItsAxisWithoutTurning) {
  support::Random random(6);
  BodySpec body = support::box_body("carriage", {1, 2, 3}, 100, {4, -5, 6});
  body.initial.orientation = random.rotation();
  const Vector3d axis = Vector3d(1, 2, -2).normalized();
  SimulationSpec spec = support::dry_world({body}, 0.01);
  spec.joints = {{.name = "rail", .type = Type::slider, .second = 0, .axis_W = axis}};
  const long steps = 100;
  const Simulation simulation = support::after(spec, steps);
  const hydro::BodyState& state = simulation.states()[0];
  const double way = -support::kGravity * axis.z() * 1.0 / 2;
  EXPECT_LT((state.position - body.initial.position - way * axis).norm(), tolerance(1e-8));
  EXPECT_LT(state.angular_velocity.norm(), tolerance(1e-9));
}

TEST(Fixed, MakesTwoBodiesOne) {
  BodySpec left = support::box_body("left", {1, 1, 1}, 100, {0, 0, 0});
  BodySpec right = support::box_body("right", {1, 1, 1}, 300, {1, 0, 0});
  left.initial.linear_velocity = {0, 0, 2};
  SimulationSpec spec = support::dry_world({left, right}, 0.01);
  spec.gravity = 0;
  spec.joints = {{.name = "weld", .type = Type::fixed, .first = 0, .second = 1}};
  const Simulation simulation = support::after(spec, 1000);
  const hydro::BodyState& a = simulation.states()[0];
  const hydro::BodyState& b = simulation.states()[1];
  // The pair turns at 0.9 rad/s: (ω h)²/2 of the arm, as above.
  EXPECT_NEAR((b.position - a.position).norm(), 1, tolerance(1e-4));
  EXPECT_LT(a.orientation.angularDistance(b.orientation), tolerance(1e-6));
  EXPECT_GT(a.angular_velocity.norm(), 0.5);
  const Vector3d momentum = 100 * a.linear_velocity + 300 * b.linear_velocity;
  EXPECT_LT((momentum - Vector3d(0, 0, 200)).norm(), tolerance(1e-9));
}

TEST(Universal, KeepsItsTwoAxesAtRightAngles) {
  BodySpec shaft = support::box_body("shaft", {0.2, 0.2, 2}, 1000, {0, 0, -1});
  shaft.initial.angular_velocity = {1.5, 1, 0};
  shaft.initial.linear_velocity = shaft.initial.angular_velocity.cross(shaft.initial.position);
  SimulationSpec spec = support::dry_world({shaft}, 0.01);
  spec.joints = {{.name = "cross",
                  .type = Type::universal,
                  .first = 0,
                  .axis_W = Vector3d::UnitX(),
                  .axis2_W = Vector3d::UnitY()}};
  Simulation simulation(spec);
  double widest = 0;
  for (int i = 0; i < 500; ++i) {
    simulation.step();
    const Quaterniond& q = simulation.states()[0].orientation;
    // The axis x is fixed in the shaft, the axis y in the world.
    ASSERT_NEAR((q * Vector3d::UnitX()).dot(Vector3d::UnitY()), 0, tolerance(2e-4));
    widest = std::max(widest, std::abs(q.angularDistance(Quaterniond::Identity())));
  }
  EXPECT_GT(widest, 0.5);
}

TEST(Joints, HoldToImmovableBodiesAsToTheWorld) {
  SimulationSpec to_world = pendulum(0.4, 0.01);
  SimulationSpec to_body = to_world;
  BodySpec wall = support::box_body("wall", {1, 1, 1}, 100, {0, 0, 0.5});
  wall.locked = {true, true, true, true, true, true};
  to_body.bodies.push_back(wall);
  to_body.joints[0].second = 1;
  const hydro::BodyState a = support::after(to_world, 300).states()[0];
  const hydro::BodyState b = support::after(to_body, 300).states()[0];
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.orientation.coeffs(), b.orientation.coeffs());
}

TEST(Joints, ThatHoldTheSameMotionTwiceCanBeSolved) {
  SimulationSpec spec = pendulum(0.4, 0.01);
  spec.joints.push_back({.name = "second",
                         .type = Type::hinge,
                         .first = 0,
                         .anchor_W = {0, 0.5, 0},
                         .axis_W = Vector3d::UnitY()});
  spec.bodies[0].locked[1] = true;
  EXPECT_LT(anchor_drift(spec), tolerance(1e-4));
}

TEST(Joints, HoldBodiesOfAMillimetre) {
  constexpr double kSize = 1e-3;  // [m]
  for (const Type type : {Type::ball, Type::fixed}) {
    std::vector<BodySpec> bodies;
    for (int i = 0; i < 2; ++i)
      bodies.push_back(
          support::box_body("box", Vector3d::Constant(kSize), 1, {0, 0, -2 * kSize * i}));
    SimulationSpec spec = support::dry_world(bodies, 0.001);
    spec.joints = {{.name = "upper", .type = type, .first = 0, .anchor_W = {0, 0, kSize}},
                   {.name = "lower", .first = 0, .second = 1, .anchor_W = {0, 0, -kSize}}};
    spec.joints[1].type = type;
    const Simulation hanging = support::after(spec, 1000);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(hanging.states()[i].position.z(), bodies[i].initial.position.z(), 0.01 * kSize);
  }
}

TEST(Joints, KeepBodiesFromColliding) {
  BodySpec left = support::box_body("left", {1, 1, 1}, 100, {0, 0, 0});
  BodySpec right = support::box_body("right", {1, 1, 1}, 100, {0.5, 0, 0});
  left.collision = right.collision = engine::CollisionShape::box;
  SimulationSpec spec = support::dry_world({left, right}, 0.01);
  spec.gravity = 0;
  spec.joints = {{.name = "pin", .type = Type::ball, .first = 1, .second = 0}};
  const Simulation simulation = support::after(spec, 100);
  EXPECT_LT((simulation.states()[1].position - Vector3d(0.5, 0, 0)).norm(), tolerance(1e-12));
}

TEST(Joints, OfABodyWithItselfAreRefused) {
  SimulationSpec spec = pendulum(0.3, 0.01);
  spec.joints[0].second = 0;
  EXPECT_THROW(Simulation{spec}, std::invalid_argument);
  spec.joints[0].second = 7;
  EXPECT_THROW(Simulation{spec}, std::invalid_argument);
}

}  // namespace

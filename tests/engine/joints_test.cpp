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

double period_error(const SimulationSpec& spec, double angle) {
  return std::abs(measured_period(spec) / exact_period(spec, angle) - 1);
}

// The constraint acts halfway through each step, as in the leapfrog method.
TEST(Joints, LeftToTheSolverSwingWithThePeriodOfThePendulumToSecondOrder) {
  for (const Type type : {Type::hinge, Type::ball, Type::universal}) {
    SCOPED_TRACE(static_cast<int>(type));
    const auto error = [&](double step) {
      return period_error(support::left_to_the_solver(pendulum(1, step, type)), 1);
    };
    EXPECT_LT(error(0.01), tolerance(2e-4));
    for (const double step : {0.01, 0.005})
      EXPECT_NEAR(error(step) / error(step / 2), 4, tolerance(0.2));
  }
}

// What is left is the straight line through two steps by which the crossing is found: (ω h)³/60 of
// the angle.
TEST(ReducedJoints, SwingWithThePeriodOfThePendulum) {
  for (const Type type : {Type::hinge, Type::ball})
    EXPECT_LT(period_error(pendulum(1, 0.01, type), 1), tolerance(1e-6));
}

/// Largest distance of the rod's end from the pivot over 20 s, relative to the length.
double anchor_drift(const SimulationSpec& spec) {
  Simulation simulation(spec);
  double drift = 0;
  for (int i = 0; i < support::steps_in(20, spec.step); ++i) {
    simulation.step();
    const BodyState& state = simulation.states()[0];
    const Vector3d anchor = state.position + state.orientation * Vector3d(0, 0, kLength);
    drift = std::max(drift, anchor.norm() / kLength);
  }
  return drift;
}

TEST(Joints, LeftToTheSolverKeepTheirAnchor) {
  for (const Type type : {Type::hinge, Type::ball, Type::universal}) {
    SCOPED_TRACE(static_cast<int>(type));
    const SimulationSpec spec = support::left_to_the_solver(pendulum(0.5, 0.01, type));
    EXPECT_LT(anchor_drift(spec), tolerance(1e-9));
    EXPECT_GT(support::after(spec, 1).counts()[0].constrained, 0);
  }
}

/// The largest error of a joint in a run, over the length of its bodies, and its turn.
double largest_gap(const Simulation& simulation, double length) {
  double largest = 0;
  for (const engine::JointError& joint : simulation.constraint_errors().joints)
    largest = std::max({largest, joint.separation.value / length, joint.turn.value});
  return largest;
}

// A substep that turns a body as a whole would not see that it turns at all.
TEST(Joints, HoldBodiesThatTurnOnceAStep) {
  for (const double turn : {2 * std::numbers::pi, 6.0, 15.0}) {
    SCOPED_TRACE(turn);
    SimulationSpec spec = pendulum(0.5, 0.05);
    const double rate = turn / spec.step;
    spec.bodies[0].initial.angular_velocity = {0, rate, 0};
    spec.bodies[0].initial.linear_velocity =
        Vector3d(0, rate, 0).cross(spec.bodies[0].initial.position);
    const Simulation simulation = support::after(support::left_to_the_solver(spec), 100);
    EXPECT_LT(largest_gap(simulation, kLength), tolerance(1e-9));
    // Substeps of a quarter of a radian take some 1e-5 each of the energy.
    EXPECT_NEAR(simulation.states()[0].angular_velocity.norm() / rate, 1, tolerance(0.06));
  }
}

/// A chain of rods that hangs from the origin and is thrown sideways, every other one a thousand
/// times as heavy.
SimulationSpec thrown_chain(int links, double step) {
  std::vector<BodySpec> bodies;
  for (int i = 0; i < links; ++i) {
    bodies.push_back(
        support::box_body("link", {0.1, 0.1, 1}, i % 2 == 0 ? 1 : 1000, {0, 0, -0.5 - i}));
    bodies.back().initial.linear_velocity = {0.05 * (0.5 + i), 0.02 * (0.5 + i), 0};
    bodies.back().initial.angular_velocity = {0.02, -0.05, 0};
  }
  SimulationSpec spec = support::dry_world(bodies, step);
  for (int i = 0; i < links; ++i)
    spec.joints.push_back({.name = "joint",
                           .type = i % 3 == 0   ? Type::ball
                                   : i % 3 == 1 ? Type::hinge
                                                : Type::universal,
                           .first = i == 0 ? kWorld : i - 1,
                           .second = i,
                           .anchor_W = {0, 0, -1.0 * i},
                           .axis_W = Vector3d::UnitY(),
                           .axis2_W = Vector3d::UnitX()});
  return spec;
}

TEST(Joints, OfAHundredLinksWithMassesOneToAThousandAreExact) {
  const SimulationSpec spec = thrown_chain(100, 0.02);
  const double start = support::energy(spec, Simulation(spec).states());
  const Simulation simulation = support::after(spec, 100);
  EXPECT_LT(largest_gap(simulation, 1), tolerance(1e-9));
  EXPECT_LE(support::energy(spec, simulation.states()), start + 1e-4 * std::abs(start));
}

// Joints take from velocities that contradict them, as an inelastic impact does, and give nothing.
TEST(Joints, TakeUpVelocitiesThatTheyDoNotAllow) {
  for (const Type type : {Type::ball, Type::hinge, Type::fixed}) {
    SCOPED_TRACE(static_cast<int>(type));
    SimulationSpec spec = thrown_chain(3, 0.02);
    spec.gravity = 0;
    for (JointSpec& joint : spec.joints) joint.type = type;
    spec.bodies[1].initial.linear_velocity = {30, 0, 40};
    spec.bodies[2].initial.linear_velocity = {-20, 10, 0};
    const double start = support::energy(spec, Simulation(spec).states());
    Simulation simulation(spec);
    for (int i = 0; i < 50; ++i) {
      simulation.step();
      ASSERT_LE(support::energy(spec, simulation.states()), start * (1 + 1e-9));
    }
    EXPECT_LT(largest_gap(simulation, 1), tolerance(1e-9));
  }
}

TEST(Hinge, TurnsAboutItsAxisOnly) {
  SimulationSpec spec = pendulum(0.3, 0.01);
  spec.bodies[0].initial.angular_velocity = {3, 0, 2};
  for (const SimulationSpec& hinge : {spec, support::left_to_the_solver(spec)}) {
    const Simulation simulation = support::after(hinge, 500);
    const Quaterniond turn =
        simulation.states()[0].orientation * spec.bodies[0].initial.orientation.conjugate();
    // The solver takes the velocity about other axes out but for its compliance.
    EXPECT_LT(std::hypot(turn.x(), turn.z()), tolerance(1e-6));
    EXPECT_LT(std::abs(simulation.states()[0].position.y()), tolerance(1e-6));
  }
}

// A rod that leans by an angle and goes round the vertical with Ω² = m g L/((I − I_axis) cos angle)
// keeps its lean; I is its inertia about the joint.
TEST(Ball, LetsARodGoRoundTheVerticalSteadily) {
  constexpr double kLean = 0.6, kTime = 3;
  SimulationSpec spec = pendulum(kLean, 0.005, Type::ball);
  BodySpec& rod = spec.bodies[0];
  const double inertia = rod.inertia_B(0, 0) + rod.mass * kLength * kLength - rod.inertia_B(2, 2);
  const double rate = std::sqrt(rod.mass * spec.gravity * kLength / (inertia * std::cos(kLean)));
  rod.initial.angular_velocity = {0, 0, rate};
  rod.initial.linear_velocity = rod.initial.angular_velocity.cross(rod.initial.position);
  for (const SimulationSpec& ball : {spec, support::left_to_the_solver(spec)}) {
    Simulation simulation(ball);
    while (simulation.time() < kTime - spec.step / 2) simulation.step();
    const Vector3d& start = rod.initial.position;
    const Vector3d expected = Eigen::AngleAxisd(rate * kTime, Vector3d::UnitZ()) * start;
    // Phase error (Ω h)²/12 of 7 rad, with Ω h = 0.012.
    EXPECT_LT((simulation.states()[0].position - expected).norm(), tolerance(3e-4));
  }
}

TEST(Slider, FallsAlongItsAxisWithoutTurning) {
  support::Random random(6);
  BodySpec body = support::box_body("carriage", {1, 2, 3}, 100, {4, -5, 6});
  body.initial.orientation = random.rotation();
  const Vector3d axis = Vector3d(1, 2, -2).normalized();
  SimulationSpec spec = support::dry_world({body}, 0.01);
  spec.joints = {{.name = "rail", .type = Type::slider, .second = 0, .axis_W = axis}};
  const double way = -kGravity * axis.z() * 1.0 / 2;
  for (const SimulationSpec& slider : {spec, support::left_to_the_solver(spec)}) {
    const BodyState state = support::after(slider, 100).states()[0];
    EXPECT_LT((state.position - body.initial.position - way * axis).norm(), tolerance(1e-8));
    EXPECT_LT(state.angular_velocity.norm(), tolerance(1e-9));
  }
}

/// Two boxes side by side in space, the second three times as heavy, that a joint along the x axis,
/// or about an axis between them, connects.
SimulationSpec pair_in_space(Type type, const Vector3d& axis, double step) {
  BodySpec left = support::box_body("left", {1, 0.6, 0.4}, 200, {-1.5, 0, 0});
  BodySpec right = support::box_body("right", {1, 0.6, 0.4}, 600, {0.5, 0, 0});
  SimulationSpec spec = support::dry_world({left, right}, step);
  spec.gravity = 0;
  spec.joints = {
      {.type = type, .first = 0, .second = 1, .anchor_W = {-0.3, 0.1, 0.2}, .axis_W = axis}};
  return spec;
}

/// Momentum, and angular momentum about the origin, of all bodies.
Vector6d momentum(const SimulationSpec& spec, const std::vector<BodyState>& states) {
  Vector6d sum = Vector6d::Zero();
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Vector3d p = spec.bodies[i].mass * states[i].linear_velocity;
    sum.head<3>() += p;
    sum.tail<3>() += states[i].position.cross(p) + support::spin(spec.bodies[i], states[i]);
  }
  return sum;
}

TEST(Pairs, OnASliderMoveAlongItAsFreely) {
  SimulationSpec spec = pair_in_space(Type::slider, Vector3d::UnitX(), 0.01);
  spec.bodies[0].initial.linear_velocity = {0.7, 0.3, -0.2};
  spec.bodies[1].initial.linear_velocity = {-0.1, 0.3, -0.2};
  const Simulation simulation = support::after(spec, 300);
  EXPECT_GT(simulation.counts()[0].constrained, 0);
  for (std::size_t i = 0; i < 2; ++i) {
    const BodyState &start = spec.bodies[i].initial, &state = simulation.states()[i];
    EXPECT_LT((state.position - start.position - 3 * start.linear_velocity).norm(),
              tolerance(1e-10));
    EXPECT_LT(state.angular_velocity.norm(), tolerance(1e-10));
  }
}

/// Separation and angle of two boxes on a slider that turns about the z axis, after a time.
struct Turned {
  double separation;
  double angle;
};

Turned simulated_turning(double step) {
  SimulationSpec spec = pair_in_space(Type::slider, Vector3d::UnitX(), step);
  for (BodySpec& body : spec.bodies) {
    body.initial.angular_velocity = {0, 0, 0.8};
    body.initial.linear_velocity = body.initial.angular_velocity.cross(body.initial.position);
  }
  const auto states = support::after(spec, support::steps_in(2, step)).states();
  const Vector3d way = states[1].position - states[0].position;
  return {.separation = way.norm(), .angle = std::atan2(way.y(), way.x())};
}

/// The same of r'' = r ω², ω = L/(I + µ r²), by the classical Runge-Kutta method: I both moments
/// about z, µ the reduced mass, L the angular momentum about the common centre of mass.
Turned integrated_turning() {
  const SimulationSpec spec = pair_in_space(Type::slider, Vector3d::UnitX(), 0.01);
  const double a = spec.bodies[0].mass, b = spec.bodies[1].mass, mu = a * b / (a + b);
  const double inertia = spec.bodies[0].inertia_B(2, 2) + spec.bodies[1].inertia_B(2, 2);
  const double L = 0.8 * (inertia + mu * 2 * 2);
  const auto rate = [&](const Vector3d& s) {  // r, r', angle
    const double omega = L / (inertia + mu * s[0] * s[0]);
    return Vector3d(s[1], s[0] * omega * omega, omega);
  };
  Vector3d s(2, 0, 0);
  constexpr double kFine = 1e-3;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d k1 = rate(s), k2 = rate(s + kFine / 2 * k1), k3 = rate(s + kFine / 2 * k2);
    s += kFine / 6 * (k1 + 2 * k2 + 2 * k3 + rate(s + kFine * k3));
  }
  return {.separation = s[0], .angle = s[2]};
}

TEST(Pairs, OnASliderThatTurnsAreThrownApartToSecondOrder) {
  const Turned exact = integrated_turning();
  const auto error = [&](double step) {
    const Turned found = simulated_turning(step);
    return std::hypot(found.separation - exact.separation, 2 * (found.angle - exact.angle));
  };
  EXPECT_GT(exact.separation, 2.5);
  const double coarse = error(0.02), fine = error(0.01);
  EXPECT_LT(fine, tolerance(2e-4));
  EXPECT_NEAR(coarse / fine, 4, tolerance(0.5)) << coarse << " and " << fine;
}

constexpr Type kTypes[] = {Type::ball, Type::hinge, Type::slider, Type::fixed, Type::universal};

/// Two boxes that a joint in no symmetric place connects, moving as it allows.
SimulationSpec tumbling_pair(Type type, double step) {
  support::Random random(9);
  SimulationSpec spec = pair_in_space(type, Vector3d(1, 2, -1).normalized(), step);
  spec.joints[0].axis2_W = Vector3d(2, -1, 0).normalized();
  for (BodySpec& body : spec.bodies) {
    body.initial.linear_velocity = random.vector(1);
    body.initial.angular_velocity = random.vector(1);
  }
  // The joint takes what it does not allow within steps that are too short for any motion: in the
  // first one it also takes back what the bodies have strayed.
  SimulationSpec start = spec;
  start.step = 1e-6;
  const std::vector<BodyState> states = support::after(start, 20).states();
  for (std::size_t i = 0; i < 2; ++i) {
    spec.bodies[i].initial.linear_velocity = states[i].linear_velocity;
    spec.bodies[i].initial.angular_velocity = states[i].angular_velocity;
  }
  return spec;
}

/// Change of the momentum in 2 s.
Vector6d momentum_error(const SimulationSpec& spec) {
  const std::vector<BodyState> start = {spec.bodies[0].initial, spec.bodies[1].initial};
  return momentum(spec, support::after(spec, support::steps_in(2, spec.step)).states()) -
         momentum(spec, start);
}

// The reactions act on both anchors, which are apart by the square of the turn of a substep.
TEST(Pairs, KeepTheirMomentumAndTheirAngularMomentumToSecondOrder) {
  for (const Type type : kTypes) {
    SCOPED_TRACE(static_cast<int>(type));
    const Vector6d coarse = momentum_error(tumbling_pair(type, 0.01));
    const Vector6d fine = momentum_error(tumbling_pair(type, 0.005));
    EXPECT_LT(coarse.head<3>().norm(), tolerance(1e-12 * 800));  // of 800 kg at 1 m/s
    EXPECT_LT(fine.tail<3>().norm(), tolerance(2e-7 * 800));
    if (coarse.tail<3>().norm() > 1e-6) {
      EXPECT_GT(coarse.tail<3>().norm() / fine.tail<3>().norm(), 3.5);
    }
  }
}

TEST(Pairs, MoveAsTheirJointAllowsAndNotOtherwise) {
  for (const Type type : kTypes) {
    SCOPED_TRACE(static_cast<int>(type));
    const SimulationSpec spec = tumbling_pair(type, 0.005);
    const Vector3d &anchor = spec.joints[0].anchor_W, &axis = spec.joints[0].axis_W;
    const Simulation simulation = support::after(spec, 400);
    EXPECT_GT(simulation.counts()[1].constrained, 0);
    const BodyState &a = simulation.states()[0], &b = simulation.states()[1];
    const auto place = [&](const BodyState& state, std::size_t body) {
      return Vector3d(state.position +
                      state.orientation * (anchor - spec.bodies[body].initial.position));
    };
    const Vector3d turn = (a.orientation.conjugate() * b.orientation).vec();
    const Vector3d apart = a.orientation.conjugate() * (place(a, 0) - place(b, 1));
    const bool slides = type == Type::slider, turns = !slides && type != Type::fixed;
    EXPECT_LT(slides ? apart.cross(axis).norm() : apart.norm(), tolerance(1e-4));
    EXPECT_TRUE(!slides || apart.norm() > 0.1);
    EXPECT_TRUE(turns ? turn.norm() > 0.05 : turn.norm() < tolerance(1e-5));
    EXPECT_TRUE(type != Type::hinge || turn.cross(axis).norm() < tolerance(1e-5));
  }
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

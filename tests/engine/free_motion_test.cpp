#include "engine/motion/free_motion.h"

#include <numbers>

#include "tests/engine/prelude.h"

namespace {

using engine::AppliedLoad;

// Round-off of some hundred sums of numbers up to a hundred.
constexpr double kRoundOff = 1e-11;

SimulationSpec weightless(const BodySpec& body) {
  SimulationSpec spec = support::dry_world({body}, kStep);
  spec.gravity = 0;
  return spec;
}

BodySpec brick() { return support::box_body("brick", {1, 2, 3}, 100, {4, -5, 6}); }

TEST(FreeFall, IsExactForAnyStep) {
  BodySpec body = brick();
  body.initial.linear_velocity = {1, -2, 3};
  body.initial.angular_velocity = {3, 2, -1};
  for (const double step : {0.01, 0.25, 1.0}) {
    const double t = 2;
    const Simulation simulation =
        support::after(support::dry_world({body}, step), support::steps_in(t, step));
    const hydro::BodyState& state = simulation.states()[0];
    const Vector3d expected = body.initial.position + t * body.initial.linear_velocity -
                              Vector3d(0, 0, support::kGravity * t * t / 2);
    EXPECT_LT((state.position - expected).norm(), tolerance(kRoundOff));
    EXPECT_NEAR(state.linear_velocity.z(), 3 - support::kGravity * t, tolerance(kRoundOff));
    EXPECT_DOUBLE_EQ(simulation.time(), t);
  }
}

TEST(FreeFall, OfThePlainMethodIsThatOfSemiImplicitEuler) {
  SimulationSpec spec = support::dry_world({brick()}, kStep);
  spec.integrator.method = engine::Integrator::Method::ode;
  const Simulation simulation = support::after(spec, 200);
  // z = z0 + the sum of h v, with v = -g t at the end of each step.
  EXPECT_NEAR(simulation.states()[0].position.z(), 6 - support::kGravity * 2 * (2 + kStep) / 2,
              tolerance(kRoundOff));
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
  EXPECT_NEAR(state.position.z(), 6 - support::kGravity * 1.0 / 2, tolerance(kRoundOff));
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

TEST(FreeSpin, KeepsEnergyAndAngularMomentumAboutAnUnsteadyAxis) {
  BodySpec body = brick();
  body.initial.angular_velocity = {0.1, 8, -0.1};  // near the middle axis: it tumbles
  Simulation simulation(weightless(body));
  const double energy = support::energy(simulation.spec(), simulation.states());
  const Vector3d momentum = support::spin(body, body.initial);
  for (int i = 0; i < 2000; ++i) simulation.step();
  const hydro::BodyState& state = simulation.states()[0];
  // Both are kept by the scheme; round-off of 4000 turns by half a step adds up.
  EXPECT_NEAR(support::energy(simulation.spec(), simulation.states()), energy,
              tolerance(1e-11 * energy));
  EXPECT_LT((support::spin(body, state) - momentum).norm(), tolerance(1e-11 * momentum.norm()));
  EXPECT_NEAR(state.orientation.norm(), 1, tolerance(1e-15));
  EXPECT_GT((state.angular_velocity - body.initial.angular_velocity).norm(), 0.1);
}

/// Orientation after 1 s of tumbling.
Eigen::Quaterniond tumbled(double step) {
  BodySpec body = brick();
  body.initial.angular_velocity = {1, 2, 3};
  SimulationSpec spec = weightless(body);
  spec.step = step;
  return support::after(spec, support::steps_in(1, step)).states()[0].orientation;
}

/// With the added mass of a thin plate, one moment may be a million times another.
TEST(FreeSpin, KeepsEnergyAndAngularMomentumWhateverTheMomentsOfInertia) {
  support::Random random(8);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Matrix3d axes = random.rotation().toRotationMatrix();
    const Vector3d moments(1, std::pow(10, random.uniform(-6, 0)),
                           std::pow(10, random.uniform(-6, 0)));
    const Eigen::Matrix3d inertia = axes * moments.asDiagonal() * axes.transpose();
    const hydro::BodyState start{
        .orientation = random.rotation(),
        .angular_velocity = std::pow(10, random.uniform(0, 2)) * random.vector(1)};
    const auto momentum = [&](const hydro::BodyState& state) {
      return Vector3d(state.orientation *
                      (inertia * (state.orientation.conjugate() * state.angular_velocity)));
    };
    const auto energy = [&](const hydro::BodyState& state) {
      return momentum(state).dot(state.angular_velocity) / 2;
    };
    const hydro::BodyState end = engine::rotated_freely(inertia, start, 1.0 / 60);
    // (E2) may be left with a change of kDriftEnergyKept in each of 64 parts of up to 17, and with
    // moments this unequal round-off of momentum counts a million times in the energy.
    EXPECT_NEAR(energy(end), energy(start), tolerance(1e-5) * energy(start)) << moments.transpose();
    EXPECT_LT((momentum(end) - momentum(start)).norm(), tolerance(1e-5) * momentum(start).norm())
        << moments.transpose();
  }
}

TEST(FreeSpin, TurnsToSecondOrder) {
  const Eigen::Quaterniond exact = tumbled(1.0 / 4096);
  const auto error = [&](double step) {
    return 2 * (tumbled(step) * exact.conjugate()).vec().norm();
  };
  // The next term is of fourth order; the reference is 1 % of the finer error off.
  EXPECT_NEAR(error(1.0 / 64) / error(1.0 / 128), 4, tolerance(0.1));
  EXPECT_LT(error(1.0 / 128), tolerance(1e-4));
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
  // Angular momentum is kept while the body turns within the step.
  const Vector3d moment = load.torque + (R_WB * load.at_B).cross(load.force);
  EXPECT_LT((support::spin(body, simulation.states()[0]) - kStep * moment).norm(),
            tolerance(1e-13));
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
  // The integral of F cos(π t)/m peaks at F/(π m); the midpoint rule is (π h)²/24 above it.
  const double peak = 600 / (std::numbers::pi * body.mass);
  EXPECT_NEAR(fastest, peak, tolerance(1.01 * peak * std::pow(std::numbers::pi * kStep, 2) / 24));
}

TEST(AppliedLoads, AddUp) {
  BodySpec body = brick();
  body.loads = {{.force = {600, 0, 0}}, {.force = {-600, 300, 0}}};
  const Simulation simulation = support::after(weightless(body), 100);
  const Vector3d expected(0, 300 / body.mass, 0);
  EXPECT_LT((simulation.states()[0].linear_velocity - expected).norm(), tolerance(kRoundOff));
}

}  // namespace

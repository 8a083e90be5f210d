#include <complex>

#include "engine/motion/velocity_update.h"
#include "engine/state_data.h"
#include "hydro/airy_waves.h"
#include "tests/engine/radiating_ball.h"

/// How bodies that make waves move.

namespace {

using hydro::FloatingBody;
using support::afloat;
using support::energy;
using support::kRho;
using support::radiating_ball;
using support::uneven_data;

engine::Motion motion_of(const Simulation& simulation) {
  return simulation.state().data().bodies[0].motion;
}

double heave_stiffness(const BodySpec& body) {
  const hydro::Hull hull = hydro::make_hull(body.mesh_B);
  const hydro::Sea sea{.density = kRho, .gravity = kGravity};
  const auto lift = [&](double z) {
    return hydro::compute_loads(hull, {.position = {0, 0, z}}, sea, 0, body.coefficients)
        .buoyancy.force.z();
  };
  return (lift(-1e-3) - lift(1e-3)) / 2e-3;
}

/// Times and heights of the turns of a heave, by parabolas.
std::vector<std::pair<double, double>> turns_of_heave(const SimulationSpec& spec, int count) {
  Simulation simulation(spec);
  std::vector<double> z = {simulation.states()[0].position.z()};
  std::vector<std::pair<double, double>> turns;
  while (static_cast<int>(turns.size()) < count && z.size() < 10000) {
    simulation.step();
    z.push_back(simulation.states()[0].position.z());
    const std::size_t n = z.size();
    if (n < 3 || !((z[n - 2] - z[n - 3]) * (z[n - 1] - z[n - 2]) < 0)) continue;
    const double slope = (z[n - 1] - z[n - 3]) / 2, bend = z[n - 1] - 2 * z[n - 2] + z[n - 3];
    turns.emplace_back((static_cast<double>(n - 2) - slope / bend) * spec.step,
                       z[n - 2] - slope * slope / (2 * bend));
  }
  return turns;
}

/// Height at a time of a body that is let go from rest at a height of 1 [-], by Fourier's integral:
/// the Laplace transform of its motion is X(s) = ((M + A∞) s + Ĥ(s)) / ((M + A∞) s² + s Ĥ(s) + C).
double free_heave(const BodySpec& body, double stiffness, double time) {
  const hydro::RadiationMemory& memory = body.radiation->memory();
  const double inertia = body.mass + kRho * body.radiation->data().infinite_added_mass(2, 2);
  constexpr double kStep = 1e-2, kLast = 60;  // [rad/s]
  double sum = 0;
  for (double frequency = kStep / 2; frequency < kLast; frequency += kStep) {
    const std::complex<double> s(0, frequency), H = kRho * response(memory, frequency)(2, 2);
    const std::complex<double> X = (inertia * s + H) / (inertia * s * s + s * H + stiffness);
    sum += kStep * X.real() * std::cos(frequency * time);
  }
  return 2 / M_PI * sum;
}

TEST(Radiation, DampsAHeavingSphereAsItsFrequencyResponseHasIt) {
  BodySpec ball = radiating_ball();
  ball.initial.position.z() = 1e-2;
  const auto turns = turns_of_heave(afloat(ball, 0.01), 7);
  ASSERT_EQ(turns.size(), 7U);
  const double stiffness = heave_stiffness(ball);
  // The waterplane of the mesh changes by 1e-3 over the amplitude.
  for (const auto& [time, height] : turns) {
    EXPECT_NEAR(height / 1e-2, free_heave(ball, stiffness, time), 2e-3) << time;
    // At a turn the motion is as slow before as after it.
    EXPECT_NEAR(free_heave(ball, stiffness, time - 0.1), free_heave(ball, stiffness, time + 0.1),
                2e-3)
        << time;
  }
  // Linear theory's damping at that frequency is near: B/(2 (M + A)) at kR = 1.1.
  const double time = turns[6].first - turns[2].first;
  EXPECT_NEAR(std::log(turns[2].second / turns[6].second) / time,
              1.579245 / (2 * (2.0944 + 0.870787)), 0.05);
}

TEST(Radiation, IsOfSecondOrderInTheStep) {
  for (BodySpec ball : {radiating_ball(), radiating_ball(uneven_data())}) {
    ball.initial.position = {0, 0, 0.3};
    ball.initial.linear_velocity = {0.5, 0, 0};
    const auto end = [&](double step) {
      return support::after(afloat(ball, step), support::steps_in(1.6, step)).states()[0];
    };
    const BodyState exact = end(0.0025);
    const double coarse = distance(end(0.04), exact), fine = distance(end(0.02), exact);
    EXPECT_LT(coarse, 2e-3);
    EXPECT_GT(coarse / fine, 3.5);
  }
}

TEST(Radiation, NeverAddsEnergyToBodyAndWavesInStillWater) {
  for (const bool uneven : {false, true})
    for (const double step : {0.01, 1.0 / 60, 0.1, 0.3}) {
      BodySpec ball = uneven ? radiating_ball(uneven_data()) : radiating_ball();
      ball.initial.position = {0, 0, 1.2};  // It falls in.
      ball.initial.linear_velocity = {1, 0.5, 0};
      if (uneven) ball.initial.angular_velocity = {0.3, 0.5, -1};
      Simulation simulation(afloat(ball, step));
      const engine::Body body = engine::make_bodies(simulation.spec())[0];
      double least = energy(body, motion_of(simulation));
      const double start = least;
      // Waves that have left the body lose their energy as slowly as the oscillators are damped.
      const int steps = std::max(200, static_cast<int>(8 / step));
      for (int i = 0; i < steps; ++i) {
        simulation.step();
        const double now = energy(body, motion_of(simulation));
        // What the limiter ignores, and the correction of the reported state.
        EXPECT_LE(now, least + 0.01 * start) << step << ", step " << i;
        least = std::min(least, now);
      }
      EXPECT_LT(least, 0.75 * start) << step;
    }
}

TEST(Radiation, IsNoBrakeForTheLimiter) {
  BodySpec ball = radiating_ball();
  ball.initial.position.z() = 0.5;
  const Simulation simulation = support::after(afloat(ball, 1.0 / 60), 600);
  EXPECT_EQ(simulation.counts()[0].clamped, 0);
}

TEST(Radiation, TurnsWithTheHeading) {
  BodySpec ball = radiating_ball(uneven_data());
  ball.initial.linear_velocity = {0.2, 0.4, 0};
  const Simulation ahead = support::after(afloat(ball, 0.02), 100);
  const Eigen::Quaterniond yaw(Eigen::AngleAxisd(2.1, Vector3d::UnitZ()));
  ball.initial.orientation = yaw;
  ball.initial.linear_velocity = yaw * ball.initial.linear_velocity;
  const Simulation turned = support::after(afloat(ball, 0.02), 100);
  const Vector3d expected = yaw * ahead.states()[0].linear_velocity;
  EXPECT_LT((turned.states()[0].linear_velocity - expected).norm(), 1e-9);
  // The heading matters: the motion along y has lost more.
  const Vector3d left = ahead.states()[0].linear_velocity;
  EXPECT_GT(std::abs(left.x() / 0.2 - left.y() / 0.4), 0.02);
}

// The water that a ball moves, its memory and its scattering do not know how it is turned: one that
// rolls bobs, drifts and slows down as one that does not.
TEST(Radiation, DoesNotKnowHowABallIsTurned) {
  BodySpec ball = radiating_ball();
  ball.initial.position.z() = 0.2;
  ball.initial.linear_velocity = {0.3, 0, 0};
  const BodyState upright = support::after(afloat(ball, 0.02), 200).states()[0];
  ball.initial.orientation = Eigen::AngleAxisd(1.2, Vector3d(2, -1, 0.5).normalized());
  ball.initial.angular_velocity = {1.5, -2, 0.7};
  const BodyState rolling = support::after(afloat(ball, 0.02), 200).states()[0];
  // What is left is the buoyancy of its 1,280 triangles, which are wet in other numbers.
  EXPECT_LT((rolling.position - upright.position).norm(), tolerance(2e-3));
  EXPECT_LT((rolling.linear_velocity - upright.linear_velocity).norm(), tolerance(4e-3));
  EXPECT_LT((rolling.angular_velocity - ball.initial.angular_velocity).norm(), tolerance(1e-2));
}

TEST(Radiation, ActsOnABodyUnderJointsAsOnAFreeOne) {
  BodySpec ball = radiating_ball();
  ball.initial.position.z() = 0.2;
  SimulationSpec spec = afloat(ball, 0.01);
  const BodyState free = support::after(spec, 300).states()[0];
  spec.joints = {{.name = "rail", .type = JointSpec::Type::slider, .first = 0}};
  const BodyState reduced = support::after(spec, 300).states()[0];
  const BodyState solved = support::after(support::left_to_the_solver(spec), 300).states()[0];
  // The corrections (E9) of a free body and of one under constraints differ.
  EXPECT_NEAR(reduced.position.z(), free.position.z(), 1e-4);
  EXPECT_NEAR(solved.position.z(), free.position.z(), 1e-4);
  ball.radiation.reset();
  spec = afloat(ball, 0.01);
  EXPECT_GT(std::abs(support::after(spec, 300).states()[0].position.z() - free.position.z()), 0.05);
}

TEST(Radiation, LocksLeaveItTheOtherMotions) {
  BodySpec ball = radiating_ball();
  ball.initial.position.z() = 0.2;
  const BodyState free = support::after(afloat(ball, 0.01), 300).states()[0];
  ball.locked = {true, true, false, true, true, true};
  const BodyState locked = support::after(afloat(ball, 0.01), 300).states()[0];
  EXPECT_NEAR(locked.position.z(), free.position.z(), 1e-6);
}

TEST(Radiation, IsRelativeToTheCurrent) {
  BodySpec ball = radiating_ball();
  ball.initial.position.z() = 0.2;
  ball.initial.linear_velocity = {0.3, 0, 0};
  const BodyState still = support::after(afloat(ball, 0.01), 200).states()[0];
  SimulationSpec spec = afloat(ball, 0.01);
  spec.sea->current = {0.7, -0.4, 0};
  spec.bodies[0].initial.linear_velocity += spec.sea->current;
  const BodyState drifting = support::after(spec, 200).states()[0];
  EXPECT_LT((still.position + 2 * spec.sea->current - drifting.position).norm(), 1e-9);
}

TEST(Radiation, DoesNotReachABodyInTheAir) {
  BodySpec ball = radiating_ball();
  ball.initial.position.z() = 5;
  ball.initial.linear_velocity = {1, 0, 0};
  const BodyState radiating = support::after(afloat(ball, 0.01), 50).states()[0];
  ball.radiation.reset();
  ball.added_mass.reset();
  const BodyState plain = support::after(afloat(ball, 0.01), 50).states()[0];
  EXPECT_LT(distance(radiating, plain), 1e-12);
}

TEST(Radiation, ClosesTheBudgetOfWorks) {
  const auto off = [](double step, BodySpec ball) {
    ball.initial.position.z() = 0.4;
    ball.initial.linear_velocity = {0.5, 0, 0};
    SimulationSpec spec = afloat(ball, step);
    spec.record_work = true;
    const engine::BodyForces start = Simulation(spec).forces()[0];
    const engine::BodyForces end = support::after(spec, support::steps_in(3, step)).forces()[0];
    EXPECT_LT(end.works.radiation, -0.3 * std::abs(end.works.weight + end.works.buoyancy));
    return std::abs(end.kinetic_energy - start.kinetic_energy - end.works.sum()) /
           std::abs(end.works.radiation);
  };
  // What is missing is the correction (E9) of the state, of second order.
  for (const BodySpec& ball : {radiating_ball(), radiating_ball(uneven_data())}) {
    const double coarse = off(0.02, ball), fine = off(0.01, ball);
    EXPECT_LT(coarse, 0.01);
    EXPECT_LT(fine, coarse / 3);
  }
}

TEST(Radiation, GoesOnFromASavedStateWithTheSameBytes) {
  BodySpec ball = radiating_ball();
  ball.initial.position.z() = 0.4;
  ball.initial.linear_velocity = {0.5, 0, 0};
  SimulationSpec spec = afloat(ball, 0.02);
  spec.record_work = true;
  Simulation whole = support::after(spec, 40);
  Simulation restored(spec);
  restored.restore(engine::SimulationState::from_bytes(whole.state().to_bytes()));
  for (int i = 0; i < 40; ++i) {
    whole.step();
    restored.step();
  }
  EXPECT_EQ(whole.state().to_bytes(), restored.state().to_bytes());
  spec.bodies[0].radiation.reset();
  Simulation without(spec);
  EXPECT_THROW(without.restore(whole.state()), std::invalid_argument);
}

TEST(Radiation, ScattersWavesInPlaceOfTheirInertia) {
  BodySpec ball = radiating_ball();
  const auto push = [](const BodyState&, const hydro::WaveFrame&, const hydro::Sea&, double) {
    return hydro::Wrench{.force = {100, 0, 0}};
  };
  ball.radiation = std::make_shared<FloatingBody>(ball.mesh_B, support::radiating_sphere(1), push);
  ball.added_mass = ball.radiation;
  SimulationSpec spec = afloat(ball, 0.02);
  spec.record_work = true;
  spec.sea->surface = hydro::WaveSurface{{hydro::deep_water_wave(0.05, 20, 0, 0, kGravity)}};
  const engine::BodyForces forces = support::after(spec, 50).forces()[0];
  EXPECT_EQ(forces.water.diffraction.force.x(), 100);
  EXPECT_TRUE(forces.water.wave_inertia.force.isZero(0));
  EXPECT_NE(forces.works.diffraction, 0);
  EXPECT_EQ(forces.works.wave_inertia, 0);
}

}  // namespace

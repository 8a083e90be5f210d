#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/constraints/force_row.h"
#include "hydro/lines/catenary.h"
#include "tests/engine/rig_specs.h"

namespace {

using Eigen::Vector3d;
using engine::AttachmentPoint;
using engine::kWorld;
using engine::LineSpec;
using engine::Simulation;
using engine::SimulationSpec;
using Kind = LineSpec::Kind;

constexpr double kPi = std::numbers::pi;

/// A box of 1 m in weightless space.
SimulationSpec weightless(std::vector<engine::BodySpec> bodies, double step) {
  SimulationSpec spec = support::dry_world(std::move(bodies), step);
  spec.gravity = 0;
  return spec;
}

engine::BodySpec box(const std::string& name, const Vector3d& at, double density = 1000) {
  return support::box_body(name, {1, 1, 1}, density, at);
}

/// Place along x of a mass on a spring to the world after a time, started at rest at x = 1.
double mass_on_spring(double frequency, double step, double time) {
  SimulationSpec spec = weightless({box("mass", {1, 0, 0})}, step);
  const double k = spec.bodies[0].mass * frequency * frequency;
  spec.lines = {support::line(Kind::spring, {0, {0, 0, 0}}, {kWorld, {-10, 0, 0}}, 10, k)};
  return support::after(std::move(spec), support::steps_in(time, step)).states()[0].position.x();
}

TEST(Spring, MovesAMassToSecondOrder) {
  const double w = 2 * kPi, time = 2.3;
  const double coarse = mass_on_spring(w, 1.0 / 60, time) - std::cos(w * 138 / 60);
  const double fine = mass_on_spring(w, 1.0 / 120, time) - std::cos(w * 138 / 60);
  EXPECT_LT(std::abs(coarse), 0.03);
  EXPECT_GT(std::abs(coarse / fine), 3.3);
}

TEST(Spring, KeepsTheEnergyOfAMass) {
  const double w = 3;
  SimulationSpec spec = weightless({box("mass", {1, 0, 0})}, 1.0 / 60);
  const double m = spec.bodies[0].mass, k = m * w * w;
  spec.lines = {support::line(Kind::spring, {0, {0, 0, 0}}, {kWorld, {-10, 0, 0}}, 10, k)};
  Simulation simulation(std::move(spec));
  const double E = k / 2;
  for (int i = 0; i < 6000; ++i) {
    simulation.step();
    const auto& s = simulation.states()[0];
    const double x = s.position.x();
    const double energy = (k * x * x + m * s.linear_velocity.squaredNorm()) / 2;
    ASSERT_NEAR(energy / E, 1, 2e-3) << i;  // it oscillates by (ωh)²/4 and does not drift
  }
}

/// However stiff a spring to the world is, the implicit rule neither adds nor takes energy.
TEST(Spring, ToTheWorldIsStableHoweverStiff) {
  for (const double stiffness : {1e5, 1e7, 1e9, 1e12}) {
    SimulationSpec spec = weightless({box("mass", {0.001, 0, 0})}, 1.0 / 60);
    spec.bodies[0].initial.linear_velocity = {0, 0.1, 0};
    spec.lines = {
        support::line(Kind::spring, {0, {0, 0, 0}}, {kWorld, {-10, 0, 0}}, 10, stiffness)};
    Simulation simulation(std::move(spec));
    for (int i = 0; i < 1200; ++i) {
      simulation.step();
      ASSERT_LT(std::abs(simulation.rig().lines[0].distance - 10), 0.002) << stiffness << " " << i;
    }
  }
}

TEST(Spring, BetweenTwoBodiesKeepsMomentumAndAngularMomentum) {
  SimulationSpec spec = weightless({box("a", {0, 0, 0}), box("b", {3, 0.5, 0}, 300)}, 1.0 / 60);
  spec.bodies[1].initial.linear_velocity = {1, 2, -0.5};
  spec.bodies[1].initial.angular_velocity = {0.3, 0.1, 1};
  const auto bodies = spec.bodies;
  spec.lines = {support::line(Kind::spring, {0, {0.5, 0.2, 0}}, {1, {-0.5, 0, 0.3}}, 2, 3e3, 50)};
  Simulation simulation(std::move(spec));
  const auto momenta = [&] {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (int i = 0; i < 2; ++i) {
      const auto& s = simulation.states()[i];
      const Vector3d p = bodies[i].mass * s.linear_velocity;
      sum.head<3>() += p;
      sum.tail<3>() += s.position.cross(p) + support::spin(bodies[i], s);
    }
    return sum;
  };
  const auto before = momenta();
  for (int i = 0; i < 600; ++i) simulation.step();
  const auto after = momenta();
  EXPECT_NEAR((after - before).head<3>().norm(), 0, 1e-9 * before.head<3>().norm());
  // The states that are reported differ from those that are moved on by (E9).
  EXPECT_NEAR((after - before).tail<3>().norm(), 0, 2e-3 * before.tail<3>().norm());
}

/// Angle of a pendulum on a rope after a time.
double pendulum(double stiffness, double step, double time, double* energy = nullptr) {
  SimulationSpec spec = support::dry_world({box("bob", {0, 0, 0})}, step);
  const double length = 5, angle = 0.5;
  spec.bodies[0].initial.position = {length * std::sin(angle), 0, -length * std::cos(angle)};
  const double m = spec.bodies[0].mass;
  const double stretch = m * spec.gravity * std::cos(angle) / stiffness;
  spec.lines = {
      support::line(Kind::rope, {0, {0, 0, 0}}, {kWorld, {0, 0, 0}}, length - stretch, stiffness)};
  const double g = spec.gravity;
  Simulation simulation(std::move(spec));
  for (long i = 0; i < support::steps_in(time, step); ++i) simulation.step();
  const auto& s = simulation.states()[0];
  if (energy) {
    const double e = s.position.norm() - (length - stretch);
    *energy = m * s.linear_velocity.squaredNorm() / 2 + m * g * (s.position.z() + length) +
              stiffness / 2 * e * e;
  }
  return std::atan2(s.position.x(), -s.position.z());
}

TEST(Rope, SwingsAPendulumToSecondOrder) {
  const double k = 1e6;  // at these steps it is a load of the pose
  const double reference = pendulum(k, 1.0 / 3840, 2);
  const double coarse = pendulum(k, 1.0 / 240, 2) - reference;
  const double fine = pendulum(k, 1.0 / 480, 2) - reference;
  EXPECT_LT(std::abs(coarse), 1e-3);
  EXPECT_GT(std::abs(coarse / fine), 3.3);
}

TEST(Rope, KeepsTheEnergyOfAPendulum) {
  for (const double k : {1e5, 1e7, 1e9}) {
    double start = 0, end = 0;
    pendulum(k, 1.0 / 60, 0, &start);
    pendulum(k, 1.0 / 60, 20, &end);
    EXPECT_NEAR(end / start, 1, 0.02) << k;
  }
}

TEST(Rope, OfAnyStiffnessHoldsAHeavyMassByALightOne) {
  for (const double ratio : {1.0, 1e3, 1e6})
    for (const double k : {1e5, 1e9}) {
      SimulationSpec spec = support::dry_world(
          {box("light", {0, 0, -2}, 1000 / ratio), box("heavy", {0, 0, -4})}, 1.0 / 60);
      spec.lines = {support::line(Kind::rope, {0, {0, 0, 0}}, {kWorld, {0, 0, 0}}, 2, k),
                    support::line(Kind::rope, {1, {0, 0, 0}}, {0, {0, 0, 0}}, 2, k)};
      const double weight = (spec.bodies[0].mass + spec.bodies[1].mass) * spec.gravity;
      spec.bodies[1].initial.linear_velocity = {0.5, 0, 0};
      Simulation simulation(std::move(spec));
      double highest = 0, mean = 0;
      for (int i = 0; i < 1200; ++i) {
        simulation.step();
        for (const auto& s : simulation.states())
          highest = std::max(highest, s.linear_velocity.norm());
        mean += simulation.rig().lines[0].tension / 1200;
      }
      EXPECT_LT(highest, 3) << ratio << " " << k;
      EXPECT_NEAR(mean / weight, 1, 0.05) << ratio << " " << k;
    }
}

TEST(Rope, IsSlackWithoutForce) {
  SimulationSpec spec = weightless({box("mass", {1, 0, 0})}, 1.0 / 60);
  spec.bodies[0].initial.linear_velocity = {-1, 0, 0};
  spec.lines = {support::line(Kind::rope, {0, {0, 0, 0}}, {kWorld, {0, 0, 0}}, 3, 1e4, 100)};
  Simulation simulation(std::move(spec));
  for (int i = 0; i < 60; ++i) simulation.step();
  EXPECT_EQ(simulation.rig().lines[0].tension, 0);
  EXPECT_FALSE(simulation.rig().lines[0].taut);
  EXPECT_NEAR(simulation.states()[0].linear_velocity.x(), -1, 1e-12);
}

/// The rate at which a stretched line is taken back depends on the step alone: what long substeps
/// have stretched is not thrown back by short ones.
TEST(Rope, IsTakenToItsLengthAtARateThatNoSubstepChanges) {
  const double step = 1.0 / 60, missing = 0.01;
  for (const double h : {step, step / 8, step / 64}) {
    const engine::RowTerms taut = engine::row_terms(
        {.stiffness = 1e12, .missing = missing, .mobility = 1e-3, .one_sided = true}, h, step);
    EXPECT_NEAR(taut.target, missing / step, 1e-12) << h;
    // A slack one lets its ends part by what it is slack by.
    const engine::RowTerms slack = engine::row_terms(
        {.stiffness = 1e12, .missing = -missing, .mobility = 1e-3, .one_sided = true}, h, step);
    EXPECT_NEAR(slack.target, -missing / h, 1e-12) << h;
  }
}

TEST(Rope, BreaksAtItsLoad) {
  SimulationSpec spec = support::dry_world({box("mass", {0, 0, -2})}, 1.0 / 60);
  const double weight = spec.bodies[0].mass * spec.gravity;
  spec.lines = {support::line(Kind::rope, {0, {0, 0, 0}}, {kWorld, {0, 0, 0}}, 2, 1e9, 1e5)};
  spec.lines[0].breaks_at = 0.9 * weight;
  Simulation weak(spec);
  spec.lines[0].breaks_at = 3 * weight;
  Simulation strong(std::move(spec));
  for (int i = 0; i < 120; ++i) weak.step(), strong.step();
  EXPECT_TRUE(weak.rig().lines[0].broken);
  EXPECT_LT(weak.states()[0].position.z(), -10);
  EXPECT_FALSE(strong.rig().lines[0].broken);
  EXPECT_NEAR(strong.rig().lines[0].tension, weight, 0.01 * weight);
}

TEST(Rope, OfAWinchHaulsABodyUpAtItsRate) {
  for (const double k : {1e6, 1e9}) {
    SimulationSpec spec = support::dry_world({box("load", {0, 0, -10})}, 1.0 / 60);
    spec.lines = {support::line(Kind::rope, {0, {0, 0, 0.5}}, {kWorld, {0, 0, 0}}, 9.5, k, 1e5)};
    spec.lines[0].set_rate = support::add_set_point(spec, "ropes[line].rate", -0.5);
    spec.lines[0].shortest = 2;
    const double weight = spec.bodies[0].mass * spec.gravity;
    Simulation simulation(std::move(spec));
    for (int i = 0; i < 600; ++i) simulation.step();
    EXPECT_NEAR(simulation.states()[0].linear_velocity.z(), 0.5, 0.02) << k;
    EXPECT_NEAR(simulation.states()[0].position.z(), -5, 0.02) << k;
    EXPECT_NEAR(simulation.rig().lines[0].tension, weight, 0.05 * weight) << k;
    simulation.set("ropes[line].rate", 0);
    for (int i = 0; i < 120; ++i) simulation.step();
    EXPECT_NEAR(simulation.states()[0].linear_velocity.z(), 0, 0.05) << k;
  }
}

TEST(Mooring, HoldsABodyWhereTheCatenaryBalancesAForce) {
  SimulationSpec spec = weightless({box("buoy", {400, 0, 200})}, 1.0 / 60);
  LineSpec mooring{.name = "m",
                   .kind = Kind::mooring,
                   .first = {0, {0, 0, 0}},
                   .second = {kWorld, {0, 0, 0}},
                   .length = 500,
                   .stiffness = 7.51e12,
                   .weight = 800};
  spec.lines = {mooring};
  spec.bodies[0].locked = {false, true, true, true, true, true};
  // The fairlead force of this line is tabulated: H = 96643.43 N.
  spec.bodies[0].loads = {{.force = {96643.43, 0, 0}}};
  Simulation simulation(std::move(spec));
  EXPECT_NEAR(simulation.rig().lines[0].tension / std::hypot(96643.43, 237751.76), 1, 1e-6);
  for (int i = 0; i < 600; ++i) simulation.step();
  EXPECT_NEAR(simulation.states()[0].position.x(), 400, 1e-4);
  EXPECT_NEAR(simulation.rig().lines[0].resting, 202.8103, 1e-2);
}

TEST(Mooring, ThatIsTautIsStableOnALightBody) {
  SimulationSpec spec = weightless({box("float", {0, 0, 99.01}, 300)}, 1.0 / 60);
  LineSpec mooring{.name = "m",
                   .kind = Kind::mooring,
                   .first = {0, {0, 0, 0}},
                   .second = {kWorld, {0, 0, 0}},
                   .length = 99,
                   .stiffness = 7.5e8,
                   .weight = 100};
  spec.lines = {mooring};
  spec.bodies[0].loads = {{.force = {10, 0, 5e4}}};
  Simulation simulation(std::move(spec));
  for (int i = 0; i < 600; ++i) {
    simulation.step();
    ASSERT_NEAR(simulation.states()[0].position.norm(), 99.01, 0.1) << i;
  }
}

TEST(Mooring, ThatComesTautThrowsNoBodyBack) {
  const double speed = 20;
  for (const double stiffness : {1e8, 1e10, 1e12}) {
    for (const double start : {90.0, 90.1, 90.2, 90.3}) {
      SimulationSpec spec = weightless({box("float", {0, 0, start}, 30)}, 1.0 / 60);
      LineSpec mooring{.name = "m",
                       .kind = Kind::mooring,
                       .first = {0, {0, 0, 0}},
                       .second = {kWorld, {0, 0, 0}},
                       .length = 99,
                       .stiffness = stiffness,
                       .weight = 0.1};
      spec.lines = {mooring};
      spec.bodies[0].initial.linear_velocity = {0, 0, speed};
      Simulation simulation(std::move(spec));
      for (int i = 0; i < 120; ++i) {
        simulation.step();
        // The weight of the line gives 2e-4 of the energy.
        ASSERT_LT(simulation.states()[0].linear_velocity.norm(), (1 + 1e-3) * speed)
            << stiffness << " " << start << " " << i;
      }
    }
  }
}

}  // namespace

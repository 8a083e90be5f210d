#include <numbers>

#include "engine/motion/energy.h"
#include "hydro/airy_waves.h"
#include "tests/engine/prelude.h"

/// Bodies that the wind drives, against closed forms and against the budget of their works.

namespace {

using engine::BodyForces;
using hydro::Air;
using hydro::Sea;

constexpr double kAirDensity = 1.225;  // [kg/m^3]

Sea sea_under(const hydro::Wind& wind) {
  return {.density = 1000, .gravity = kGravity, .air = Air{.density = kAirDensity, .wind = wind}};
}

/// Pressure drag and buoyancy alone.
BodySpec dragged(BodySpec body, double front, double back) {
  body.wet = true;
  body.coefficients.pressure_drag = {front, back};
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  return body;
}

SimulationSpec in_wind(BodySpec body, const Sea& sea, double step = kStep) {
  SimulationSpec spec = support::dry_world({std::move(body)}, step);
  spec.sea = sea;
  spec.record_work = true;
  return spec;
}

/// A body so light that an explicit update in this wind would throw it about: h J/m is above 4.
BodySpec balloon(double height) {
  return dragged(support::sphere_body("balloon", 0.15, 1.3, {0, 0, height}), 0.93, 0.12);
}

/// K − K(0) less the sum of the works [J].
double off_budget(const SimulationSpec& spec, const BodyForces& end) {
  return end.kinetic_energy - Simulation(spec).forces()[0].kinetic_energy - end.works.sum();
}

/// The drags of its two parts balance: ρ_a A_a (U − v)² = ρ_w A_w v².
TEST(WindMotion, ABoxDriftsAtTheSpeedAtWhichAirAndWaterBalance) {
  const BodySpec box = dragged(support::box_body("box", {2, 2, 1}, 500, {0, 0, 0}, 2), 0.93, 0.12);
  const double wind = 20;
  const SimulationSpec spec = in_wind(box, sea_under({.velocity = {wind, 0, 0}}));
  const Simulation end = support::after(spec, support::steps_in(400, kStep));
  // Trim and heel under the pull of both are 0.3°: of no account to the areas, half by half.
  const double drift = wind / (1 + std::sqrt(1000 / kAirDensity));
  EXPECT_NEAR(end.states()[0].linear_velocity.x(), drift, 0.01 * drift);
  EXPECT_EQ(end.counts()[0].clamped, 0);
}

TEST(WindMotion, AFallEndsAtTheTerminalVelocityInCalmAir) {
  const BodySpec ball = dragged(support::sphere_body("ball", 0.2, 200, {0, 0, 900}), 0.9, 0.1);
  const Simulation end = support::after(in_wind(ball, sea_under({})), 2000);
  const BodyForces forces = end.forces()[0];
  const double area = 2 * forces.water.wind.force.z() /
                      (kAirDensity * std::pow(end.states()[0].linear_velocity.z(), 2));
  // C_d A of a sphere is ½ (front + back) π R², of its facets a little less.
  EXPECT_NEAR(area, 0.5 * std::numbers::pi * 0.04, 0.03 * area);
  EXPECT_NEAR(forces.water.wind.force.z(), ball.mass * kGravity, 1e-3 * ball.mass * kGravity);
}

TEST(WindMotion, ALightBallTakesTheWindsSpeedWithoutOvershooting) {
  const Vector3d wind(60, 0, 0);
  for (const double step : {1.0 / 60, 0.1}) {
    Simulation simulation(in_wind(balloon(200), sea_under({.velocity = wind}), step));
    double last = 0;
    for (int i = 0; i < 40; ++i) {
      simulation.step();
      const double speed = simulation.states()[0].linear_velocity.x();
      EXPECT_LT(speed, 60 * (1 + 1e-6));
      EXPECT_GT(speed, last - 60 * 1e-6);
      last = speed;
    }
    EXPECT_GT(last, 55);
    EXPECT_GT(simulation.counts()[0].implicit, 0);
  }
}

/// It skips on the water, and stiff updates are of first order while it gathers way.
TEST(WindMotion, ALightBallOnTheWaterIsBlownAlikeWithLongAndShortSteps) {
  const auto way = [](double step) {
    const Sea sea = sea_under({.velocity = {60, 0, 0}, .exponent = 0.11});
    const Simulation end =
        support::after(in_wind(balloon(0.15), sea, step), support::steps_in(2, step));
    return end.states()[0].position.x();
  };
  const double fine = way(1.0 / 640);
  EXPECT_GT(fine, 10);
  EXPECT_NEAR(way(1.0 / 60), fine, 0.05 * fine);
  EXPECT_NEAR(way(1.0 / 20), fine, 0.1 * fine);
}

/// Still air over still water is a frame like any other: what drifts along with both moves alike.
TEST(WindMotion, IsThatInCalmAirSeenFromAFrameThatMovesWithAirAndWater) {
  const Vector3d drift(0.75, -0.5, 0);
  BodySpec box = dragged(support::box_body("box", {2, 1, 0.5}, 400, {0, 0, 1}, 2), 0.9, 0.2);
  box.initial.angular_velocity = {0.3, 0.5, -0.2};
  Simulation calm(in_wind(box, sea_under({})));
  Sea moving = sea_under({.velocity = drift});
  moving.current = drift;
  box.initial.linear_velocity += drift;
  Simulation drifting(in_wind(box, moving));
  for (int i = 0; i < 200; ++i) {
    calm.step();
    drifting.step();
  }
  const BodyState a = calm.states()[0], b = drifting.states()[0];
  EXPECT_LT((a.position + calm.time() * drift - b.position).norm(), tolerance(1e-9));
  EXPECT_LT((a.linear_velocity + drift - b.linear_velocity).norm(), tolerance(1e-9));
}

/// Only calm air over still water, or air and water that carry a free body along, give no energy.
TEST(WindMotion, EndsTheGuardOfStillWaterWhereTheAirMovesThroughTheWater) {
  const auto guarded = [](const hydro::Wind& wind, const Vector3d& current) {
    Sea sea = sea_under(wind);
    sea.current = current;
    const SimulationSpec spec =
        in_wind(dragged(support::box_body("box", {1, 1, 1}, 500, {0, 0, 0}), 1, 1), sea);
    return engine::must_not_gain_energy(support::moving_bodies(spec)[0].body);
  };
  const Vector3d still(0, 0, 0), moving(1, 2, 0);
  EXPECT_TRUE(guarded({.velocity = still}, still));
  EXPECT_TRUE(guarded({.velocity = still, .exponent = 0.11}, still));
  EXPECT_TRUE(guarded({.velocity = moving}, moving));
  EXPECT_FALSE(guarded({.velocity = moving}, still));
  EXPECT_FALSE(guarded({.velocity = still}, moving));
  EXPECT_FALSE(guarded({.velocity = moving, .exponent = 0.11}, moving));
}

TEST(WindMotion, GivesEnergyThatNoGuardOfStillWaterTakes) {
  BodySpec box = dragged(support::box_body("box", {2, 2, 2}, 100, {0, 0, 0.3}, 2), 0.93, 0.12);
  const SimulationSpec spec =
      in_wind(box, sea_under({.velocity = {30, 10, 0}, .exponent = 0.11}), 0.02);
  const Simulation end = support::after(spec, 1500);
  const BodyForces forces = end.forces()[0];
  EXPECT_GT(forces.works.wind, 0);
  EXPECT_EQ(forces.works.brake, 0);
  EXPECT_EQ(end.counts()[0].clamped, 0);
}

/// A box that waves and wind drive. What is missing from the budget is the correction (E9).
TEST(WindMotion, ClosesTheBudgetOfWorks) {
  const auto error = [](double step) {
    BodySpec box = support::box_body("box", {2, 1, 1}, 300, {0, 0, 0.1}, 3);
    box.wet = true;
    Sea sea = sea_under({.velocity = {30, 10, 0}, .exponent = 0.11});
    sea.surface = hydro::WaveSurface{{hydro::linear_wave(sea, 0.2, 0.8, 0.4, 0.2)}};
    const SimulationSpec spec = in_wind(box, sea, step);
    const BodyForces end = support::after(spec, support::steps_in(6, step)).forces()[0];
    EXPECT_GT(end.works.wind, 0.02 * std::abs(end.works.buoyancy));
    return std::abs(off_budget(spec, end)) / (std::abs(end.works.buoyancy) + end.works.wind);
  };
  const double coarse = error(0.02), fine = error(0.005);
  EXPECT_LT(coarse, 1e-3);
  // Of second order, but for pieces that are cut anew at every step: some 1e-6.
  EXPECT_LT(fine, coarse / 4);
}

/// A body that nothing wets has no load of the water, but one of the air.
TEST(WindMotion, IsInTheLogOfABodyAboveTheWater) {
  const BodySpec box = dragged(support::box_body("box", {1, 1, 1}, 500, {0, 0, 50}), 1, 0);
  const BodyForces forces =
      Simulation(in_wind(box, sea_under({.velocity = {0, 10, 0}}))).forces()[0];
  EXPECT_NEAR(forces.water.wind.force.y(), 0.5 * kAirDensity * 100, tolerance(1e-10));
  EXPECT_EQ(forces.water.buoyancy.force.z(), 0);
}

}  // namespace

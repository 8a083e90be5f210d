#include <numbers>

#include "engine/base/constants.h"
#include "hydro/mesh/mass_properties.h"
#include "tests/engine/prelude.h"

namespace {

constexpr double kWater = 1000;  // [kg/m^3]

SimulationSpec afloat(BodySpec body, double step = kStep) {
  body.wet = true;
  SimulationSpec spec = support::dry_world({body}, step);
  spec.sea = hydro::Sea{.density = kWater, .gravity = support::kGravity};
  return spec;
}

/// The loads but for buoyancy switched off.
BodySpec without_drag(BodySpec body) {
  body.coefficients.pressure_drag = {0, 0};
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  return body;
}

/// A barge of half the water's density, `height` above where it floats; wide enough to be stable.
BodySpec barge(double height) {
  return support::box_body("barge", {4, 3, 1}, kWater / 2, {0, 0, height}, 2);
}

TEST(Floating, ABargeLeftAtItsEquilibriumStays) {
  Simulation simulation(afloat(barge(0)));
  double moved = 0;
  double turned = 0;
  for (long i = 0; i < support::steps_in(60, kStep); ++i) {
    simulation.step();
    const hydro::BodyState& state = simulation.states()[0];
    moved = std::max(moved, state.position.norm());
    turned = std::max(turned, 2 * state.orientation.vec().norm());
  }
  EXPECT_LT(moved, tolerance(1e-9));
  EXPECT_LT(turned, tolerance(1e-9));
}

/// Mean time between upward crossings of the equilibrium, interpolated between steps [s].
double heave_period(const SimulationSpec& spec, int periods) {
  Simulation simulation(spec);
  std::vector<double> crossings;
  double before = simulation.states()[0].position.z();
  while (crossings.size() <= static_cast<std::size_t>(periods)) {
    simulation.step();
    const double now = simulation.states()[0].position.z();
    if (before < 0 && now >= 0) {
      crossings.push_back(simulation.time() - spec.step * now / (now - before));
    }
    before = now;
  }
  return (crossings.back() - crossings.front()) / periods;
}

// Undamped heave of a wall-sided body is linear: ω0² = ρ g A/m.
TEST(Floating, ABargeBobsAtItsOwnFrequencyHoweverLongTheStep) {
  const BodySpec body = without_drag(barge(0.2));
  const double omega = std::sqrt(kWater * support::kGravity * 4 * 3 / body.mass);
  const double exact = 2 * std::numbers::pi / omega;
  for (const double step : {1.0 / 15, 1.0 / 30, 0.01}) {
    // The explicit step, in substeps of a quarter of a radian at most, is of the fourth order. A
    // crossing found by a straight line is off by less than (ω h)³/50 of a step, shared by the
    // periods.
    const double bound = exact * std::pow(std::min(omega * step, 0.25), 4) / 24 +
                         step * std::pow(omega * step, 3) / 50 / 20;
    EXPECT_NEAR(heave_period(afloat(body, step), 20), exact, tolerance(1.5 * bound)) << step;
  }
}

/// Heights of a heaving barge 0, 0.1, … 5 s after it was let go, by steps of the given length [m].
std::vector<double> simulated_heave(const BodySpec& body, double step) {
  Simulation simulation(afloat(body, step));
  std::vector<double> heights = {simulation.states()[0].position.z()};
  while (heights.size() <= 50) {
    for (long i = 0; i < support::steps_in(0.1, step); ++i) simulation.step();
    heights.push_back(simulation.states()[0].position.z());
  }
  return heights;
}

/// The same by the classical Runge-Kutta method on m z'' = -ρ g A z - ½ ρ C_p A |z'| z': only the
/// bottom of a wall-sided body meets the flow.
std::vector<double> integrated_heave(double mass, double area, double height, double drag) {
  constexpr double kFine = 1e-4;  // [s]; its error is below 1e-12 m
  const auto rate = [&](const Eigen::Vector2d& s) {
    const double force =
        -kWater * area * (support::kGravity * s[0] + drag / 2 * std::abs(s[1]) * s[1]);
    return Eigen::Vector2d(s[1], force / mass);
  };
  Eigen::Vector2d s(height, 0);
  std::vector<double> heights = {height};
  for (int i = 1; i <= 50'000; ++i) {
    const Eigen::Vector2d a = rate(s);
    const Eigen::Vector2d b = rate(s + kFine / 2 * a);
    const Eigen::Vector2d c = rate(s + kFine / 2 * b);
    const Eigen::Vector2d d = rate(s + kFine * c);
    s += kFine / 6 * (a + 2 * b + 2 * c + d);
    if (i % 1000 == 0) heights.push_back(s[0]);
  }
  return heights;
}

// The time stepping is of second order: the error is a quarter at half the step.
TEST(Floating, DampedBobbingConvergesToItsEquationOfMotion) {
  BodySpec body = barge(0.3);
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  body.coefficients.pressure_drag = {2, 2, 0};  // Steady from the start.
  const std::vector<double> exact = integrated_heave(body.mass, 4 * 3, 0.3, 2);
  std::vector<double> errors;
  for (const double step : {0.01, 0.005, 0.0025}) {
    const std::vector<double> heights = simulated_heave(body, step);
    double error = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
      error = std::max(error, std::abs(heights[i] - exact[i]));
    errors.push_back(error);
  }
  // The amplitude of 0.3 m times the phase error (ω h)²/24 of 5 s, ω = 4.4 1/s: 5e-4 m.
  EXPECT_LT(errors[0], tolerance(5e-4));
  // Order 1.9, as |z'| z' has a kink where the motion turns environment.
  EXPECT_GT(errors[0] / errors[1], 3.7) << errors[0];
  EXPECT_GT(errors[1] / errors[2], 3.7) << errors[1];
}

TEST(Floating, DragBringsABodyToRestAtArchimedesDraught) {
  BodySpec body = barge(0.3);
  body.coefficients.pressure_drag = {2, 2};
  const Simulation simulation = support::after(afloat(body), support::steps_in(200, kStep));
  // Quadratic drag leaves an amplitude that falls with 1/t.
  EXPECT_NEAR(simulation.states()[0].position.z(), 0, tolerance(4e-3));
}

TEST(Floating, NeverGainsEnergyFromStillWater) {
  BodySpec body = barge(2);
  body.initial.orientation = Eigen::AngleAxisd(0.4, Vector3d(1, 0.5, 0).normalized());
  const SimulationSpec spec = afloat(body);
  Simulation simulation(spec);
  const double start = support::total_energy(spec, simulation.states());
  double lowest = start;
  for (long i = 0; i < support::steps_in(20, kStep); ++i) {
    simulation.step();
    const double now = support::total_energy(spec, simulation.states());
    ASSERT_LE(now, lowest + 2 * engine::kEnergyGain * start) << i;
    lowest = std::min(lowest, now);
  }
  EXPECT_LT(lowest, 0.2 * start);
}

// A sphere of half density floats with its centre in the water plane, whatever its turn; as a mesh
// it is symmetric about that plane only up to its facets.
TEST(Floating, ASphereOfHalfDensityFloatsHalfSubmerged) {
  BodySpec ball = support::sphere_body("ball", 1, kWater / 2, {0, 0, 0.3});
  ball.mass = kWater / 2 * hydro::solid_properties(ball.mesh_B).volume;
  ball.coefficients.pressure_drag = {2, 2, 0};  // A ball that bobs takes hardly any else.
  const Simulation simulation = support::after(afloat(ball), support::steps_in(200, kStep));
  EXPECT_NEAR(simulation.states()[0].position.z(), 0, tolerance(8e-3));
}

TEST(Floating, WithoutBuoyancyAndDragABodyFallsAsWithoutWater) {
  BodySpec cube = without_drag(support::box_body("cube", {1, 1, 1}, 500, {0, 0, 0}));
  cube.coefficients.buoyancy = false;
  const Simulation wet = support::after(afloat(cube), 100);
  const Simulation dry = support::after(support::dry_world({cube}, kStep), 100);
  EXPECT_EQ(wet.states()[0].position, dry.states()[0].position);
}

TEST(Floating, ABodyDriftsWithTheCurrentInTheEnd) {
  BodySpec body = barge(0);
  body.coefficients.pressure_drag = {2, 2};
  SimulationSpec spec = afloat(body);
  spec.sea->current = {0.5, 0, 0};
  const Simulation simulation = support::after(spec, support::steps_in(100, kStep));
  // Quadratic drag: the difference of speeds falls with 1/t, to m/(½ ρ C_p A t) = 0.04 m/s.
  EXPECT_NEAR(simulation.states()[0].linear_velocity.x(), 0.5, tolerance(0.04));
}

}  // namespace

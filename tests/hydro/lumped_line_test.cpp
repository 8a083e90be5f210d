#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hydro/lines/catenary.h"
#include "hydro/lines/lumped_step.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

/// Lines with inertia against catenaries, closed forms and another program.

namespace {

using Eigen::Vector3d;
using hydro::CatenarySolution;
using hydro::LineEnds;
using hydro::LumpedLine;
using hydro::LumpedState;

constexpr double kPull = 9.81;  // [m/s^2]

LineEnds ends_at(const Vector3d& first, const Vector3d& second) {
  LineEnds ends;
  ends << first, second;
  return ends;
}

/// A step with ends that are where they are to be.
void take_step(const LumpedLine& line, double length, const LineEnds& ends, const hydro::Sea* sea,
               double time, double h, LumpedState& state) {
  hydro::LumpedStep step;
  step.begin(line, length, ends, sea, time, h, state);
  step.end(ends, state);
}

/// Horizontal and vertical pull on the first end, over those of the catenary, less 1.
Eigen::Vector2d error_of_hanging(int segments) {
  const LumpedLine line{.segments = segments,
                        .stiffness = 7.5e8,
                        .mass = 100,
                        .weight = 200,
                        .diameter = 0.1,
                        .gravity = kPull};
  const LineEnds ends = ends_at({400, 0, 200}, {0, 0, 0});
  const LumpedState rest = hydro::line_at_rest(line, 500, ends, nullptr);
  const CatenarySolution exact = hydro::solve_catenary(
      {.length = 500, .weight = 200, .stiffness = 7.5e8, .friction = 0}, 400, 200, false);
  return {-rest.forces(0, 0) / exact.horizontal - 1, -rest.forces(2, 0) / exact.vertical - 1};
}

TEST(LumpedLineAtRest, TendsToTheCatenaryInTheSquareOfItsSegments) {
  const Eigen::Vector2d coarse = error_of_hanging(20), fine = error_of_hanging(40);
  EXPECT_LT(coarse.norm(), support::tolerance(1.2e-3));
  EXPECT_LT(((4 * fine - coarse) / 3).norm(), support::tolerance(1e-6));
}

TEST(LumpedLineAtRest, LiesOnTheBottomAsACatenaryDoes) {
  const LumpedLine line{.segments = 40,
                        .stiffness = 7.5e8,
                        .mass = 100,
                        .weight = 800,
                        .diameter = 0.1,
                        .gravity = kPull,
                        .bottom = 0};
  const LumpedState rest =
      hydro::line_at_rest(line, 500, ends_at({400, 0, 200}, {0, 0, 0}), nullptr);
  const CatenarySolution exact = hydro::solve_catenary(
      {.length = 500, .weight = 800, .stiffness = 7.5e8, .friction = 0}, 400, 200, true);
  EXPECT_NEAR(rest.forces.col(0).norm() / exact.tension(), 1, support::tolerance(1e-3));
  EXPECT_NEAR(hydro::resting_length(line, 500, rest), exact.resting, 500.0 / 40);
}

TEST(LumpedLineAtRest, BearsItsWeightInAnyPose) {
  support::Random random(4);
  for (int i = 0; i < 10; ++i) {
    const LumpedLine line{
        .segments = 1 + i, .stiffness = 1e5, .mass = 2, .weight = 15, .gravity = kPull};
    const LumpedState rest =
        hydro::line_at_rest(line, 10, ends_at(random.vector(4), random.vector(4)), nullptr);
    const Vector3d sum = rest.forces.col(0) + rest.forces.col(1);
    EXPECT_LT((sum - Vector3d(0, 0, -150)).norm(), support::tolerance(1e-6)) << i;
  }
}

TEST(LumpedLineAtRest, WeighsMoreInTheAir) {
  const LumpedLine line{
      .stiffness = 1e6, .mass = 3, .weight = 20, .diameter = 0.03, .gravity = kPull};
  hydro::Sea sea;
  sea.level = -100;
  const LumpedState rest = hydro::line_at_rest(line, 10, ends_at({0, 0, 0}, {8, 0, 0}), &sea);
  EXPECT_NEAR(rest.forces.row(2).sum(), -3 * kPull * 10, support::tolerance(1e-6));
}

/// A taut string plucked in its first mode: its period over 2 L √(m/T), less 1.
double error_of_period(double h) {
  constexpr double kLength = 10, kTension = 1000, kMass = 0.4;
  const LumpedLine line{.segments = 40, .stiffness = 1e6, .mass = kMass, .gravity = 0};
  const LineEnds ends = ends_at({0, 0, 0}, {kLength * (1 + kTension / 1e6), 0, 0});
  LumpedState state = hydro::line_at_rest(line, kLength, ends, nullptr);
  const double span = ends(0, 1);
  for (Eigen::Index i = 1; i < 40; ++i) {
    const double y = 1e-3 * std::sin(std::numbers::pi * static_cast<double>(i) / 40);
    state.places(1, i) = state.places_before(1, i) = y;
  }
  const double period = 2 * span * std::sqrt(kMass / (1 + kTension / 1e6) / kTension);
  double before = state.places(1, 20), time = 0;
  int passages = 0;
  while (passages < 4) {
    take_step(line, kLength, ends, nullptr, time + h, h, state);
    const double now = state.places(1, 20);
    time += h;
    if (before * now < 0 && ++passages == 4) time -= h * now / (now - before);
    before = now;
  }
  return time / (1.75 * period) - 1;
}

TEST(LumpedLine, SwingsAsAStringInTheSquareOfTheStep) {
  const double limit = error_of_period(0.0005);  // what the segments leave
  const double coarse = error_of_period(0.004) - limit, fine = error_of_period(0.001) - limit;
  EXPECT_LT(std::abs(limit), support::tolerance(2e-3));
  EXPECT_LT(std::abs(fine), std::abs(coarse) / 8);  // it would be 21
}

/// The line with a diameter of 4 cm, and what the water then does to it.
LumpedLine rope(LumpedLine line) {
  line.diameter = 0.04;
  line.drag_across = 1.2;
  line.drag_along = 0.05;
  line.added_mass = 1;
  return line;
}

TEST(LumpedLine, FallsThroughWaterAtTheSpeedOfItsDrag) {
  // Across: w = ½ρ C_d d v²; along: w = ½ρ π C_t d v².
  for (const bool across : {true, false}) {
    const LumpedLine line =
        rope({.segments = 8, .stiffness = 1e6, .mass = 5, .weight = 30, .gravity = kPull});
    hydro::Sea sea;
    sea.density = 1025;
    sea.level = 1000;
    const double cd = across ? 1.2 : 0.05 * std::numbers::pi;
    const double speed = std::sqrt(30 / (0.5 * 1025 * cd * 0.04));
    const Vector3d along = across ? Vector3d::UnitX() : Vector3d::UnitZ();
    LineEnds ends = ends_at(4 * along, -4 * along);
    LumpedState state = hydro::line_at_rest(line, 8, ends, &sea);
    for (int i = 1; i <= 2000; ++i) {
      ends.row(2).array() -= speed * 0.01;
      take_step(line, 8, ends, &sea, 0.01 * i, 0.01, state);
    }
    // At that speed the water bears the line: its holders have nothing to do.
    EXPECT_LT((state.forces.col(0) + state.forces.col(1)).norm(), support::tolerance(1e-3 * 240))
        << across;
  }
}

TEST(LumpedLine, IsNotThrownAboutByAnyStepOrStiffness) {
  hydro::Sea sea;
  support::Random random(9);
  for (const double h : {1e-3, 0.05, 0.5})
    for (const double stiffness : {1e3, 1e7, 1e11}) {
      const LumpedLine line = rope({.segments = 12,
                                    .stiffness = stiffness,
                                    .mass = 20,
                                    .weight = 150,
                                    .friction = 0.5,
                                    .gravity = kPull,
                                    .bottom = -20});
      LineEnds ends = ends_at({20, 0, -1}, {-10, 0, -20});
      LumpedState state = hydro::line_at_rest(line, 38, ends, &sea);
      for (int i = 1; i <= 200; ++i) {
        ends.col(0) = Vector3d(20, 0, -1) + random.vector(0.5);
        take_step(line, 38, ends, &sea, h * i, h, state);
        ASSERT_TRUE(state.places.allFinite() && state.forces.allFinite());
      }
      for (int i = 1; h * i < 30; ++i) take_step(line, 38, ends, &sea, h * i, h, state);
      ASSERT_LT(state.velocities.colwise().norm().maxCoeff(), 1) << h << ' ' << stiffness;
    }
}

/// Least and largest tension of the fairlead of a chain of 158 m that moves along by a sine [kN].
struct Tensions {
  double least, largest;
};
Tensions driven_chain(double amplitude, double period, double drag) {
  const LumpedLine line{.segments = 40,
                        .stiffness = 2e8,
                        .mass = 53.3,
                        .weight = 500,
                        .diameter = 0.054,
                        .drag_across = drag,
                        .drag_along = 0.05,
                        .added_mass = 1,
                        .friction = 0.5,
                        .gravity = kPull,
                        .bottom = -50};
  hydro::Sea sea;
  sea.density = 1025;
  LineEnds ends = ends_at({145, 0, -1}, {0, 0, -50});
  LumpedState state = hydro::line_at_rest(line, 158, ends, &sea);
  Tensions found{1e9, 0};
  const double h = 1.0 / 60;
  for (int i = 1; i * h < 8 * period; ++i) {
    const double time = i * h, ramp = std::min(1.0, time / period / 2);
    ends(0, 0) = 145 + amplitude * ramp * std::sin(2 * std::numbers::pi * time / period);
    take_step(line, 158, ends, &sea, time, h, state);
    if (time < 6 * period) continue;
    const double tension = state.forces.col(0).norm() / 1000;
    found = {std::min(found.least, tension), std::max(found.largest, tension)};
  }
  return found;
}

TEST(LumpedLine, HasTheTensionsOfADrivenChainThatMoorDynHas) {
  // MoorDyn 2.7.1 with 40 segments, steps of 0.2 ms and a bottom without friction. A catenary at
  // rest has 75 to 124 kN at 2 m, and 83 to 107 kN at 1 m, whatever the period.
  struct Case {
    double drag, amplitude, period, least, largest;
  };
  for (const Case& c : {Case{1.2, 2, 10, 78.0, 120.8}, Case{1.2, 1, 5, 74.8, 112.5},
                        Case{1.2, 1, 3, 23.0, 183.0}, Case{2.4, 2, 10, 64.1, 136.0},
                        Case{2.4, 1, 5, 62.8, 127.8}, Case{2.4, 1, 3, 20.3, 181.5}}) {
    const Tensions found = driven_chain(c.amplitude, c.period, c.drag);
    EXPECT_NEAR((found.largest - found.least) / (c.largest - c.least), 1, support::tolerance(0.1))
        << c.drag << ' ' << c.period << ": " << found.least << " to " << found.largest;
  }
}

}  // namespace

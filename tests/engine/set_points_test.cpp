#include "engine/machines/set_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "tests/engine/rig_specs.h"

namespace {

using engine::Measurement;
using engine::SetPoints;
using engine::SimulationSpec;

class Function : public engine::Signal {
 public:
  explicit Function(std::function<double(double)> f, bool jumps = false)
      : f_(std::move(f)), jumps_(jumps) {}
  double at(double time) const override { return f_(time); }
  bool jumps() const override { return jumps_; }
  std::string identity() const override { return "function"; }

 private:
  std::function<double(double)> f_;
  bool jumps_;
};

std::shared_ptr<const engine::Signal> signal(std::function<double(double)> f, bool jumps = false) {
  return std::make_shared<Function>(std::move(f), jumps);
}

/// One set point of this control.
SimulationSpec controlled(engine::ControlSpec control, double initial = 0, double unit = 1) {
  SimulationSpec spec;
  control.set = support::add_set_point(spec, "value", initial, unit);
  spec.controls = {std::move(control)};
  return spec;
}

double nothing(const Measurement&) { return 0; }

TEST(SetPoints, FollowAParabolaExactlyWithinAStep) {
  const SimulationSpec spec =
      controlled({.source = signal([](double t) { return 3 * t * t - t; })});
  SetPoints points(spec);
  points.begin_step(2, 0.5, nothing);
  for (const double t : {2.0, 2.1, 2.25, 2.4, 2.5}) {
    EXPECT_NEAR(points.value(0, t), 3 * t * t - t, 1e-12);
    EXPECT_NEAR(points.rate(0, t), 6 * t - 1, 1e-11);
  }
}

TEST(SetPoints, TakeTheValueOfAStepsStartFromWhatJumps) {
  const SimulationSpec spec =
      controlled({.source = signal([](double t) { return t < 0.3 ? 1.0 : 5.0; }, true)});
  SetPoints points(spec);
  points.begin_step(0.2, 0.1, nothing);
  EXPECT_EQ(points.value(0, 0.3), 1);
  points.begin_step(0.1 * 3, 0.1, nothing);  // 0.30000000000000004
  EXPECT_EQ(points.value(0, 0.35), 5);
  points.begin_step(0.29999999999999999, 0.1, nothing);
  EXPECT_EQ(points.value(0, 0.35), 5);
}

TEST(SetPoints, ChangeNoFasterThanTheirRate) {
  const SimulationSpec spec =
      controlled({.source = signal([](double) { return 10.0; }), .start = 1, .rate = 2});
  SetPoints points(spec);
  double t = 0;
  for (int i = 0; i < 40; ++i, t += 0.1) {
    points.begin_step(t, 0.1, nothing);
    EXPECT_NEAR(points.latest(0), std::clamp(2 * (t + 0.1 - 1), 0.0, 10.0), 1e-9) << t;
  }
}

TEST(SetPoints, AreKeptWithinTheirBoundsAndInTheUnitsOfTheirNames) {
  SimulationSpec spec =
      controlled({.source = signal([](double t) { return 100 * t; })}, 0, std::numbers::pi / 180);
  spec.set_points[0].greatest = 0.5;  // rad
  SetPoints points(spec);
  points.begin_step(0.1, 0.1, nothing);
  EXPECT_NEAR(points.value(0, 0.15), 15 * std::numbers::pi / 180, 1e-12);
  points.begin_step(1, 0.1, nothing);
  EXPECT_NEAR(points.latest(0), 0.5, 1e-12);
  EXPECT_NEAR(points.readings()[0], 0.5 * 180 / std::numbers::pi, 1e-12);
}

TEST(SetPoints, OfAnotherProgramComeBeforeTheControl) {
  const SimulationSpec spec = controlled({.source = signal([](double) { return 1.0; })});
  SetPoints points(spec);
  points.set(points.find("value"), 7.0);
  points.begin_step(0, 0.1, nothing);
  EXPECT_EQ(points.latest(0), 7);
  points.set(0, std::nullopt);
  points.begin_step(0.1, 0.1, nothing);
  EXPECT_EQ(points.latest(0), 1);
  EXPECT_THROW(points.find("other"), std::invalid_argument);
}

/// x' = u, with u = kp (1 − x) + ki ∫(1 − x): x'' + kp x' + ki x = ki.
TEST(Pid, BringsAnIntegratorToItsTargetAsTheClosedFormTells) {
  const double h = 1e-3;
  const SimulationSpec spec = controlled(
      {.source = engine::Pid{.target = signal([](double) { return 1.0; }), .kp = 2, .ki = 1}});
  SetPoints points(spec);
  double x = 0;
  for (int i = 0; i < 4000; ++i) {
    points.begin_step(i * h, h, [&](const Measurement&) { return x; });
    x += h * points.latest(0);
  }
  // With kp² = 4 ki and x(0) = 0, x'(0) = kp: 1 − x = (1 − t) e^(−t).
  EXPECT_NEAR(1 - x, (1 - 4.0) * std::exp(-4.0), 5e-3);
}

TEST(Pid, DoesNotWindUpWhileItsOutputIsLimited) {
  const double h = 0.01;
  const SimulationSpec spec =
      controlled({.source = engine::Pid{.target = signal([](double) { return 10.0; }),
                                        .kp = 1,
                                        .ki = 1,
                                        .least = -1,
                                        .greatest = 1}});
  SetPoints points(spec);
  double x = 0, highest = 0;
  for (int i = 0; i < 3000; ++i) {
    points.begin_step(i * h, h, [&](const Measurement&) { return x; });
    EXPECT_LE(std::abs(points.latest(0)), 1);
    x += h * points.latest(0);
    highest = std::max(highest, x);
  }
  EXPECT_NEAR(x, 10, 0.01);
  EXPECT_LT(highest, 10.6);  // an integral that grew for 9 s would carry it some 9 farther
}

TEST(Pid, FollowsAHeadingThroughFullTurns) {
  const SimulationSpec spec =
      controlled({.source = engine::Pid{.of = {.quantity = Measurement::Quantity::heading},
                                        .unit = std::numbers::pi / 180,
                                        .target = signal([](double) { return 0.0; }),
                                        .kp = 1}});
  SetPoints points(spec);
  for (int i = 0; i <= 100; ++i) {
    const double heading = std::remainder(0.1 * i, 2 * std::numbers::pi);
    points.begin_step(i, 1, [&](const Measurement&) { return heading; });
    EXPECT_NEAR(points.latest(0), -0.1 * i * 180 / std::numbers::pi, 1e-9);
  }
}

TEST(Relay, SwitchesWithHysteresis) {
  const SimulationSpec spec =
      controlled({.source = engine::Relay{.low = -1, .high = 2, .values = {5, -5}}});
  SetPoints points(spec);
  const auto given = [&](double measured) {
    points.begin_step(0, 1, [&](const Measurement&) { return measured; });
    return points.latest(0);
  };
  EXPECT_EQ(given(0), 5);
  EXPECT_EQ(given(1.9), 5);
  EXPECT_EQ(given(2.1), -5);
  EXPECT_EQ(given(0), -5);
  EXPECT_EQ(given(-0.9), -5);
  EXPECT_EQ(given(-1.1), 5);
  EXPECT_EQ(given(1), 5);
}

}  // namespace

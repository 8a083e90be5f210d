#include "engine/motion/processing_correction.h"

#include "engine/simulation_state.h"
#include "engine/state_data.h"
#include "tests/engine/prelude.h"

/// The difference between the state that is moved on and the one that is reported.

namespace {

using engine::Motion;
using engine::MovingBody;

TEST(ProcessingCorrection, IsThatOfAnOscillationInClosedForm) {
  // x = cos ωt has a = −ω² cos ωt and a' = ω³ sin ωt.
  const SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  MovingBody box = support::moving_bodies(spec)[0];
  const double omega = 1, h = 0.01;
  for (int i = 0; i < 3; ++i) {
    Vector6d a = Vector6d::Zero();
    a.z() = -omega * omega * std::cos(omega * (0.5 + (i - 2.5) * h));
    box.motion.accelerations.add(a, h, box.body.radius);
  }
  const auto found = engine::find_correction(box.body, box.motion, h);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.z(), -h * h / 24 * std::cos(0.5), 1e-4 * h * h / 24);
  EXPECT_NEAR(found->velocity.z(), -h * h / 24 * std::sin(0.5), 1e-3 * h * h / 24);
  Motion there = box.motion;
  engine::correct(box.body, *found, 1, there);
  engine::correct(box.body, *found, -1, there);
  EXPECT_LT((there.state.position - box.motion.state.position).norm(), 1e-15);
  box.motion.accelerations.clear();
  EXPECT_FALSE(engine::find_correction(box.body, box.motion, h));
}

TEST(ProcessingCorrection, IsNoneOfABodyThatTurnsSoFarThatItsAccelerationsOnlySeemToFollow) {
  // The weight in body axes is the same after each whole turn.
  const SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  MovingBody box = support::moving_bodies(spec)[0];
  const double h = 0.01;
  Vector6d a = Vector6d::Zero();
  a.z() = -9.81;
  for (int i = 0; i < 3; ++i) box.motion.accelerations.add(a, h, box.body.radius);
  ASSERT_TRUE(box.motion.accelerations.resolved());
  EXPECT_TRUE(engine::find_correction(box.body, box.motion, h));
  box.motion.state.angular_velocity = {2 * std::numbers::pi / h, 0, 0};
  EXPECT_FALSE(engine::find_correction(box.body, box.motion, h));
}

TEST(ProcessingCorrection, KeepsNoAccelerationsOfSubstepsThatTurnedABodyFar) {
  // A body that tumbles may turn slowly for a moment, and has no smooth motion behind it.
  const auto history_at = [](double spin) {
    SimulationSpec spec = support::box_in_still_water({0, 0, -5});
    spec.bodies[0].initial.angular_velocity = {spin, 0, 0};
    spec.bodies[0].coefficients.pressure_drag = {0, 0};
    spec.bodies[0].coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
    Simulation simulation(spec);
    for (int i = 0; i < 3; ++i) simulation.step();
    return simulation.state().data().bodies[0].motion.accelerations;
  };
  EXPECT_FALSE(history_at(1).empty());
  EXPECT_TRUE(history_at(1e5).empty());
}

}  // namespace

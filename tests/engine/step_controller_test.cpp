#include "engine/step/step_controller.h"

#include "tests/engine/prelude.h"

/// The error of a substep, and the length that it asks for.

namespace {

using engine::Motion;
using engine::MovingBody;

TEST(StepController, FindsTheErrorOfAKnownDifference) {
  const SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  const MovingBody box = support::moving_bodies(spec)[0];
  Motion other = box.motion;
  const double h = 0.1, tolerance = 1e-3, radius = std::sqrt(3.0) / 2;
  other.state.position.x() += 3 * tolerance * h * radius;
  EXPECT_NEAR(engine::estimated_error(box.body, box.motion, other, h, tolerance), 1, 1e-12);
  EXPECT_EQ(engine::estimated_error(box.body, box.motion, box.motion, h, tolerance), 0);
}

TEST(StepController, ProposesALengthOfTheThirdOrder) {
  // The error over what a substep may have is of second order: a quarter of it, twice the length.
  const double near_one = engine::length_for_error(0.1, 1.0);
  EXPECT_NEAR(engine::length_for_error(0.1, 0.25) / near_one, 2, 1e-12);
  EXPECT_EQ(engine::length_for_error(0.1, 0), 0.4);
  EXPECT_EQ(engine::length_for_error(0.1, 1e9), 0.025);
}

}  // namespace

#include <numbers>

#include "engine/constants.h"
#include "engine/energy_limiter.h"
#include "engine/processing_correction.h"
#include "engine/step_controller.h"
#include "engine/substep.h"
#include "engine/substep_limit.h"
#include "tests/engine/prelude.h"

/// What looks at a substep before or after it is taken, by itself.

namespace {

using engine::Motion;
using engine::MovingBody;

/// A box of 1 m in flat water.
SimulationSpec afloat(const Vector3d& position) {
  BodySpec box = support::box_body("box", {1, 1, 1}, 500, position, 2);
  box.wet = true;
  SimulationSpec spec = support::dry_world({box}, kStep);
  spec.sea = hydro::Sea{.density = 1000, .gravity = kGravity};
  return spec;
}

TEST(StepController, FindsTheErrorOfAKnownDifference) {
  const SimulationSpec spec = afloat({0, 0, 0});
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

TEST(SubstepLimit, LetsABodyCrossTheSurfaceInHalvesOfItsHeight) {
  SimulationSpec spec = afloat({0, 0, 1});
  spec.bodies[0].initial.linear_velocity = {0, 0, -30};
  const MovingBody box = support::moving_bodies(spec)[0];
  const double h = engine::substep_limit(box.body, box.motion, 0.1, 0.1, false);
  EXPECT_LE(30 * h, engine::kLargestCrossing * 1.0 + 1e-12);
  EXPECT_NEAR(0.1 / h, std::round(0.1 / h), 1e-9);
  // Far above the water it does not matter.
  spec.bodies[0].initial.position.z() = 50;
  const MovingBody high = support::moving_bodies(spec)[0];
  EXPECT_EQ(engine::substep_limit(high.body, high.motion, 0.1, 0.1, false), 0.1);
}

TEST(SubstepLimit, LetsAWetBodyTurnByHalfARadian) {
  SimulationSpec spec = afloat({0, 0, -5});
  spec.bodies[0].initial.angular_velocity = {0, 40, 0};
  const MovingBody box = support::moving_bodies(spec)[0];
  EXPECT_LE(40 * engine::substep_limit(box.body, box.motion, 0.1, 0.1, false),
            engine::kLargestWetTurn + 1e-12);
  // However fast it spins, there are no more substeps than kMostSubsteps.
  spec.bodies[0].initial.angular_velocity = {0, 4e6, 0};
  const MovingBody fast = support::moving_bodies(spec)[0];
  EXPECT_NEAR(engine::substep_limit(fast.body, fast.motion, 0.1, 0.1, false),
              0.1 / engine::kMostSubsteps, 1e-15);
}

TEST(SubstepLimit, KnowsCrossingsAndOvershoots) {
  const SimulationSpec spec = afloat({0, 0, 0});
  const MovingBody box = support::moving_bodies(spec)[0];
  const auto at = [](double z, double speed) {
    return BodyState{.position = {0, 0, z}, .linear_velocity = {0, 0, speed}};
  };
  EXPECT_TRUE(engine::crosses_surface(box.body, at(0.6, 0), at(0.4, 0)));
  EXPECT_FALSE(engine::crosses_surface(box.body, at(-2, 0), at(-2.1, 0)));
  EXPECT_FALSE(engine::crosses_surface(box.body, at(5, 0), at(4, 0)));
  // Thrown by 10 m in 0.1 s through a surface that it is 1 m high in.
  EXPECT_TRUE(engine::overshoots_surface(box.body, at(-0.2, 0), at(9.8, 200), 0.1));
  // It flew as far, but no load threw it.
  EXPECT_FALSE(engine::overshoots_surface(box.body, at(-0.2, 100), at(9.8, 100), 0.1));
}

TEST(ProcessingCorrection, IsThatOfAnOscillationInClosedForm) {
  // x = cos ωt has a = −ω² cos ωt and a' = ω³ sin ωt.
  const SimulationSpec spec = afloat({0, 0, 0});
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

/// A substep of a box from rest to the given speed at the same place.
struct Kicked {
  explicit Kicked(double speed) : spec(afloat({0, 0, -3})), bodies(support::moving_bodies(spec)) {
    member.moving = &bodies[0];
    member.end = member.start_of();
    member.end.state.linear_velocity.x() = speed;
    member.abrupt = true;
  }
  struct Member : engine::SubstepBody {
    Motion start_of() const { return moving->motion; }
  };
  SimulationSpec spec;
  std::vector<MovingBody> bodies;
  Member member;
};

TEST(EnergyLimiter, HalvesAndThenRemovesWhatStillWaterCannotGive) {
  Kicked kicked(10);
  engine::EnergyLimiter limiter({0}, kicked.bodies);
  EXPECT_TRUE(limiter.judge({&kicked.member}, 0.01, false));
  limiter.clamp({&kicked.member});
  EXPECT_LT(kicked.member.end.state.linear_velocity.norm(), 1);
  EXPECT_EQ(kicked.bodies[0].counts.clamped, 1);
}

TEST(EnergyLimiter, LeavesSmoothSubstepsContactsAndWavesAlone) {
  Kicked smooth(10);
  smooth.member.abrupt = false;
  engine::EnergyLimiter limiter({0}, smooth.bodies);
  EXPECT_FALSE(limiter.judge({&smooth.member}, 0.01, false));
  EXPECT_TRUE(limiter.judge({&smooth.member}, 0.01, true));  // A half is judged in any case.
  smooth.member.touching = true;
  EXPECT_FALSE(limiter.judge({&smooth.member}, 0.01, true));
}

}  // namespace

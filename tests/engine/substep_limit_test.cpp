#include "engine/step/substep_limit.h"

#include "engine/base/constants.h"
#include "hydro/airy_waves.h"
#include "tests/engine/prelude.h"

/// How long a substep may be by the motion.

namespace {

using engine::MovingBody;

TEST(SubstepLimit, LetsABodyCrossTheSurfaceInHalvesOfItsHeight) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 1});
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
  SimulationSpec spec = support::box_in_still_water({0, 0, -5});
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
  const SimulationSpec spec = support::box_in_still_water({0, 0, 0});
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
  // The side of a wave throws it as far along the surface.
  BodyState aside = at(-0.2, 0);
  aside.position.x() = 10;
  aside.linear_velocity.x() = 200;
  EXPECT_TRUE(engine::overshoots_surface(box.body, at(-0.2, 0), aside, 0.1));
}

}  // namespace

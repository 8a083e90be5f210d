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

TEST(SubstepLimit, KnowsWhatBuoyancyMayThrowWhereNoEnergyBoundsIt) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 0.2});
  BodySpec& box = spec.bodies[0];
  box.added_mass = nullptr;
  box.coefficients.pressure_drag = {0, 0};
  box.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  const auto may_be_thrown = [&](double h, double height = 0.2) {
    const MovingBody moving = support::moving_bodies(spec)[0];
    engine::Motion at = moving.motion;
    at.state.position.z() = height;
    return engine::may_be_thrown(moving.body, at, at, h);
  };
  // ρ V g h²/2m is half of the height of 1 m there.
  const double longest = std::sqrt(box.mass / (spec.sea->density * spec.sea->gravity));
  EXPECT_FALSE(may_be_thrown(1.001 * longest));  // The energy is judged in still water.
  spec.sea->surface = hydro::WaveSurface{{hydro::deep_water_wave(0.1, 20, 0, 0, 9.81)}};
  EXPECT_TRUE(may_be_thrown(1.001 * longest));
  EXPECT_FALSE(may_be_thrown(0.999 * longest));
  EXPECT_FALSE(may_be_thrown(1.001 * longest, 2));
  box.coefficients.pressure_drag = {1, 0};
  EXPECT_FALSE(may_be_thrown(1.001 * longest));
}

}  // namespace

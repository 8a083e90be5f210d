#include "engine/step/energy_limiter.h"

#include "engine/step/substep.h"
#include "tests/engine/prelude.h"

/// The limiter of the energy, by itself.

namespace {

using engine::Motion;
using engine::MovingBody;

/// A substep of a box from rest to the given speed at the same place.
struct Kicked {
  explicit Kicked(double speed)
      : spec(support::box_in_still_water({0, 0, -3})), bodies(support::moving_bodies(spec)) {
    member.moving = &bodies[0];
    member.end = member.start_of();
    member.end.state.linear_velocity.x() = speed;
    member.needs_energy_check = true;
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
  smooth.member.needs_energy_check = false;
  engine::EnergyLimiter limiter({0}, smooth.bodies);
  EXPECT_FALSE(limiter.judge({&smooth.member}, 0.01, false));
  EXPECT_TRUE(limiter.judge({&smooth.member}, 0.01, true));  // A half is judged in any case.
  smooth.member.touching = true;
  EXPECT_FALSE(limiter.judge({&smooth.member}, 0.01, true));
}

}  // namespace

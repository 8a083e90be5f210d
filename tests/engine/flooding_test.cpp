#include "engine/hollows/flooding.h"

#include "engine/hollows/pocket_search.h"
#include "tests/engine/prelude.h"
#include "tests/support/hollows.h"

/// Water and pockets of bodies that are led along given ways, in substeps of any length.

namespace {

/// The open box of 2 × 1 × 1 m, its rim half a metre above its centre, in still water.
SimulationSpec scene_of_open_box() {
  BodySpec box;
  box.name = "box";
  box.mesh_B = hydro::translated(support::open_box(), {0, 0, -0.5});
  box.mass = 400;
  box.inertia_B = Vector3d(60, 160, 170).asDiagonal();
  box.interior = engine::Interior::flooding;
  box.collision = CollisionShape::none;
  SimulationSpec spec = support::dry_world({box}, kStep);
  spec.sea = hydro::Sea{.density = 1000, .gravity = kGravity};
  return spec;
}

/// A rim that is under water for 0.06 s about a time [s], by 0.03 m at most.
BodyState dipping(double time, double middle) {
  constexpr double kDepth = 0.03, kHalf = 0.03;
  const double since = (time - middle) / kHalf;
  BodyState state;
  state.position.z() = -0.5 - kDepth * (1 - since * since);
  state.linear_velocity.z() = 2 * kDepth * since / kHalf;
  return state;
}

/// The water that a dip has left in the box, in substeps of a length [s].
double water_of_a_dip(double middle, double h) {
  const SimulationSpec spec = scene_of_open_box();
  std::vector<engine::MovingBody> bodies = support::moving_bodies(spec);
  engine::Motion& motion = bodies[0].motion;
  const long count = support::steps_in(0.4, h);
  for (long i = 1; i <= count; ++i) {
    const double time = static_cast<double>(i) * h;
    motion.state = dipping(time, middle);
    engine::let_water_run(bodies[0].body, dipping(time - h, middle), time, h, {}, motion);
  }
  return motion.carried_water->pockets[0].volume;
}

// Parts of an eighth of the step leave a few per cent of what sets in with the power 3/2 of time.
TEST(Flooding, ARimThatDipsForAPartOfAStepTakesTheWaterOfShortSteps) {
  for (const double middle : {0.2, 0.215, 0.235, 0.25, 0.27, 0.285}) {
    const double water = water_of_a_dip(middle, 1e-4);
    EXPECT_GT(water, 1e-3);
    EXPECT_NEAR(water_of_a_dip(middle, 0.1), water, tolerance(0.05 * water)) << middle;
    EXPECT_NEAR(water_of_a_dip(middle, 0.05), water, tolerance(0.05 * water)) << middle;
  }
}

/// The verticals in which a box has been searched that has turned by 1 rad in so many substeps.
std::vector<Vector3d> searched_in(int substeps) {
  const SimulationSpec spec = scene_of_open_box();
  std::vector<engine::MovingBody> bodies = support::moving_bodies(spec);
  engine::MovingBody& box = bodies[0];
  const auto tilted = [](double angle) {
    BodyState state;
    state.position.z() = -1;  // The rim is under water, and water gets to all pockets.
    state.orientation = Eigen::AngleAxisd(angle, Vector3d::UnitX());
    return state;
  };
  for (int i = 0; i < substeps; ++i)
    box.motion.carried_water =
        engine::divided_for(box.body, tilted(1.0 * i / substeps), tilted((i + 1.0) / substeps), 0,
                            box.motion.carried_water);
  return box.motion.carried_water->known_up_B;
}

TEST(PocketSearch, IsDoneInTheSameAttitudesInSubstepsOfAnyLength) {
  const std::vector<Vector3d> most = searched_in(1000);
  ASSERT_EQ(most.size(), 8);  // 1 rad has seven times 8°, and the start.
  for (const int substeps : {1, 3, 10, 77}) {
    const std::vector<Vector3d> found = searched_in(substeps);
    ASSERT_EQ(found.size(), most.size()) << substeps;
    for (std::size_t i = 0; i < most.size(); ++i)
      EXPECT_LT((found[i] - most[i]).norm(), tolerance(1e-9)) << substeps;
  }
}

}  // namespace

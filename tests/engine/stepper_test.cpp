#include "engine/step/stepper.h"

#include "tests/engine/island.h"
#include "tests/engine/prelude.h"

/// Which bodies are stepped together, and what the stepper hands from one step to the next.

namespace {

JointSpec pin(BodyId first, BodyId second) {
  return {.name = "pin", .type = JointSpec::Type::ball, .first = first, .second = second};
}

/// Four boxes in the air, of which the first two are pinned to each other.
SimulationSpec four_boxes() {
  std::vector<BodySpec> boxes;
  for (int i = 0; i < 4; ++i) {
    boxes.push_back(support::box_body("box", {1, 1, 1}, 500, {3.0 * i, 0, 5}));
    boxes.back().collision = CollisionShape::box;
  }
  SimulationSpec spec = support::dry_world(boxes, kStep);
  spec.joints = {pin(0, 1)};
  return spec;
}

TEST(Stepper, HasALimiterForEachSetOfJointedBodies) {
  support::IslandOfAll all(four_boxes());
  const engine::Stepper stepper(all.context, kStep);
  EXPECT_EQ(stepper.state().ranges.size(), 3u);
  SimulationSpec held = four_boxes();
  held.bodies[3].locked.fill(true);
  support::IslandOfAll some(held);
  const engine::Stepper fewer(some.context, kStep);
  EXPECT_EQ(fewer.state().ranges.size(), 2u);
  EXPECT_FALSE(fewer.fits(stepper.state()));
  EXPECT_TRUE(stepper.fits(stepper.state()));
}

TEST(Stepper, StepsBodiesTogetherOnlyWhereTheyAreJointedOrNear) {
  SimulationSpec spec = four_boxes();
  spec.bodies[3].initial.position.x() = 7.05;  // 5 cm from the third, towards which it moves
  spec.bodies[3].initial.linear_velocity.x() = -10;
  support::IslandOfAll all(spec);
  engine::Stepper stepper(all.context, kStep);
  stepper.advance(0);
  EXPECT_EQ(all.bodies[0].counts.free, 0);
  EXPECT_GT(all.bodies[0].counts.constrained, 0);
  const std::vector<engine::Pair> met = {{2, 3}};
  EXPECT_EQ(stepper.state().contacts.touching, met);
  EXPECT_LT(all.bodies[2].motion.state.linear_velocity.x(), -1);  // It was pushed.
}

TEST(Stepper, GoesOnFromAStateToTheSameBits) {
  SimulationSpec spec = four_boxes();
  spec.ground = engine::PlaneGround{0};
  for (BodySpec& box : spec.bodies) box.initial.position.z() = 0.51;
  support::IslandOfAll first(spec), second(spec);
  engine::Stepper whole(first.context, kStep), rest(second.context, kStep);
  for (int i = 0; i < 10; ++i) whole.advance(i * kStep);
  for (std::size_t i = 0; i < 4; ++i) second.bodies[i].motion = first.bodies[i].motion;
  rest.restore(whole.state());
  for (int i = 10; i < 20; ++i) {
    whole.advance(i * kStep);
    rest.advance(i * kStep);
  }
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(first.bodies[i].motion.state, second.bodies[i].motion.state) << i;
}

TEST(Stepper, ForgetsTheEnergiesOfABodyThatWasSet) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 0.3});
  support::IslandOfAll all(spec);
  engine::Stepper stepper(all.context, kStep);
  // Only a substep that is not smooth is judged: the box crosses the surface.
  all.bodies[0].motion.state.position.z() = 0.505;
  all.bodies[0].motion.state.linear_velocity.z() = -3;
  stepper.advance(0);
  EXPECT_GT(stepper.state().ranges[0].highest, 0);
  stepper.forget(0);
  EXPECT_EQ(stepper.state().ranges[0].highest, engine::EnergyRange().highest);
}

}  // namespace

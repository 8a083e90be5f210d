#include "engine/contacts/broad_phase.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/motion/free_motion.h"
#include "tests/support/random_pose.h"

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;
using engine::BodyId;
using engine::kWorld;
using engine::Pair;

TEST(Groups, AreWhatPairsHoldTogether) {
  using Groups = std::vector<std::vector<BodyId>>;
  const std::vector<BodyId> bodies = {0, 1, 2, 4, 5, 7, 8};
  EXPECT_EQ(engine::connected_components(bodies, {}), Groups{});
  EXPECT_EQ(engine::connected_components(bodies, {{1, 7}, {4, 5}, {2, 7}}),
            (Groups{{1, 2, 7}, {4, 5}}));
}

TEST(Groups, AreNotHeldTogetherByWhatIsNoneOfTheBodies) {
  using Groups = std::vector<std::vector<BodyId>>;
  // Body 3 cannot move.
  EXPECT_EQ(engine::connected_components({0, 1, 2, 4}, {{kWorld, 0}, {kWorld, 1}, {2, 3}, {3, 4}}),
            (Groups{{0}, {1}, {2}, {4}}));
}

TEST(OverlappingBoxes, AreThoseOfAllPairs) {
  support::Random random(3);
  std::vector<AlignedBox3d> boxes = {AlignedBox3d()};
  for (int i = 0; i < 200; ++i) {
    const Vector3d corner = random.vector(4);
    boxes.emplace_back(corner, corner + Vector3d(random.vector(1).cwiseAbs()));
  }
  const double far = std::numeric_limits<double>::infinity();
  boxes.emplace_back(Vector3d(-far, -far, -far), Vector3d(far, far, -3));
  std::vector<std::pair<std::size_t, std::size_t>> expected;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (!boxes[i].isEmpty() && boxes[i].intersects(boxes[j])) expected.emplace_back(i, j);
  ASSERT_GT(expected.size(), 50U);
  EXPECT_EQ(engine::overlapping(boxes), expected);
}

TEST(OverlappingBoxes, AreTheSameWhereTheyAreFollowed) {
  support::Random random(4);
  std::vector<AlignedBox3d> boxes;
  for (int i = 0; i < 100; ++i) {
    const Vector3d corner = random.vector(3);
    boxes.emplace_back(corner, corner + Vector3d(random.vector(1).cwiseAbs()));
  }
  const double far = std::numeric_limits<double>::infinity();
  boxes.emplace_back(Vector3d(-far, -far, -far), Vector3d(far, far, -2));
  const AlignedBox3d first = boxes[0];
  engine::BroadPhase overlaps;
  for (int time = 0; time < 60; ++time) {
    for (std::size_t i = 1; i + 1 < boxes.size(); ++i) boxes[i].translate(random.vector(0.03));
    boxes[0] = time % 7 < 3 ? AlignedBox3d() : first;  // One that comes and goes.
    ASSERT_EQ(overlaps.find(boxes), engine::overlapping(boxes)) << time;
  }
}

TEST(SweptBox, HoldsTheShapeThroughoutTheStep) {
  support::Random random(5);
  for (int i = 0; i < 50; ++i) {
    const AlignedBox3d shape(Vector3d(-0.2, -1, -0.5), Vector3d(0.4, 0.3, 0.8));
    hydro::BodyState state = random.state(1, 3);
    const double step = 0.1, gravity = 9.81;
    const AlignedBox3d box = engine::swept_box(shape, state, gravity, step);
    for (const double t : {0.0, 0.03, 0.1}) {
      hydro::BodyState then = state;
      then.orientation = engine::exponential(t * state.angular_velocity) * state.orientation;
      then.position += t * state.linear_velocity - gravity * t * t / 2 * Vector3d::UnitZ();
      for (int corner = 0; corner < 8; ++corner) {
        const Vector3d point_B = shape.corner(static_cast<AlignedBox3d::CornerType>(corner));
        const Vector3d point = then.position + then.orientation * point_B;
        EXPECT_TRUE(box.contains(point)) << point.transpose();
      }
    }
  }
  EXPECT_TRUE(engine::swept_box({}, {}, 9.81, 0.1).isEmpty());
}

}  // namespace

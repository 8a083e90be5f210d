#include "engine/contacts/contacts.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/engine/prelude.h"

namespace {

using engine::ContactPoint;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

std::vector<ContactPoint> grid(int count) {
  std::vector<ContactPoint> points;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      points.push_back({.position_W = Vector3d(i, j, 0), .depth = 0.01});
    }
  }
  return points;
}

TEST(RepresentativeContacts, OfAFaceIncludeItsCorners) {
  const auto kept = engine::representative(grid(10), 4);
  EXPECT_THAT(kept, UnorderedElementsAre(0, 9, 90, 99));
}

TEST(RepresentativeContacts, IncludeTheDeepest) {
  std::vector<ContactPoint> points = grid(10);
  points[47].depth = 0.02;
  EXPECT_EQ(engine::representative(points, 4).front(), 47U);
}

TEST(RepresentativeContacts, IncludeEveryDirection) {
  std::vector<ContactPoint> points = grid(10);
  points.push_back({.position_W = {5, 5, 0}, .normal_W = Vector3d::UnitX(), .depth = 0.001});
  EXPECT_THAT(engine::representative(points, 4), Contains(100U));
}

TEST(RepresentativeContacts, TakeCoincidentPointsOnce) {
  const std::vector<ContactPoint> points(5, ContactPoint{.depth = 0.01});
  EXPECT_THAT(engine::representative(points, 4), ElementsAre(0));
  EXPECT_THAT(engine::representative({}, 4), IsEmpty());
}

TEST(RepresentativeContacts, OfFewAreAll) {
  EXPECT_THAT(engine::representative(grid(2), 8), UnorderedElementsAre(0, 1, 2, 3));
}

/// A sphere's overlap with ground that leans by `angle`, seen from above [rad].
ContactPoint below_sphere(double angle, double depth) {
  return {.normal_W = {std::sin(angle), 0, std::cos(angle)}, .depth = depth};
}

TEST(ContactsOfASphere, AreNotTheEdgesBesideTheOneItLiesOn) {
  // Radius 1 sunk in by 1 cm; the edge lies 0.1 from the lowest point.
  const double to_edge = std::hypot(0.99, 0.1);
  const ContactPoint edge = below_sphere(std::atan2(0.1, 0.99), 1 - to_edge);
  EXPECT_THAT(engine::supporting_a_sphere({edge, below_sphere(0, 0.01)}), SizeIs(1));
  EXPECT_EQ(engine::supporting_a_sphere({edge, below_sphere(0, 0.01)})[0].depth, 0.01);
}

TEST(ContactsOfASphere, AreBothSidesOfAValley) {
  EXPECT_THAT(engine::supporting_a_sphere({below_sphere(0.1, 0.01), below_sphere(-0.1, 0.01)}),
              SizeIs(2));
  EXPECT_THAT(engine::supporting_a_sphere({below_sphere(1, 0.01), below_sphere(-1, 0.002)}),
              SizeIs(2));
}

constexpr double kNoBoxes = std::numeric_limits<double>::infinity();

// A face overlaps the ground by 1 mm; its side face is reported as if to be pushed out sideways.
std::vector<ContactPoint> face_and_side(double side_depth, double height) {
  return {{.position_W = {0, 0, 0}, .normal_W = Vector3d::UnitZ(), .depth = 0.001},
          {.position_W = {1, 0, height}, .normal_W = Vector3d::UnitX(), .depth = side_depth}};
}

TEST(ContactArtefacts, AreDeepPointsInTheOverlapOfAShallowOne) {
  EXPECT_THAT(engine::without_artefacts(face_and_side(0.9, 0.0005), 0, kNoBoxes), SizeIs(1));
}

TEST(ContactArtefacts, AreNotPointsElsewhere) {
  EXPECT_THAT(engine::without_artefacts(face_and_side(0.9, 0.1), 0, kNoBoxes), SizeIs(2));
}

TEST(ContactArtefacts, AreNotPointsOfLikeDepth) {
  EXPECT_THAT(engine::without_artefacts(face_and_side(0.004, 0.0005), 0, kNoBoxes), SizeIs(2));
}

TEST(ContactArtefacts, AreNotPointsWithinReachOfTheMotion) {
  EXPECT_THAT(engine::without_artefacts(face_and_side(0.9, 0.0005), 1, kNoBoxes), SizeIs(2));
}

TEST(ContactArtefacts, AreDeeperThanTheBoxesOverlap) {
  const std::vector<ContactPoint> points = face_and_side(0.9, 0.1);
  EXPECT_THAT(engine::without_artefacts(points, 0, 0.46), SizeIs(2));
  const auto kept = engine::without_artefacts(points, 0, 0.44);
  ASSERT_THAT(kept, SizeIs(1));
  EXPECT_EQ(kept[0].depth, 0.001);
  EXPECT_THAT(engine::without_artefacts(points, 1, 0.44), SizeIs(2));
}

TEST(ContactArtefacts, ArePointsThatOnlyTouch) {
  EXPECT_THAT(engine::without_artefacts({ContactPoint{.depth = 0}}, 1, kNoBoxes), IsEmpty());
}

constexpr engine::ContactLaw kLaw{
    .mass = 700, .points = 4, .rest = 1e-3, .fall = 0.25, .gravity = support::kGravity};

TEST(ContactRow, LetsABodySettleAtItsDepthOfRestWhateverTheStep) {
  for (const double step : {1e-4, 1e-3, 1.0 / 60, 0.1}) {
    double depth = 0;
    for (double time = 0; time < 40 * std::max(step, 0.01); time += step) {
      const double speed = engine::contact_row(depth, kLaw, step).speed;
      EXPECT_LE(speed, 0);
      depth -= step * speed;
      EXPECT_LE(depth, kLaw.rest * (1 + 1e-12)) << step;
    }
    EXPECT_NEAR(depth, kLaw.rest, tolerance(1e-8)) << step;
  }
}

TEST(ContactRow, TakesOverlapAwayWithinSomeTimeAndLeavesAQuarterOfAFallThroughIt) {
  for (const double step : {1e-4, 1e-3, 1.0 / 60}) {
    const double gravity = kLaw.fall * kLaw.gravity;
    double depth = 0.3;
    for (double time = 0; time < 2; time += step) {
      const double speed = engine::contact_row(depth, kLaw, step).speed;
      EXPECT_LE(speed * speed / 2, gravity * (depth - kLaw.rest) / 4 * (1 + 1e-12));
      depth -= step * speed;
    }
    EXPECT_NEAR(depth, kLaw.rest, tolerance(1e-9)) << step;
  }
  EXPECT_GT(engine::contact_row(0.5, {.mass = 1, .rest = 1e-3}, 0.01).speed, 0)
      << "without weight an overlap is left, too";
}

}  // namespace

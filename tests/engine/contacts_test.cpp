#include "engine/contacts/contacts.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/engine/prelude.h"

namespace {

using engine::ContactPoint;
using engine::ContactStiffness;
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

TEST(PartingSpeed, IsHalfOfThatOfAFallThroughTheOverlap) {
  EXPECT_NEAR(engine::parting_speed(0.5, 0.25, 9.81), std::sqrt(2 * 0.25 * 9.81 * 0.5) / 2,
              tolerance(1e-12));
  EXPECT_GT(engine::parting_speed(0.5, 1, 0), 0) << "without weight an overlap is left, too";
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

// The spring and damper that ERP and CFM stand for, found back from them.
TEST(ContactStiffnesses, AreThoseOfACriticallyDampedSpringSharedByThePoints) {
  const double mass = 700;
  const double step = 0.002;
  const ContactStiffness stiffness = engine::contact_stiffness(mass, 4, step);
  const double spring = 4 * stiffness.erp / (step * stiffness.cfm);
  const double damper = 4 * (1 - stiffness.erp) / stiffness.cfm;
  EXPECT_NEAR(damper * damper / (4 * spring * mass), 1, tolerance(1e-12));
  EXPECT_NEAR(mass / spring, 1e-4, tolerance(1e-15));  // τ² = (0.01 s)²
}

TEST(ContactStiffnesses, SoftenWithLongSteps) {
  const double step = 0.1;
  const ContactStiffness stiffness = engine::contact_stiffness(1, 1, step);
  EXPECT_NEAR(stiffness.erp, 1.0 / 3, tolerance(1e-15));
  EXPECT_NEAR(stiffness.erp / (step * stiffness.cfm), 1 / (step * step), tolerance(1e-10));
}

TEST(ContactWeights, AreThoseOfTheEndInLongStepsAndOfTheMiddleInShortOnes) {
  const engine::ContactWeights coarse = engine::halfway_weights(1, 0.02, 3);
  EXPECT_EQ(coarse.spring, 1);
  EXPECT_EQ(coarse.damper, 1);
  const engine::ContactWeights fine = engine::halfway_weights(1, 1e-7, 3);
  EXPECT_NEAR(fine.spring, 0, tolerance(1e-4));
  EXPECT_NEAR(fine.damper, 0.5, tolerance(1e-4));
  double last = 0.5;
  for (double step = 1e-7; step < 0.01; step *= 1.1) {
    const double weight = engine::halfway_weights(1, step, 3).damper;
    EXPECT_GE(weight, last) << step;
    EXPECT_LE(weight, 1) << step;
    last = weight;
  }
}

/// Depth of a mass that runs at 1 m/s into a contact, a time later [m], with half a drift, a update
/// and half a drift in each step.
double depth_after(double time, int steps, double mass, double resisting) {
  const double step = time / steps;
  double depth = 0, speed = -1;  // positive: parting
  for (int i = 0; i < steps; ++i) {
    depth -= step / 2 * speed;
    const auto contact = engine::contact_stiffness(
        mass, 1, step, engine::halfway_weights(1, step, mass / resisting));
    // v⁺ + CFM f = ERP d/h + speed, f = µ (v⁺ − v⁻)/h
    const double target = contact.erp * depth / step - contact.speed * speed;
    const double ratio = contact.cfm * resisting / step;
    speed = (target + ratio * speed) / (1 + ratio);
    depth -= step / 2 * speed;
  }
  return depth;
}

TEST(ContactWeights, MakeTheMotionOfASpringAndDamperOfSecondOrder) {
  const double tau = 0.01, time = 0.004;
  // µ d'' + 2 m/τ d' + m/τ² d = 0, overdamped for µ < m: two decays.
  for (const double lightness : {1.5, 6.0}) {
    const double rate = lightness / tau;
    const double root = std::sqrt(rate * rate - lightness / (tau * tau));
    const double exact =
        (std::exp((root - rate) * time) - std::exp(-(root + rate) * time)) / (2 * root);
    const double coarse = depth_after(time, 20, 600, 600 / lightness) - exact;
    const double fine = depth_after(time, 40, 600, 600 / lightness) - exact;
    EXPECT_LT(std::abs(fine), 2e-3 * exact);
    EXPECT_GT(std::log2(coarse / fine), 1.9);
  }
}

TEST(ContactWeights, LetNothingBounceInAnyStep) {
  for (const double step : {1e-4, 1e-3, 3e-3, 9.9e-3, 0.02, 0.1})
    for (const double lightness : {1.0, 2.0, 6.0, 40.0}) {
      double depth = 0, speed = -1;
      const auto contact =
          engine::contact_stiffness(1, 1, step, engine::halfway_weights(1, step, lightness));
      for (int i = 0; i < 100 && depth >= 0; ++i) {
        depth -= step / 2 * speed;
        const double target = contact.erp * depth / step - contact.speed * speed;
        const double ratio = contact.cfm / lightness / step;
        speed = std::max(speed, (target + ratio * speed) / (1 + ratio));
        depth -= step / 2 * speed;
      }
      // Critical damping leaves what overlap is left at the slower of two decays.
      EXPECT_LT(speed, 0.2) << step << ' ' << lightness;
    }
}

}  // namespace

#include "hydro/loads/clip.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::Panel;
using hydro::PanelPart;

Panel random_panel(support::Random& random) {
  return {random.vector(2), random.vector(2), random.vector(2)};
}

/// Area of the positive side, and the integral of the function over it.
struct Positive {
  Vector3d area = Vector3d::Zero();
  double integral = 0;
};
Positive positive_side(const Panel& panel, const Vector3d& value) {
  Positive sum;
  for (const PanelPart& part : hydro::positive_part(panel, value)) {
    sum.area += hydro::area_vector(part.panel);
    sum.integral += hydro::area_vector(part.panel).norm() * part.value.mean();
  }
  return sum;
}

// A cut moves a vertex by an ulp of the panel's size, 2 m; the panels have some m^2.
constexpr double kCut = 2e-14;

TEST(PositivePart, IsTheWholePanelWhereTheFunctionIsPositive) {
  support::Random random(1);
  const Panel panel = random_panel(random);
  const hydro::PanelParts parts = hydro::positive_part(panel, {0, 1, 2});
  ASSERT_EQ(parts.count, 1);
  EXPECT_EQ(parts.part[0].panel, panel);
  EXPECT_EQ(parts.part[0].value, Vector3d(0, 1, 2));
}

TEST(PositivePart, IsEmptyWhereTheFunctionIsNotPositive) {
  support::Random random(2);
  EXPECT_EQ(hydro::positive_part(random_panel(random), {0, -1, -2}).count, 0);
  EXPECT_EQ(hydro::positive_part(random_panel(random), {0, 0, 0}).count, 0);
}

TEST(PositivePart, AndItsComplementMakeUpThePanel) {
  support::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Panel panel = random_panel(random);
    const Vector3d value = random.vector(1);
    const Positive above = positive_side(panel, value);
    const Positive below = positive_side(panel, -value);
    const Vector3d area = hydro::area_vector(panel);
    EXPECT_LT((above.area + below.area - area).norm(), support::tolerance(kCut));
    EXPECT_NEAR(above.integral - below.integral, area.norm() * value.mean(),
                support::tolerance(kCut));
  }
}

TEST(PositivePart, HasTheAreaThatSimilarTrianglesGive) {
  support::Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Panel panel = random_panel(random);
    const double p = random.uniform(0.01, 1);
    const double q = random.uniform(0.01, 1);
    const double r = random.uniform(0.01, 1);
    // One positive corner p between −q and −r: its share is the product of the cut edges' shares.
    const double share = p / (p + q) * (p / (p + r));
    for (int turn = 0; turn < 3; ++turn) {
      Vector3d value;
      value[turn] = p;
      value[(turn + 1) % 3] = -q;
      value[(turn + 2) % 3] = -r;
      const double area = hydro::area_vector(panel).norm();
      EXPECT_NEAR(positive_side(panel, value).area.norm(), share * area, support::tolerance(kCut));
      EXPECT_NEAR(positive_side(panel, -value).area.norm(), (1 - share) * area,
                  support::tolerance(kCut));
    }
  }
}

TEST(PositivePart, CutsASharedEdgeAtTheSamePointToTheLastBit) {
  support::Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Vector3d a = random.vector(3), b = random.vector(3);
    const Vector3d left = random.vector(3), right = random.vector(3);
    const double fa = random.uniform(0.1, 1), fb = random.uniform(-1, -0.1);
    const auto cut = [&](const Panel& panel, const Vector3d& value) {
      for (const PanelPart& part : hydro::positive_part(panel, value))
        for (int k = 0; k < 3; ++k) {
          const Vector3d& p = part.panel[k];
          const double off = (p - a).cross(b - a).norm() / (b - a).norm();
          if (part.value[k] == 0 && off < 1e-12) return p;
        }
      ADD_FAILURE() << "no cut on the edge";
      return Vector3d(Vector3d::Zero());
    };
    const Vector3d from_left = cut({a, b, left}, {fa, fb, -0.5});
    EXPECT_EQ(from_left, cut({b, a, right}, {fb, fa, 0.5}));
    EXPECT_EQ(from_left, cut({right, b, a}, {-0.2, fb, fa}));
  }
}

TEST(PositivePart, KeepsTheOrientation) {
  support::Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Panel panel = random_panel(random);
    const Vector3d normal = hydro::area_vector(panel).normalized();
    for (const PanelPart& part : hydro::positive_part(panel, random.vector(1)))
      EXPECT_GE(hydro::area_vector(part.panel).dot(normal), -1e-15);
  }
}

TEST(PositivePart, OfASliverIsFinite) {
  const Panel sliver = {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(1, 0, 0)};
  for (const PanelPart& part : hydro::positive_part(sliver, {1e-300, -1e-300, -1}))
    for (const Vector3d& p : part.panel) EXPECT_TRUE(p.allFinite());
}

}  // namespace

#include "hydro/added_mass/attitude_grid.h"

#include <gtest/gtest.h>

#include "tests/support/random_pose.h"

namespace hydro {
namespace {

using Eigen::Vector3d;
using support::Random;

TEST(AttitudeGrid, NodesHaveTheirOwnDirections) {
  const AttitudeGrid grid(12);
  int nodes = 0;
  for (int i = -12; i <= 12; ++i) {
    for (int j = -12; j <= 12; ++j) {
      for (const int below : {0, 1}) {
        const int rest = 12 - std::abs(i) - std::abs(j);
        if (rest < 0 || (rest == 0 && below == 1)) continue;
        const int node = 2 * ((i + 12) * 25 + j + 12) + below;
        const Vector3d up = grid.direction(node);
        EXPECT_NEAR(up.norm(), 1, 1e-14);
        double own = 0;
        for (const auto& corner : grid.around(up))
          if (corner.node == node) own += corner.weight;
        EXPECT_NEAR(own, 1, 1e-12) << node;
        ++nodes;
      }
    }
  }
  EXPECT_EQ(nodes, 4 * 12 * 12 + 2);
}

TEST(AttitudeGrid, AxesAreNodes) {
  const AttitudeGrid grid(12);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      int asked = 0;
      for (const auto& corner : grid.around(sign * Vector3d::Unit(axis))) {
        if (corner.weight == 0) continue;
        ++asked;
        EXPECT_NEAR(grid.direction(corner.node).dot(sign * Vector3d::Unit(axis)), 1, 1e-15);
      }
      EXPECT_EQ(asked, 1);
    }
  }
}

// Nodes around a direction are within one step of it, 7.5° along the edges and, as asin(1/√3) is
// 0.6155 where 1/3 of 90° is 0.5236, up to 0.6155/0.5236 · √2 times that inside: 12.5°.
TEST(AttitudeGrid, DirectionsLieBetweenNearNodes) {
  const AttitudeGrid grid(12);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d up = random.vector(1).normalized();
    double sum = 0;
    for (const auto& corner : grid.around(up)) {
      EXPECT_GE(corner.weight, 0);
      sum += corner.weight;
      EXPECT_LT(corner.node, grid.bound());
      EXPECT_GE(corner.node, 0);
      if (corner.weight == 0) continue;
      EXPECT_GT(grid.direction(corner.node).dot(up), std::cos(12.5 * M_PI / 180));
    }
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

}  // namespace
}  // namespace hydro

#include "hydro/statics/trust_region.h"

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace {

/// A gradient of round-off at the top of a hill that is as steep in all directions, as an upright
/// ellipsoid of revolution has it.
TEST(TrustRegion, LeavesATopThatIsAsSteepAllAround) {
  const double radius = 0.5;
  for (const Eigen::Vector2d& noise :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(0, 1e-18), Eigen::Vector2d(-1e-18, 1e-17)}) {
    const Eigen::Vector2d step =
        hydro::trust_region_step(noise, -3 * Eigen::Matrix2d::Identity(), radius, 1e-13);
    EXPECT_NEAR(step.norm(), radius, support::tolerance(1e-14));
  }
}

}  // namespace

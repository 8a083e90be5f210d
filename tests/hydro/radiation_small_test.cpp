#include <gtest/gtest.h>

#include <cmath>

#include "hydro/mesh/primitives.h"
#include "hydro/radiation/radiation_solve.h"

/// Radiation and diffraction on few patches, so that sanitizers see the solution, too.

namespace {

constexpr double kGravity = 9.80665;

TEST(SmallRadiationSolve, OfFewPatchesIsNearTheTable) {
  const hydro::RadiationSolution solution =
      hydro::solve_radiation(hydro::make_icosphere(1, 2), {}, {.gravity = kGravity},
                             {.frequencies = {std::sqrt(0.5 * kGravity), std::sqrt(3.0 * kGravity)},
                              .headings = 4,
                              .patches = 40});
  const hydro::RadiationData& data = solution.data;
  EXPECT_NEAR(data.added_mass[0](2, 2) / data.volume, 0.5862, 0.02);
  EXPECT_NEAR(data.added_mass[0](0, 0) / data.volume, 0.6436, 0.02);
  EXPECT_LT(solution.mismatch, 0.05);
}

TEST(RadiationSolve, RefusesADryBodyAndShallowWater) {
  const TriMesh mesh = hydro::make_icosphere(1, 1);
  EXPECT_THROW(hydro::solve_radiation(mesh, {.height = 2}, {}), std::invalid_argument);
  EXPECT_THROW(hydro::solve_radiation(mesh, {}, {.depth = 10}), std::invalid_argument);
}

TEST(RadiationFrequencies, SpanTheWavesThatABodyMeets) {
  const std::vector<double> omega =
      hydro::radiation_frequencies(hydro::make_box({20, 2, 1}, 1), {}, {.gravity = kGravity});
  EXPECT_EQ(omega.size(), 16u);
  EXPECT_NEAR(omega.front() * omega.front() / kGravity * 10, 0.05, 1e-12);
  EXPECT_NEAR(omega.back() * omega.back() / kGravity * 1, 5, 1e-12);
}

}  // namespace

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hydro/mesh/mirror_symmetry.h"
#include "hydro/mesh/primitives.h"
#include "hydro/radiation/radiation_solve.h"

/// Radiation and diffraction on few patches, so that sanitizers see the solution, too.

namespace {

constexpr double kGravity = 9.80665;

TEST(MirrorSymmetry, IsThatOfTheVertices) {
  hydro::TriMesh mesh = hydro::make_box({3, 2, 1}, 3);
  for (const int axis : {0, 1, 2}) EXPECT_TRUE(hydro::is_mirror_symmetric(mesh, axis, 1e-9));
  mesh.vertices(1, 4) += 1e-3;
  for (const int axis : {0, 1, 2}) EXPECT_FALSE(hydro::is_mirror_symmetric(mesh, axis, 1e-6));
  mesh.vertices.row(0).array() += 1;
  EXPECT_FALSE(hydro::is_mirror_symmetric(mesh, 0, 1e-2));
  EXPECT_TRUE(hydro::is_mirror_symmetric(mesh, 1, 1e-2));
}

TEST(SmallRadiationSolve, OfABoxHasNoCouplingsThatItsSymmetryForbids) {
  const hydro::RadiationData data =
      hydro::solve_radiation(hydro::make_box({3, 2, 1}, 1), {}, {.gravity = kGravity},
                             {.frequencies = {2}, .headings = 8, .patches = 20})
          .data;
  EXPECT_EQ(data.added_mass[0](0, 2), 0);
  EXPECT_EQ(data.damping[0](0, 1), 0);
  EXPECT_NE(data.added_mass[0](0, 4), 0);
  EXPECT_EQ(data.diffraction[0](1, 0), 0.0);  // Waves along x do not sway it,
  EXPECT_EQ(data.diffraction[0](0, 2), 0.0);  // nor do those along y surge it.
  EXPECT_EQ(data.diffraction[0](2, 1), data.diffraction[0](2, 7));
}

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

TEST(SmallRadiationSolve, ItsDampingIsThatOfTheWavesFarAwayOnShallowWater) {
  // The bottom is a fifth of the draught below the sphere.
  const hydro::RadiationSolution solution =
      hydro::solve_radiation(hydro::make_icosphere(1, 2), {}, {.gravity = kGravity, .depth = 1.2},
                             {.frequencies = {1.5, 3.5}, .headings = 8, .patches = 40});
  EXPECT_LT(solution.mismatch, 0.02);
  const hydro::RadiationData& data = solution.data;
  EXPECT_GT(data.infinite_added_mass(2, 2), 0.6 * data.volume);  // 0.5 in deep water
  EXPECT_GT(data.infinite_added_mass(0, 0), 0.28 * data.volume);
}

TEST(SmallRadiationSolve, OfWaterManyDraughtsDeepIsThatOfDeepWater) {
  const auto solved = [](double depth) {
    return hydro::solve_radiation(hydro::make_box({3, 2, 1}, 1), {},
                                  {.gravity = kGravity, .depth = depth},
                                  {.frequencies = {2, 4}, .headings = 4, .patches = 20})
        .data;
  };
  const hydro::RadiationData deep = solved(std::numeric_limits<double>::infinity());
  const hydro::RadiationData finite = solved(100);
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_LT((finite.added_mass[f] - deep.added_mass[f]).norm(), 1e-3 * deep.added_mass[f].norm());
    EXPECT_LT((finite.damping[f] - deep.damping[f]).norm(), 1e-4 * deep.added_mass[f].norm());
    EXPECT_LT((finite.diffraction[f] - deep.diffraction[f]).norm(),
              1e-3 * deep.diffraction[f].norm());
  }
  EXPECT_LT((finite.infinite_added_mass - deep.infinite_added_mass).norm(),
            1e-3 * deep.infinite_added_mass.norm());
}

TEST(RadiationSolve, RefusesADryBodyAndOneThatReachesTheBottom) {
  const hydro::TriMesh mesh = hydro::make_icosphere(1, 1);
  EXPECT_THROW(hydro::solve_radiation(mesh, {.height = 2}, {}), std::invalid_argument);
  EXPECT_THROW(hydro::solve_radiation(mesh, {}, {.depth = 1}), std::invalid_argument);
}

TEST(RadiationFrequencies, SpanTheWavesThatABodyMeets) {
  const std::vector<double> omega =
      hydro::radiation_frequencies(hydro::make_box({20, 2, 1}, 1), {}, {.gravity = kGravity});
  EXPECT_EQ(omega.size(), 16u);
  EXPECT_NEAR(omega.front() * omega.front() / kGravity * 10, 0.05, 1e-12);
  // No shorter waves than 250 patches of 62 m2 resolve.
  EXPECT_NEAR(omega.back() * omega.back() / kGravity, 1.6 / std::sqrt(62.0 / 250), 1e-12);
  const std::vector<double> compact =
      hydro::radiation_frequencies(hydro::make_box({4, 2, 1}, 1), {}, {.gravity = kGravity});
  EXPECT_NEAR(compact.back() * compact.back() / kGravity * 1, 5, 1e-12);
  const std::vector<double> spar = hydro::radiation_frequencies(
      hydro::make_box({2, 2, 12}, 1), {.height = -4}, {.gravity = kGravity});
  EXPECT_NEAR(spar.front() * spar.front() / kGravity * 10, 0.05, 1e-12);
  const std::vector<double> shallow = hydro::radiation_frequencies(
      hydro::make_box({20, 2, 1}, 1), {}, {.gravity = kGravity, .depth = 2});
  EXPECT_NEAR(shallow.front() * shallow.front() / kGravity, 0.005 * std::tanh(0.01), 1e-15);
}

}  // namespace

#include "hydro/statics/intact_stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hydro/interior/interior.h"
#include "hydro/interior/lids.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/hollows.h"

namespace {

using hydro::IntactStability;
using hydro::Tank;
using hydro::TriMesh;

/// The open box with its centre of mass at a height above its bottom [m], and its inside.
struct HollowBox {
  explicit HollowBox(double kg)
      : mesh_B(hydro::translated(support::open_box(), {0, 0, -kg})),
        interior(hydro::make_interior(mesh_B, Eigen::Vector3d::UnitZ())),
        outside_B(hydro::with_lids(mesh_B, interior->division)) {}

  std::vector<Tank> with_water(double volume) const {
    return {{.hull = interior->pockets[0], .volume = volume}};
  }

  TriMesh mesh_B;
  std::shared_ptr<const hydro::Interior> interior;
  TriMesh outside_B;
};

TEST(Tanks, AWaterSurfaceInsideTakesFromTheMetacentricHeight) {
  const HollowBox box(0.5);
  const double displaced = 0.742, inner = 1.9 * std::pow(0.9, 3) / 12;
  const hydro::Flotation afloat = hydro::afloat(
      box.outside_B, displaced, Eigen::Quaterniond::Identity(), box.with_water(0.342));
  EXPECT_NEAR(afloat.draught, 0.371, 1e-12);
  const double kg = (400 * 0.5 + 342 * 0.15) / 742;
  const double solid = displaced / 4 + 2.0 / 12 / displaced - kg;
  EXPECT_NEAR(solid, 0.071439, 1e-6);
  EXPECT_NEAR(inner / displaced, 0.155559, 1e-6);
  EXPECT_NEAR(afloat.effective_metacentric_heights()(0, 0), solid - inner / displaced, 1e-9);
  EXPECT_EQ(hydro::stability(box.outside_B, afloat), hydro::Stability::unstable);
}

TEST(Tanks, ABoxWithWaterLollsToWhereItsLeverVanishes) {
  const double kg = 0.35, displaced = 0.742;
  const HollowBox box(kg);
  const auto tanks = box.with_water(0.342);
  const hydro::Flotation rest =
      hydro::equilibrium(box.outside_B, displaced, Eigen::Quaterniond::Identity(), tanks);
  // Both surfaces are wall-sided up to this angle: GZ = sin φ (GM + ½ (BM − i/V) tan² φ).
  const double bm = 2.0 / 12 / displaced, loss = 1.9 * std::pow(0.9, 3) / 12 / displaced;
  const double gm = displaced / 4 + bm - loss - (400 * kg + 342 * 0.15) / 742;
  const double loll = std::atan(std::sqrt(-2 * gm / (bm - loss)));
  ASSERT_LT(0.45 * std::tan(loll), 0.2);
  EXPECT_GT(loll, 0.25);
  // The moment arm vanishes to 1e-15 m and changes by 2 |GM| a radian there.
  EXPECT_NEAR(std::abs(hydro::euler_angles(rest.orientation)[0]), loll, 1e-11);
  EXPECT_LT(rest.gradient().norm(), 1e-12);
  EXPECT_EQ(hydro::stability(box.outside_B, rest), hydro::Stability::stable);
}

TEST(IntactStability, AreasOfAWallSidedBoxHaveTheirClosedForm) {
  // 20 × 10 × 8 m at a draught of 4 m: wall-sided up to 38.6°, where its deck meets the water.
  const double beam = 10, draught = 4, kg = 3;
  const TriMesh box = hydro::translated(hydro::make_box({20, beam, 8}, 2), {0, 0, 4 - kg});
  const std::vector<Tank> tanks;
  const double volume = 20 * beam * draught;
  const double bm = beam * beam / (12 * draught), gm = draught / 2 + bm - kg;
  const auto area = [&](double heel) {  // ∫ sin φ (GM + ½ BM tan² φ) dφ
    return (1 - std::cos(heel)) * gm + bm / 2 * (1 / std::cos(heel) + std::cos(heel) - 2);
  };
  // A point 3 m above the water at the side floods at atan(3/5), about 31°.
  const std::vector<Eigen::Vector3d> points = {{0, -5, draught + 3 - kg}, {0, 0, 5}};
  const IntactStability result = hydro::intact_stability(
      {.mesh = box, .volume = volume, .tanks = tanks, .flooding_points_B = points}, gm);
  const double flooding = std::atan(0.6);
  ASSERT_TRUE(result.downflooding);
  EXPECT_NEAR(*result.downflooding, flooding, 2e-6);
  EXPECT_NEAR(result.criteria[0].value, area(M_PI / 6), 1e-4);
  EXPECT_NEAR(result.criteria[1].value, area(flooding), 1e-4);
  EXPECT_NEAR(result.criteria[2].value, area(flooding) - area(M_PI / 6), 1e-4);
  EXPECT_EQ(result.criteria[5].value, gm);
  EXPECT_TRUE(result.criteria[0].met());
  EXPECT_EQ(result.criteria[2].met(), result.criteria[2].value >= 0.03);
}

TEST(IntactStability, WithoutFloodingPointsNothingComesIn) {
  const TriMesh box = hydro::make_box({4, 2, 1}, 1);
  const std::vector<Tank> tanks;
  const std::vector<Eigen::Vector3d> none;
  const IntactStability result = hydro::intact_stability(
      {.mesh = box, .volume = 4, .tanks = tanks, .flooding_points_B = none}, 0.4);
  EXPECT_FALSE(result.downflooding);
}

}  // namespace

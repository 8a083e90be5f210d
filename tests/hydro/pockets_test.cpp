#include "hydro/interior/pockets.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "hydro/interior/interior.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/hollows.h"
#include "tests/support/stored_mesh.h"

namespace {

using hydro::find_pockets;
using hydro::Pockets;

const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

/// The vertical in the frame of a body that is turned by an angle about its y axis [rad].
Eigen::Vector3d tilted(double angle) { return {-std::sin(angle), 0, std::cos(angle)}; }

double degrees(double d) { return d * std::numbers::pi / 180; }

TEST(Pockets, AnOpenBoxHoldsItsInnerVolumeUpToItsRim) {
  const Pockets found = find_pockets(support::open_box(), kUp);
  ASSERT_EQ(found.pockets.size(), 1u);
  EXPECT_NEAR(found.pockets[0].spill, 1, 1e-15);
  EXPECT_NEAR(found.pockets[0].floor, 0.05, 1e-15);
  EXPECT_NEAR(found.pockets[0].capacity, 1.9 * 0.9 * 0.95, 1e-14);
  EXPECT_EQ(found.pockets[0].faces.size(), 10u);
  EXPECT_EQ(found.sills.size(), 4u);
  for (const hydro::SillEdge& sill : found.sills) EXPECT_EQ(sill.other, hydro::kSea);
}

TEST(Pockets, ATiltedBoxHoldsAPrism) {
  // About y by an angle whose tangent is below 0.95/1.9 the water's surface meets both ends.
  const double angle = degrees(20), slope = std::tan(angle);
  const Pockets found = find_pockets(support::open_box(), tilted(angle));
  ASSERT_EQ(found.pockets.size(), 1u);
  EXPECT_NEAR(found.pockets[0].capacity, 0.9 * 1.9 * (0.95 - 1.9 * slope / 2), 1e-13);
  EXPECT_NEAR(found.pockets[0].spill, std::cos(angle) - 0.95 * std::sin(angle), 1e-14);
}

// A corner whose edges have the slopes u_x, u_y and u_z is a tetrahedron of (6 u_x u_y u_z)⁻¹ times
// the cube of its height.
TEST(Pockets, WaterInACornerOfABoxIsFoundFromAnyGuess) {
  const hydro::TriMesh box = support::open_box();
  const Eigen::Vector3d up_B = Eigen::Vector3d(0.4, 0.5, 0.8).normalized();
  const auto interior = hydro::make_interior(box, up_B);
  ASSERT_TRUE(interior);
  ASSERT_EQ(interior->pockets.size(), 1u);
  const Eigen::Matrix3d R_WB = Eigen::Quaterniond::FromTwoVectors(up_B, kUp).toRotationMatrix();
  const double corner = up_B.dot(Eigen::Vector3d(-0.95, -0.45, 0.05));
  for (const double volume : {1e-2, 1e-6, 1e-12})
    for (const double level : {-9.0, corner - 0.01, corner + 1e-5, corner + 0.9, 9.0})
      for (const double area : {0.0, 1e-12, 1e-3, 400.0}) {
        const hydro::WaterInside water =
            hydro::water_of(interior->pockets[0], R_WB, volume, {.level = level, .area = area});
        const double height = std::cbrt(6 * up_B.prod() * volume);
        EXPECT_NEAR(water.level, corner + height, 1e-12 * height + 1e-15);
        // The level has the round-off of a number of the size of one.
        EXPECT_NEAR(water.volume, volume, std::max(1e-12, 1e-15 / height) * volume);
      }
}

TEST(Pockets, WaterInATurnedOneLiesAtTheLowestLevelWithItsVolume) {
  const hydro::TriMesh box = support::open_box();
  const auto interior = hydro::make_interior(box, kUp);
  ASSERT_TRUE(interior);
  const hydro::Hull& pocket = interior->pockets[0];
  const Eigen::Vector3d up_B = Eigen::Vector3d(0.4, 0.7, -0.6).normalized();
  const Eigen::Matrix3d R_WB = Eigen::Quaterniond::FromTwoVectors(up_B, kUp).toRotationMatrix();
  const double lowest = (up_B.transpose() * pocket.mesh_B.vertices).minCoeff();
  const auto volume_at = [&](double height) {
    return hydro::water_up_to(pocket, R_WB, lowest + height).volume;
  };
  double full = 0.05;  // Height at which the volume is largest [m].
  while (volume_at(full + 0.01) > volume_at(full)) full += 0.01;
  ASSERT_LT(volume_at(2 * full), 0);
  for (const double volume : {1e-2, 1e-4, 1e-8}) {
    double low = 0, high = full;
    for (int i = 0; i < 100; ++i)
      (volume_at((low + high) / 2) < volume ? low : high) = (low + high) / 2;
    for (const double height : {-1.0, 0.01, full, 1.5 * full, 2 * full, 9.0})
      for (const double area : {0.0, 1e-3, 400.0}) {
        const hydro::WaterInside water =
            hydro::water_of(pocket, R_WB, volume, {.level = lowest + height, .area = area});
        EXPECT_NEAR(water.level, lowest + high, 1e-9 * high) << volume << ' ' << height;
      }
  }
  const hydro::WaterInside none =
      hydro::water_of(pocket, R_WB, 1.1 * volume_at(full + 0.005), {.level = 0, .area = 1});
  EXPECT_EQ(none.volume, 0);
  EXPECT_EQ(none.push.force.norm(), 0);
}

// Volumes below planes at the lowest point of the rim, by an independent sum over the prisms of the
// inner triangles, to their last digit.
TEST(Pockets, OfABucketIsOneAtAnyTilt) {
  const hydro::TriMesh bucket = hydro::scaled(support::stored_mesh("bucket.obj"), 3);
  const std::array<std::array<double, 3>, 5> tilt_spill_capacity = {{{0, 1.800, 2.574},
                                                                     {20, 1.414, 2.011},
                                                                     {45, 0.700, 1.200},
                                                                     {60, 0.199, 0.560},
                                                                     {80, -0.485, 0.018}}};
  for (const auto& [tilt, spill, capacity] : tilt_spill_capacity) {
    const Pockets found = find_pockets(bucket, tilted(degrees(tilt)));
    ASSERT_EQ(found.pockets.size(), 1u) << tilt;
    EXPECT_NEAR(found.pockets[0].spill, spill, 6e-4) << tilt;
    EXPECT_NEAR(found.pockets[0].capacity, capacity, 6e-4) << tilt;
  }
}

TEST(Pockets, ABoxUpsideDownHasNone) {
  EXPECT_TRUE(find_pockets(support::open_box(), -kUp).pockets.empty());
  EXPECT_TRUE(
      find_pockets(support::open_box(), Eigen::Vector3d(1, 0, -0.3).normalized()).pockets.empty());
}

TEST(Pockets, AWallBelowTheRimDividesThem) {
  const Pockets found = find_pockets(support::divided_box(0.6), kUp);
  ASSERT_EQ(found.pockets.size(), 2u);
  for (const hydro::Pocket& pocket : found.pockets) {
    EXPECT_NEAR(pocket.spill, 0.6, 1e-14);
    EXPECT_NEAR(pocket.capacity, 0.925 * 0.9 * 0.55, 1e-13);
  }
  double to_sea = HUGE_VAL, between = HUGE_VAL;
  const hydro::TriMesh mesh = support::divided_box(0.6);
  for (const hydro::SillEdge& sill : found.sills) {
    double& lowest = sill.other == hydro::kSea ? to_sea : between;
    lowest = std::min({lowest, mesh.vertices(2, sill.from), mesh.vertices(2, sill.to)});
  }
  EXPECT_EQ(to_sea, 1);
  EXPECT_EQ(between, 0.6);
}

TEST(Pockets, AVoidNeverSpills) {
  for (const Eigen::Vector3d& up : {kUp, Eigen::Vector3d(-kUp), tilted(1.1)}) {
    const Pockets found = find_pockets(support::closed_box(), up);
    ASSERT_EQ(found.pockets.size(), 1u);
    EXPECT_EQ(found.pockets[0].spill, HUGE_VAL);
    EXPECT_NEAR(found.pockets[0].capacity, 1.9 * 0.9 * 0.9, 1e-13);
    EXPECT_TRUE(found.sills.empty());
  }
}

TEST(Pockets, ABracketThatHangsIntoAPocketIsAPartOfIt) {
  // A beam across the mouth with a block under its middle, which has a lowest point of its own.
  const hydro::TriMesh mesh = support::blocks({{{-1, -0.95, -0.1, 0.1, 0.95, 1},
                                                {-0.5, -0.45, -0.1, 0.1, 0.45, 0.5},
                                                {0, 0.05, 0.5, 0.8, 1}}},
                                              [](int i, int j, int k) {
                                                const bool wall =
                                                    i == 0 || i == 4 || j == 0 || j == 4 || k == 0;
                                                const bool beam = i == 2 && k == 3;
                                                const bool block = i == 2 && j == 2 && k == 2;
                                                return wall || beam || block;
                                              });
  const Pockets found = find_pockets(mesh, kUp);
  ASSERT_EQ(found.pockets.size(), 1u);
  EXPECT_NEAR(found.pockets[0].spill, 1, 1e-14);
  EXPECT_NEAR(found.pockets[0].capacity, 1.9 * 0.9 * 0.95 - 0.2 * 0.2 * 0.3 - 0.2 * 0.9 * 0.2,
              1e-13);
}

TEST(Pockets, ACatamaranIsOutside) {
  // Two hulls under a deck; the right one has a cockpit.
  const hydro::TriMesh mesh = support::blocks(
      {{{0, 1, 3, 3.2, 3.8, 4}, {0, 0.2, 5.8, 6}, {0, 1, 1.3, 2}}}, [](int i, int j, int k) {
        if (k == 1) return !(i == 3 && j == 1);
        if (k == 0) return i == 0 || i >= 2;
        return i == 2 || i == 4 || (i == 3 && j != 1);
      });
  const Pockets found = find_pockets(mesh, kUp);
  ASSERT_EQ(found.pockets.size(), 1u);
  EXPECT_NEAR(found.pockets[0].capacity, 0.6 * 5.6 * 1.0, 1e-12);
  EXPECT_NEAR(found.pockets[0].spill, 2, 1e-14);
}

TEST(Pockets, ConvexBodiesHaveNone) {
  for (const hydro::TriMesh& mesh : {hydro::make_box({2, 1, 0.5}, 3), hydro::make_icosphere(1, 2),
                                     hydro::make_cylinder(1, 2, 12, 2)}) {
    EXPECT_TRUE(hydro::is_convex(mesh));
    for (int i = 0; i < 50; ++i)
      EXPECT_TRUE(find_pockets(mesh, Eigen::Vector3d::Random().normalized()).pockets.empty());
  }
  EXPECT_FALSE(hydro::is_convex(support::open_box()));
  EXPECT_FALSE(hydro::is_convex(support::closed_box()));
}

}  // namespace

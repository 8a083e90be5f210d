#include "hydro/interior/lids.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/interior/places.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/hollows.h"
#include "tests/support/random_pose.h"

namespace {

using hydro::find_pockets;
using hydro::TriMesh;
using hydro::with_lids;

const Eigen::Vector3d kUpright = Eigen::Vector3d::UnitZ();

double volume(const TriMesh& mesh) { return hydro::solid_properties(mesh).volume; }

TriMesh closed(const TriMesh& mesh, const Eigen::Vector3d& up = kUpright) {
  return with_lids(mesh, find_pockets(mesh, up));
}

TEST(ClosedMouths, TheOutsideOfABoxIsABox) {
  for (const TriMesh& hollow :
       {support::open_box(), support::divided_box(0.6), support::closed_box()}) {
    const TriMesh outside = closed(hollow);
    EXPECT_TRUE(hydro::check_mesh(outside).closed());
    EXPECT_NEAR(volume(outside), 2, 1e-14);
  }
}

TEST(ClosedMouths, TheBodyIsClosedInAnyAttitude) {
  support::Random random(3);
  const TriMesh box = support::divided_box(0.7);
  for (int i = 0; i < 500; ++i) {
    const TriMesh outside = closed(box, random.rotation() * kUpright);
    EXPECT_TRUE(hydro::check_mesh(outside).closed());
    EXPECT_GE(volume(outside), volume(box) - 1e-12);
    EXPECT_LE(volume(outside), 2 + 1e-12);
  }
}

TEST(ClosedMouths, AnLShapedMouthIsClosedWithinItsOutline) {
  const TriMesh hollow = support::blocks(
      {{{0, 0.1, 0.9, 1, 1.9, 2}, {0, 0.1, 0.9, 1, 1.9, 2}, {0, 0.1, 1}}}, [](int i, int j, int k) {
        if (i >= 3 && j >= 3) return false;
        return k == 0 || i % 4 == 0 || j % 4 == 0 || (i == 2 && j >= 2) || (j == 2 && i >= 2);
      });
  const TriMesh outside = closed(hollow);
  const hydro::Pockets pockets = find_pockets(hollow, kUpright);
  ASSERT_EQ(pockets.pockets.size(), 1u);
  EXPECT_TRUE(hydro::check_mesh(outside).closed());
  EXPECT_NEAR(volume(outside), volume(hollow) + pockets.pockets[0].capacity, 1e-13);
  // No lid leaves the outline: all of its faces look up.
  for (Eigen::Index f = 0; f < outside.face_count(); ++f) {
    const Eigen::Vector3d n = hydro::area_vector(outside, f);
    if (std::abs(outside.vertices(2, outside.faces(0, f)) - 1) < 1e-12 &&
        n.head<2>().norm() < 1e-12) {
      EXPECT_GT(n.z(), 0);
    }
  }
}

TEST(ClosedMouths, AConvexBodyStaysAsItIs) {
  const TriMesh box = hydro::make_box({1, 2, 3}, 2);
  EXPECT_TRUE(hydro::same_mesh(closed(box), box));
}

TEST(Places, APointBelongsToThePocketBelowIt) {
  const TriMesh box = support::divided_box(0.6);
  const hydro::Pockets found = find_pockets(box, kUpright);
  const int left = hydro::pocket_under(box, found, {-0.5, 0, 0.3}, kUpright);
  const int right = hydro::pocket_under(box, found, {0.5, 0.1, 0.9}, kUpright);
  EXPECT_NE(left, hydro::kSea);
  EXPECT_NE(right, hydro::kSea);
  EXPECT_NE(left, right);
  EXPECT_EQ(hydro::pocket_under(box, found, {3, 0, 0.3}, kUpright), hydro::kSea);
  EXPECT_EQ(hydro::pocket_under(box, found, {0.5, 0, 0.01}, kUpright), hydro::kSea);
}

TEST(Places, AWallHasTheSpacesOnItsSides) {
  const TriMesh box = support::divided_box(0.6);
  const hydro::Pockets found = find_pockets(box, kUpright);
  const auto sides = [&](const Eigen::Vector3d& point) {
    const hydro::WallFaces wall = hydro::wall_at(box, point);
    EXPECT_LE(wall.distance, 0.05 + 1e-12);
    std::array<int, 2> spaces = {found.pocket_of_face[wall.face[0]],
                                 found.pocket_of_face[wall.face[1]]};
    std::sort(spaces.begin(), spaces.end());
    return spaces;
  };
  EXPECT_EQ(sides({0, 0.1, 0.3}), (std::array<int, 2>{0, 1}));
  const std::array<int, 2> hull = sides({-1, 0.1, 0.3});
  EXPECT_EQ(hull[0], hydro::kSea);
  EXPECT_NE(hull[1], hydro::kSea);
}

}  // namespace

#include "hydro/mesh/mesh_union.h"

#include <gtest/gtest.h>

#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::TriMesh;

TriMesh box(const Vector3d& size, const Vector3d& centre, int divisions = 1) {
  return translated(hydro::make_box(size, divisions), centre);
}

double area_of(const TriMesh& mesh) {
  double area = 0;
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) area += area_vector(mesh, f).norm();
  return area;
}

/// Some pose, so that nothing is along an axis.
Eigen::Isometry3d pose() {
  Eigen::Isometry3d X(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -3).normalized()));
  X.pretranslate(Vector3d(3, -5, 2));
  return X;
}

TEST(MeshUnion, BoxesThatTouchBecomeOneSolidWithoutTheCommonFace) {
  struct Case {
    const char* what;
    TriMesh other;
    double common;  ///< Area [m^2].
  };
  const Case cases[] = {{"a whole face", box({1, 1, 2}, {0, 0, 1.5}), 1},
                        {"a part inside a face", box({0.3, 0.4, 1}, {0.1, -0.05, 1}), 0.12},
                        {"a part at a rim", box({0.5, 0.5, 1}, {0.25, 0.1, 1}), 0.25},
                        {"a face that overhangs", box({3, 0.5, 1}, {0.2, 0, 1}), 0.5},
                        {"corners", box({1, 1, 1}, {0.6, 0.7, 1}), 0.4 * 0.3},
                        {"other triangles", box({0.7, 0.7, 1}, {0, 0, 1}, 3), 0.49}};
  for (const Case& c : cases) {
    const TriMesh a = transformed(box({1, 1, 1}, {0, 0, 0}, 2), pose());
    const TriMesh b = transformed(c.other, pose());
    EXPECT_FALSE(hydro::common_part(a, b)) << c.what;
    const TriMesh both = hydro::joined({a, b});
    EXPECT_TRUE(check_mesh(both).sound())
        << c.what << ": " << testing::PrintToString(describe(check_mesh(both)));
    // The outlines of the contact are welded within 2e-6 of the size.
    EXPECT_NEAR(check_mesh(both).volume, check_mesh(a).volume + check_mesh(b).volume,
                support::tolerance(1e-5))
        << c.what;
    EXPECT_NEAR(area_of(both), area_of(a) + area_of(b) - 2 * c.common, support::tolerance(5e-5))
        << c.what;
  }
}

TEST(MeshUnion, WhatLiesApartOrTouchesInAPointOrALineRemainsAsItIs) {
  const TriMesh a = box({1, 1, 1}, {0, 0, 0});
  for (const TriMesh& b : {box({1, 1, 1}, {3, 0, 0}), box({1, 1, 1}, {1, 1, 0}),
                           translated(hydro::make_icosphere(1, 2), {0, 0, 1.5})}) {
    EXPECT_FALSE(hydro::common_part(a, b));
    const TriMesh both = hydro::joined({a, b});
    EXPECT_EQ(both.face_count(), a.face_count() + b.face_count());
    EXPECT_TRUE(check_mesh(both).sound());
  }
}

TEST(MeshUnion, FindsHowFarSolidsReachIntoEachOther) {
  struct Case {
    const char* what;
    TriMesh other;
    int axis;
    double depth;
  };
  const Case cases[] = {
      {"aligned", box({1, 1, 1}, {0.9, 0, 0}), 0, 0.1},
      {"a corner", box({1, 1, 1}, {0.7, 0.8, 0.95}), 2, 0.05},
      {"a bar through it", box({4, 0.2, 0.3}, {0, 0, 0.1}), 1, 0.2},
      {"inside", box({0.5, 0.4, 0.6}, {0.1, 0, 0}), 1, 0.4},
      {"the same", box({1, 1, 1}, {0, 0, 0}), 0, 1},
      {"a shallow sphere", translated(hydro::make_icosphere(0.5, 3), {0, 0, 0.99}), 2, 0.01}};
  const TriMesh a = box({1, 1, 1}, {0, 0, 0});
  for (const Case& c : cases)
    for (const bool swapped : {false, true}) {
      const auto common = swapped ? hydro::common_part(c.other, a) : hydro::common_part(a, c.other);
      ASSERT_TRUE(common) << c.what;
      EXPECT_EQ(common->axis(), c.axis) << c.what;
      EXPECT_NEAR(common->depth(), c.depth, support::tolerance(1e-9)) << c.what;
    }
}

TEST(MeshUnion, ABodyInACavityHasNothingInCommonWithTheWalls) {
  TriMesh shell = hydro::joined({box({2, 2, 2}, {0, 0, 0}), flipped(box({1, 1, 1}, {0, 0, 0}))});
  ASSERT_TRUE(check_mesh(shell).sound());
  EXPECT_FALSE(hydro::common_part(shell, box({0.5, 0.5, 0.5}, {0, 0, 0})));
  EXPECT_TRUE(hydro::common_part(shell, box({1.5, 0.5, 0.5}, {0, 0, 0})));
}

}  // namespace

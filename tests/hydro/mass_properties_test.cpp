#include "hydro/mesh/mass_properties.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

namespace {

using hydro::SolidProperties;
using hydro::TriMesh;
using support::Random;

/// Relative round-off of sums over up to some thousand faces.
constexpr double kIntegralRounding = 1e-13;

void expect_same(const SolidProperties& actual, const SolidProperties& expected, double size,
                 double relative = kIntegralRounding) {
  EXPECT_NEAR(actual.volume / expected.volume, 1, support::tolerance(relative));
  EXPECT_LE((actual.centroid - expected.centroid).norm(), support::tolerance(relative * size));
  EXPECT_LE((actual.inertia - expected.inertia).norm(),
            support::tolerance(relative * expected.inertia.norm()));
}

SolidProperties moved(const SolidProperties& solid, const Eigen::Isometry3d& X) {
  const Eigen::Matrix3d R = X.linear();
  return {solid.volume, X * solid.centroid, R * solid.inertia * R.transpose()};
}

TEST(MassProperties, BoxHasItsClosedForm) {
  const double a = 1, b = 2, c = 3;
  const Eigen::Vector3d squares(b * b + c * c, a * a + c * c, a * a + b * b);
  const SolidProperties box{6, Eigen::Vector3d::Zero(), (squares * 6 / 12).asDiagonal()};
  expect_same(solid_properties(hydro::make_box({a, b, c}, 6)), box, 3);
}

TEST(MassProperties, TetrahedronHasItsClosedForm) {
  // With corners at the origin and a, b, c on the axes: ∫x² = V a²/10, ∫xy = V ab/20 about the
  // corner; the centroid is (a, b, c)/4.
  const Eigen::Vector3d e(2, 3, 5);
  const double volume = 5;
  Eigen::Matrix3d second = volume / 20 * (e * e.transpose());
  second.diagonal() *= 2;
  second -= volume * (e * e.transpose()) / 16;
  const SolidProperties expected{volume, e / 4,
                                 second.trace() * Eigen::Matrix3d::Identity() - second};
  expect_same(solid_properties(support::corner_tetrahedron(e)), expected, 5);
}

TEST(MassProperties, MovingTheMeshMovesTheSolid) {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const TriMesh mesh = support::random_star(random);
    const Eigen::Isometry3d X = support::random_pose(random, 10);
    expect_same(solid_properties(transformed(mesh, X)), moved(solid_properties(mesh), X), 10);
  }
}

TEST(MassProperties, ScalingGoesWithTheThirdFirstAndFifthPower) {
  Random random(2);
  const TriMesh mesh = translated(support::random_star(random), {1, 2, 3});
  const SolidProperties solid = solid_properties(mesh);
  for (const double s : {0.01, 7.0, -2.0}) {
    const SolidProperties expected{std::abs(s * s * s) * solid.volume, s * solid.centroid,
                                   std::abs(s * s * s * s * s) * solid.inertia};
    expect_same(solid_properties(scaled(mesh, s)), expected, std::abs(s) * 5);
  }
}

TEST(MassProperties, AMillionMetresAwayOnlyTheDigitsOfTheCoordinatesAreLost) {
  Random random(3);
  const TriMesh mesh = support::random_star(random);
  const Eigen::Vector3d away(1e6, -1e6, 1e6);
  // Moved there and back, so that both meshes have the same coordinates up to the move.
  const TriMesh there = translated(mesh, away);
  const TriMesh back = translated(there, -away);
  SolidProperties expected = solid_properties(back);
  expected.centroid += away;
  // The middle of the box is exact to 1e-10 m there, and so is the centroid; the rest does not
  // notice.
  const SolidProperties actual = solid_properties(there);
  EXPECT_LE((actual.centroid - expected.centroid).norm(), support::tolerance(4e-10));
  EXPECT_NEAR(actual.volume / expected.volume, 1, support::tolerance(kIntegralRounding));
  EXPECT_LE((actual.inertia - expected.inertia).norm(),
            support::tolerance(kIntegralRounding * expected.inertia.norm()));
}

TEST(MassProperties, TurningTheFacesOverChangesTheSign) {
  Random random(4);
  const TriMesh mesh = support::random_star(random);
  const SolidProperties solid = solid_properties(mesh);
  const SolidProperties inside_out = solid_properties(flipped(mesh));
  expect_same(inside_out, {-solid.volume, solid.centroid, -solid.inertia}, 1);
}

TEST(MassProperties, InscribedSphereConvergesWithSecondOrder) {
  // Errors fall by four when the panels are halved; 3 % of that is left to the next order.
  double last_volume = 0, last_inertia = 0;
  for (const int n : {16, 32, 64}) {
    const SolidProperties solid = solid_properties(hydro::make_sphere(1, n, n));
    const double volume = 4 * M_PI / 3 - solid.volume;
    const double inertia = 8 * M_PI / 15 - solid.inertia(0, 0);
    EXPECT_GT(volume, 0);
    EXPECT_GT(inertia, 0);
    if (last_volume > 0) {
      EXPECT_NEAR(last_volume / volume, 4, support::tolerance(0.12)) << n;
      EXPECT_NEAR(last_inertia / inertia, 4, support::tolerance(0.12)) << n;
    }
    last_volume = volume;
    last_inertia = inertia;
  }
}

/// Both solids together by the parallel axis theorem; `sign` −1 takes the second away.
SolidProperties sum(const SolidProperties& a, const SolidProperties& b, double sign) {
  SolidProperties all;
  all.volume = a.volume + sign * b.volume;
  all.centroid = (a.volume * a.centroid + sign * b.volume * b.centroid) / all.volume;
  const auto about = [&](const SolidProperties& s) -> Eigen::Matrix3d {
    const Eigen::Vector3d d = s.centroid - all.centroid;
    return s.inertia +
           s.volume * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
  };
  all.inertia = about(a) + sign * about(b);
  return all;
}

TEST(MassProperties, DisjointPartsAdd) {
  Random random(5);
  const TriMesh a = support::random_star(random);
  const TriMesh b = transformed(hydro::make_box({1, 2, 3}), support::random_pose(random, 5));
  expect_same(solid_properties(support::united(a, b)),
              sum(solid_properties(a), solid_properties(b), 1), 5);
}

TEST(MassProperties, CavityIsTakenAway) {
  Random random(6);
  const TriMesh outside = hydro::make_box({4, 4, 4}, 2);
  const TriMesh hole = translated(support::random_star(random), {0.3, -0.2, 0.1});
  expect_same(solid_properties(support::united(outside, flipped(hole))),
              sum(solid_properties(outside), solid_properties(hole), -1), 4);
}

TEST(MassProperties, InertiaIsExactlySymmetricAndPhysical) {
  Random random(7);
  for (int i = 0; i < 10; ++i) {
    const Eigen::Matrix3d inertia = solid_properties(support::random_star(random)).inertia;
    EXPECT_EQ(inertia, inertia.transpose());
    const Eigen::Vector3d principal = inertia.selfadjointView<Eigen::Lower>().eigenvalues();
    EXPECT_GT(principal[0], 0);
    EXPECT_GT(principal[0] + principal[1], principal[2]);
  }
}

TEST(MassProperties, MeshWithoutFacesIsNothing) {
  const SolidProperties nothing = solid_properties(TriMesh{});
  EXPECT_EQ(nothing.volume, 0);
  EXPECT_EQ(nothing.inertia, Eigen::Matrix3d::Zero());
}

}  // namespace

#include "hydro/statics/hydrostatics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "hydro/loads/loads.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/ship_hulls.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using hydro::Hydrostatics;
using hydro::TriMesh;

/// Sums of some thousand terms of the size of the result.
const double kRoundOff = support::tolerance(1e-13);

/// On meshes of 1, 2 and 4 times the fineness an error of second order falls to 1/4 each time; the
/// next order's share is a few per cent here.
void expect_second_order(const std::function<double(int)>& value, double exact) {
  const double coarse = std::abs(value(1) - exact);
  const double middle = std::abs(value(2) - exact);
  const double fine = std::abs(value(4) - exact);
  EXPECT_NEAR(coarse / middle, 4, support::tolerance(0.3));
  EXPECT_NEAR(middle / fine, 4, support::tolerance(0.1));
  EXPECT_LT(fine, 5e-3 * std::abs(exact));
}

Matrix2d diagonal(double xx, double yy) { return Vector2d(xx, yy).asDiagonal(); }

TEST(Hydrostatics, OfAnUprightBoxAreThoseOfTheBookInAnyDivision) {
  for (const int divisions : {1, 2, 5}) {
    const TriMesh box = hydro::make_box({6, 2, 1.5}, divisions);
    const double draught = 0.4;
    const Hydrostatics h = hydro::hydrostatics(box, 0.75 - draught);
    EXPECT_NEAR(h.volume, 6 * 2 * draught, kRoundOff);
    EXPECT_LT((h.centre_of_buoyancy - Vector3d(0, 0, -0.75 + draught / 2)).norm(), kRoundOff);
    EXPECT_NEAR(h.wetted_surface, 6 * 2 + 2 * (6 + 2) * draught, 10 * kRoundOff);
    EXPECT_NEAR(h.waterplane.area, 12, kRoundOff);
    EXPECT_LT(h.waterplane.centroid.norm(), kRoundOff);
    EXPECT_LT((h.waterplane.second_moment - diagonal(2 * 216 / 12.0, 6 * 8 / 12.0)).norm(),
              100 * kRoundOff);
  }
}

TEST(Hydrostatics, OfAWaterplaneWithAHoleAndFarFromTheCentreOfMass) {
  // A torus on its side cut through its middle: an annulus; the second moments of its polygons with
  // n corners on circles of radius R are n R⁴ sin(2π/n) (2 + cos(2π/n)) / 24 about each axis.
  const int n = 24;
  const TriMesh torus = hydro::translated(support::make_torus(2, 0.5, n, 12), {300, -200, 0.1});
  const Hydrostatics h = hydro::hydrostatics(torus, -0.1);
  const double u = 2 * M_PI / n;
  const auto area = [&](double r) { return n * r * r * std::sin(u) / 2; };
  const auto second = [&](double r) {
    return n * std::pow(r, 4) * std::sin(u) * (2 + std::cos(u)) / 24;
  };
  // 300 m away: coordinates carry 6e-14 m, which an area of 20 m^2 with edges of 16 m feels.
  const double tolerance = support::tolerance(1e-11);
  EXPECT_NEAR(h.waterplane.area, area(2.5) - area(1.5), tolerance);
  EXPECT_LT((h.waterplane.centroid - Vector2d(300, -200)).norm(), tolerance);
  const double i = second(2.5) - second(1.5);
  EXPECT_LT((h.waterplane.second_moment - diagonal(i, i)).norm(), 10 * tolerance);
}

TEST(Hydrostatics, OfSeparateWaterplanesAddUp) {
  const TriMesh hull = hydro::make_box({4, 1, 1});
  const TriMesh catamaran =
      support::united(hydro::translated(hull, {0, 3, 0}), hydro::translated(hull, {0, -3, 0}));
  const Hydrostatics h = hydro::hydrostatics(catamaran, 0);
  EXPECT_NEAR(h.waterplane.area, 8, kRoundOff);
  EXPECT_LT((h.waterplane.second_moment - diagonal(2 * 64 / 12.0, 2 * (4 / 12.0 + 4 * 9))).norm(),
            100 * kRoundOff);
}

TEST(Hydrostatics, AgreeWithTheLoadsOfTheWaterOnRandomBodies) {
  support::Random random(61);
  const hydro::Sea sea{.density = 1, .gravity = 1};
  for (int i = 0; i < 30; ++i) {
    const TriMesh mesh = support::random_star(random);
    const double height = random.uniform(-0.8, 0.8);
    const Hydrostatics h = hydro::hydrostatics(mesh, height);
    const hydro::BodyState state{.position = {5, 6, height}};
    const hydro::Loads loads = hydro::compute_loads(hydro::make_hull(mesh), state, sea, 0, {});
    EXPECT_NEAR(h.volume, loads.displaced_volume, kRoundOff);
    EXPECT_NEAR(h.wetted_surface, loads.wetted_area, 10 * kRoundOff);
    const Vector3d moment = h.centre_of_buoyancy.cross(Vector3d(0, 0, h.volume));
    EXPECT_LT((moment - loads.buoyancy.moment).norm(), kRoundOff);
  }
}

TEST(Hydrostatics, WhollyWetAreThoseOfTheSolidAndWhollyDryNone) {
  support::Random random(62);
  const TriMesh mesh = support::random_star(random);
  const hydro::SolidProperties solid = hydro::solid_properties(mesh);
  const Hydrostatics wet = hydro::hydrostatics(mesh, -1.5);
  EXPECT_NEAR(wet.volume, solid.volume, kRoundOff);
  EXPECT_LT((wet.centre_of_buoyancy - solid.centroid).norm(), kRoundOff);
  EXPECT_EQ(wet.waterplane.area, 0);
  EXPECT_EQ(hydro::hydrostatics(mesh, 1.5).volume, 0);
  EXPECT_EQ(hydro::hydrostatics(mesh, 1.5).wetted_surface, 0);
}

TEST(Hydrostatics, OfAWigleyHullConvergeToItsClosedFormsAtSecondOrder) {
  const double L = 10, B = 1, T = 0.625;
  const auto hull = [&](int fineness) {
    return hydro::hydrostatics(support::make_wigley(L, B, T, 0.4, 8 * fineness), 0);
  };
  const auto bm = [&](int k, int axis) {
    const Hydrostatics h = hull(k);
    return h.waterplane.second_moment(axis, axis) / h.volume;
  };
  expect_second_order([&](int k) { return hull(k).volume; }, 4 / 9.0 * L * B * T);
  expect_second_order([&](int k) { return hull(k).waterplane.area; }, 2 / 3.0 * L * B);
  expect_second_order([&](int k) { return hull(k).centre_of_buoyancy.z(); }, -3 / 8.0 * T);
  expect_second_order([&](int k) { return bm(k, 1); }, 3 * B * B / (35 * T));
  expect_second_order([&](int k) { return bm(k, 0); }, 3 * L * L / (40 * T));
}

TEST(Hydrostatics, OfASphereHaveTheMetacentreInItsMiddleAtSecondOrder) {
  // The centre of mass 0.3 m below the middle of a sphere of 1 m. The waterline is a ring of
  // vertices in every mesh: elsewhere the error also depends on where it cuts the faces.
  const double R = 1, deep = 1 - std::cos(6 * M_PI / 16), below = 0.3;
  const auto sphere = [&](int fineness) {
    const TriMesh mesh = hydro::make_sphere(R, 16 * fineness, 16 * fineness);
    return hydro::hydrostatics(hydro::translated(mesh, {0, 0, below}), R - deep - below);
  };
  const auto gm = [&](int k, int axis) {
    return hydro::metacentric_heights(sphere(k))(axis, axis);
  };
  const double kb = R - 3 * std::pow(2 * R - deep, 2) / (4 * (3 * R - deep));
  expect_second_order([&](int k) { return sphere(k).volume; },
                      M_PI * deep * deep * (3 * R - deep) / 3);
  expect_second_order([&](int k) { return sphere(k).centre_of_buoyancy.z() - below + R; }, kb);
  expect_second_order([&](int k) { return gm(k, 0); }, below);
  expect_second_order([&](int k) { return gm(k, 1); }, below);
}

/// Heave force, roll and pitch moment of water per ρ g, of a body turned by small angles.
Vector3d load(const TriMesh& mesh_G, const Vector3d& heave_roll_pitch) {
  const Vector3d turn(heave_roll_pitch[1], heave_roll_pitch[2], 0);
  const Eigen::Isometry3d X(turn.isZero(0) ? Eigen::AngleAxisd::Identity()
                                           : Eigen::AngleAxisd(turn.norm(), turn.normalized()));
  const hydro::Loads loads = hydro::compute_loads(hydro::make_hull(hydro::transformed(mesh_G, X)),
                                                  {.position = {0, 0, heave_roll_pitch[0]}},
                                                  {.density = 1, .gravity = 1}, 0, {});
  return {loads.buoyancy.force.z(), loads.buoyancy.moment.x(), loads.buoyancy.moment.y()};
}

TEST(Hydrostatics, StiffnessIsMinusTheDerivativeOfTheLoadInAnyPose) {
  support::Random random(63);
  const double step = 1e-5;
  for (int i = 0; i < 20; ++i) {
    const TriMesh mesh = hydro::translated(
        hydro::transformed(support::random_star(random), support::random_pose(random, 0)),
        random.vector(0.5));
    const Matrix3d stiffness = hydro::restoring_stiffness(hydro::hydrostatics(mesh, 0));
    Matrix3d difference;
    for (int k = 0; k < 3; ++k)
      difference.col(k) =
          -(load(mesh, step * Vector3d::Unit(k)) - load(mesh, -step * Vector3d::Unit(k))) /
          (2 * step);
    // Central differences: step² of truncation, and up to `step` where the waterline passes a
    // vertex meanwhile; round-off 1e-11.
    EXPECT_LT((difference - stiffness).norm(), support::tolerance(1e-7) * stiffness.norm());
  }
}

TEST(Hydrostatics, MetacentricHeightsAreTheStiffnessWithHeaveEliminated) {
  support::Random random(64);
  const TriMesh mesh = hydro::translated(support::random_star(random), {0.4, -0.3, 0.1});
  const Hydrostatics h = hydro::hydrostatics(mesh, 0.2);
  const Matrix3d c = hydro::restoring_stiffness(h);
  const Vector2d coupling = c.block<2, 1>(1, 0);
  const Matrix2d schur = c.bottomRightCorner<2, 2>() - coupling * coupling.transpose() / c(0, 0);
  EXPECT_LT((schur / h.volume - hydro::metacentric_heights(h)).norm(), kRoundOff);
}

}  // namespace

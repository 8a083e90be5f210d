#include "hydro/added_mass/surface_added_mass.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "hydro/mesh/primitives.h"
#include "tests/support/tolerance.h"
#include "tests/support/water_planes.h"

/// What the model owes to its grid: with few patches, so that sanitizers get through. How accurate
/// it is: surface_interpolation_test.cpp.

namespace hydro {
namespace {

using Eigen::Vector3d;
using support::plane_at;
using support::Random;
using support::some_planes;
using support::tolerance;

/// Of solutions in tests that are about the grid, not about their accuracy.
constexpr int kFewPatches = 24;

TriMesh barge() { return make_box({4, 2, 1}, 2); }

TEST(SurfaceAddedMass, NodesAreTheSolutions) {
  const TriMesh mesh = barge();
  const SurfaceAddedMass model(mesh, {}, kFewPatches);
  // A level box has v = its part of the height, and x = 1/2 is the node with v = 1 − (3/4)³.
  const WaterPlane plane = plane_at(mesh, Vector3d::UnitZ(), 1 - 27.0 / 64);
  const Matrix6d solved = solve_under(mesh, plane, kFewPatches).matrix;
  EXPECT_LT((model.under(plane) - solved).norm(), tolerance(1e-9 * solved.norm()));
}

TEST(SurfaceAddedMass, HeadingAndPlaceDoNotMatter) {
  Random random(2);
  const SurfaceAddedMass model(barge(), {}, kFewPatches);
  BodyState state = random.state(0.2, 1);
  const Matrix6d A = model.at(state, Sea{}, 0);
  state.orientation = Eigen::AngleAxisd(1.3, Vector3d::UnitZ()) * state.orientation;
  state.position.head<2>() += Eigen::Vector2d(100, -30);
  EXPECT_GT(A.norm(), 100);
  EXPECT_LT((model.at(state, Sea{}, 7) - A).norm(), tolerance(1e-9 * A.norm()));
}

TEST(SurfaceAddedMass, FollowsDensityAndLevelOfTheSea) {
  const SurfaceAddedMass model(barge(), {}, kFewPatches);
  Sea sea;
  const Matrix6d A = model.at({}, sea, 0);
  sea.density *= 1.025;
  sea.level = 40;
  BodyState state;
  state.position.z() = 40;
  EXPECT_LT((model.at(state, sea, 0) - 1.025 * A).norm(), tolerance(1e-12 * A.norm()));
}

TEST(SurfaceAddedMass, DryBodyHasNoneAndAsksForNoSolution) {
  const SurfaceAddedMass model(barge(), {}, kFewPatches);
  BodyState state;
  state.position.z() = 0.5;
  EXPECT_TRUE(model.at(state, Sea{}, 0).isZero(0));
  state.position.z() = 50;
  EXPECT_TRUE(model.at(state, Sea{}, 0).isZero(0));
  EXPECT_EQ(model.solves(), 0);
}

TEST(SurfaceAddedMass, UprightBodyAsksForTwoSolutions) {
  const SurfaceAddedMass model(barge(), {}, kFewPatches);
  BodyState state;
  for (int i = 0; i < 20; ++i) {
    state.position.z() = 1e-4 * i;
    state.orientation = Eigen::AngleAxisd(1e-7 * i, Vector3d::UnitX());
    model.at(state, Sea{}, 0);
  }
  EXPECT_EQ(model.solves(), 2);
}

TEST(SurfaceAddedMass, IsSymmetricWithoutNegativeEigenvaluesEverywhere) {
  const TriMesh mesh = barge();
  const SurfaceAddedMass model(mesh, {}, kFewPatches);
  for (const WaterPlane& plane : some_planes(mesh, 8)) {
    const Matrix6d A = model.under(plane);
    EXPECT_EQ(A, Matrix6d(A.transpose()));
    const Vector6d values = Eigen::SelfAdjointEigenSolver<Matrix6d>(A).eigenvalues();
    EXPECT_GE(values[0], -1e-12 * values[5]);
  }
}

TEST(SurfaceAddedMass, KnownNodesAreNotSolvedAgain) {
  const TriMesh mesh = barge();
  const std::vector<WaterPlane> planes = some_planes(mesh, 3);
  const SurfaceAddedMass first(mesh, {}, kFewPatches);
  for (const WaterPlane& plane : planes) first.under(plane);
  EXPECT_EQ(first.nodes().size(), static_cast<std::size_t>(first.solves()));
  const SurfaceAddedMass second(mesh, first.nodes(), kFewPatches);
  for (const WaterPlane& plane : planes) EXPECT_EQ(second.under(plane), first.under(plane));
  EXPECT_EQ(second.solves(), 0);
}

}  // namespace
}  // namespace hydro

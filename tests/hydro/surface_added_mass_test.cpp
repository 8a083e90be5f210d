#include "hydro/added_mass/surface_added_mass.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "hydro/mesh/mass_properties.h"
#include "hydro/parallel.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

namespace hydro {
namespace {

using Eigen::Vector3d;
using support::Random;
using support::tolerance;

/// Of solutions in tests that are about the grid, not about their accuracy.
constexpr int kFewPatches = 40;

WaterPlane plane_at(const TriMesh& mesh_B, const Vector3d& up, double part_of_height) {
  const Eigen::RowVectorXd heights = up.transpose() * mesh_B.vertices;
  return {up, heights.minCoeff() + part_of_height * (heights.maxCoeff() - heights.minCoeff())};
}

TriMesh barge() { return make_box({4, 2, 1}, 2); }

TEST(AttitudeGrid, NodesHaveTheirOwnDirections) {
  const AttitudeGrid grid(12);
  int nodes = 0;
  for (int i = -12; i <= 12; ++i) {
    for (int j = -12; j <= 12; ++j) {
      for (const int below : {0, 1}) {
        const int rest = 12 - std::abs(i) - std::abs(j);
        if (rest < 0 || (rest == 0 && below == 1)) continue;
        const int node = 2 * ((i + 12) * 25 + j + 12) + below;
        const Vector3d up = grid.direction(node);
        EXPECT_NEAR(up.norm(), 1, 1e-14);
        double own = 0;
        for (const auto& corner : grid.around(up))
          if (corner.node == node) own += corner.weight;
        EXPECT_NEAR(own, 1, 1e-12) << node;
        ++nodes;
      }
    }
  }
  EXPECT_EQ(nodes, 4 * 12 * 12 + 2);
}

TEST(AttitudeGrid, AxesAreNodes) {
  const AttitudeGrid grid(12);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      int asked = 0;
      for (const auto& corner : grid.around(sign * Vector3d::Unit(axis))) {
        if (corner.weight == 0) continue;
        ++asked;
        EXPECT_NEAR(grid.direction(corner.node).dot(sign * Vector3d::Unit(axis)), 1, 1e-15);
      }
      EXPECT_EQ(asked, 1);
    }
  }
}

// Nodes around a direction are within one step of it, 7.5° along the edges and, as asin(1/√3) is
// 0.6155 where 1/3 of 90° is 0.5236, up to 0.6155/0.5236 · √2 times that inside: 12.5°.
TEST(AttitudeGrid, DirectionsLieBetweenNearNodes) {
  const AttitudeGrid grid(12);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d up = random.vector(1).normalized();
    double sum = 0;
    for (const auto& corner : grid.around(up)) {
      EXPECT_GE(corner.weight, 0);
      sum += corner.weight;
      EXPECT_LT(corner.node, grid.bound());
      EXPECT_GE(corner.node, 0);
      if (corner.weight == 0) continue;
      EXPECT_GT(grid.direction(corner.node).dot(up), std::cos(12.5 * M_PI / 180));
    }
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

TEST(SurfaceAddedMass, NodesAreTheSolutions) {
  const TriMesh mesh = barge();
  const SurfaceAddedMass model(mesh, {}, kFewPatches);
  // A level box has v = its part of the height, and x = 1/2 is the node with v = 1 − (3/4)³.
  const WaterPlane plane = plane_at(mesh, Vector3d::UnitZ(), 1 - 27.0 / 64);
  const Matrix6d solved = solve_under(mesh, plane, kFewPatches).matrix;
  EXPECT_LT((model.under(plane) - solved).norm(), tolerance(1e-9 * solved.norm()));
}

/// The largest |x·ΔA·y| over vectors of one in the scale of the whole body's A and a tenth of its
/// displaced fluid's inertia, as the deep solution's error is told.
double error_of(const Matrix6d& difference, const TriMesh& mesh_B, int patches) {
  const SolidProperties solid = solid_properties(mesh_B);
  Matrix6d scale = solve_under(mesh_B, {}, patches).matrix;
  scale.topLeftCorner<3, 3>() += 0.1 * solid.volume * Eigen::Matrix3d::Identity();
  scale.bottomRightCorner<3, 3>() += 0.1 * solid.inertia;
  const Matrix6d root = Matrix6d(scale.llt().matrixL()).inverse();
  return Eigen::JacobiSVD<Matrix6d>(root * difference * root.transpose()).singularValues()[0];
}

// The error of a linear interpolation of cos 2θ, as a body's anisotropy goes, over steps of up to
// 12.5° is h²/8 · 4 = 2.4 % of its amplitude. A single pose of a sharp body may have twice that,
// where a whole edge goes under within a step.
TEST(SurfaceAddedMass, InterpolationErrorIsSmall) {
  Random random(5);
  for (const TriMesh& mesh : {make_ellipsoid({2, 1, 1}, 24, 12), barge()}) {
    const SurfaceAddedMass model(mesh, {}, 120);
    double sum = 0, worst = 0;
    constexpr int kPoses = 12;
    for (int i = 0; i < kPoses; ++i) {
      const WaterPlane plane =
          plane_at(mesh, random.vector(1).normalized(), random.uniform(0.1, 1.2));
      const Matrix6d difference = model.under(plane) - solve_under(mesh, plane, 120).matrix;
      const double error = error_of(difference, mesh, 120);
      sum += error;
      worst = std::max(worst, error);
    }
    EXPECT_LT(sum / kPoses, tolerance(0.024));
    EXPECT_LT(worst, tolerance(2 * 0.024));
  }
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

/// Poses about the surface, from dry to deep.
std::vector<WaterPlane> some_planes(const TriMesh& mesh_B, int count) {
  Random random(6);
  std::vector<WaterPlane> planes;
  for (int i = 0; i < count; ++i)
    planes.push_back(plane_at(mesh_B, random.vector(1).normalized(), random.uniform(-0.1, 3)));
  return planes;
}

TEST(SurfaceAddedMass, IsSymmetricWithoutNegativeEigenvaluesEverywhere) {
  const TriMesh mesh = barge();
  const SurfaceAddedMass model(mesh, {}, kFewPatches);
  for (const WaterPlane& plane : some_planes(mesh, 30)) {
    const Matrix6d A = model.under(plane);
    EXPECT_EQ(A, Matrix6d(A.transpose()));
    const Vector6d values = Eigen::SelfAdjointEigenSolver<Matrix6d>(A).eigenvalues();
    EXPECT_GE(values[0], -1e-12 * values[5]);
  }
}

TEST(SurfaceAddedMass, OrderAndThreadsDoNotMatter) {
  const TriMesh mesh = barge();
  const std::vector<WaterPlane> planes = some_planes(mesh, 24);
  const SurfaceAddedMass one(mesh, {}, kFewPatches), other(mesh, {}, kFewPatches);
  std::vector<Matrix6d> found(planes.size());
  parallel_for(planes.size(), [&](std::size_t i) { found[i] = other.under(planes[i]); });
  for (std::size_t i = planes.size(); i-- > 0;) EXPECT_EQ(one.under(planes[i]), found[i]);
  EXPECT_EQ(one.solves(), other.solves());
}

TEST(SurfaceAddedMass, KnownNodesAreNotSolvedAgain) {
  const TriMesh mesh = barge();
  const std::vector<WaterPlane> planes = some_planes(mesh, 6);
  const SurfaceAddedMass first(mesh, {}, kFewPatches);
  for (const WaterPlane& plane : planes) first.under(plane);
  EXPECT_EQ(first.nodes().size(), static_cast<std::size_t>(first.solves()));
  const SurfaceAddedMass second(mesh, first.nodes(), kFewPatches);
  for (const WaterPlane& plane : planes) EXPECT_EQ(second.under(plane), first.under(plane));
  EXPECT_EQ(second.solves(), 0);
}

// Over 0.2 mm the matrix may change by its slope: it changes by its own size over about a metre.
TEST(SurfaceAddedMass, ChangesWithoutJumps) {
  const TriMesh mesh = barge();
  const SurfaceAddedMass model(mesh, {}, kFewPatches);
  const double scale = model.under({}).norm();
  const Vector3d up = Vector3d(0.3, 0.2, 1).normalized();
  Matrix6d before = model.under(plane_at(mesh, up, 0.95));
  for (int i = 1; i <= 1000; ++i) {
    const Matrix6d A = model.under(plane_at(mesh, up, 0.95 + 1e-4 * i));
    EXPECT_LT((A - before).norm(), tolerance(5e-3 * scale)) << i;
    before = A;
  }
}

// Added mass grows with draught: the potential, taken as 0 above the water, is one that a higher
// surface allows as well. A flat ellipsoid meets the surface at small angles, where the solution
// alone fails. Interpolation keeps it; solutions may break it by their error of 1 %.
TEST(SurfaceAddedMass, HeaveOfAFlatBodyGrowsWithDraught) {
  const TriMesh mesh = make_ellipsoid({2, 2, 0.3}, 48, 24);
  const SurfaceAddedMass model(mesh, {}, 120);
  const double whole = model.under({})(2, 2);
  double before = 0;
  for (int i = 1; i <= 50; ++i) {
    const double heave = model.under(plane_at(mesh, Vector3d::UnitZ(), 0.04 * i))(2, 2);
    EXPECT_GE(heave, before - tolerance(0.01 * whole)) << i;
    EXPECT_LE(heave, (1 + tolerance(0.01)) * whole) << i;
    before = heave;
  }
}

// Beyond all depths there is one node: the body in unbounded fluid.
TEST(SurfaceAddedMass, DeepBodyTendsToTheUnboundedOne) {
  const TriMesh mesh = barge();
  const SurfaceAddedMass model(mesh, {}, kFewPatches);
  const Matrix6d whole = solve_under(mesh, {}, kFewPatches).matrix;
  const Matrix6d deep = model.under({Vector3d(0.6, 0, 0.8), 100});
  EXPECT_LT((deep - whole).norm(), tolerance(1e-4 * whole.norm()));
}

}  // namespace
}  // namespace hydro

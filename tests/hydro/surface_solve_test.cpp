#include "hydro/added_mass/surface_solve.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "hydro/mesh/mass_properties.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

namespace hydro {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using support::Random;
using support::tolerance;

const WaterPlane kWaterline{Vector3d::UnitZ(), 0};
const WaterPlane kUnbounded{};

double largest_difference(const Matrix6d& a, const Matrix6d& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// What the project asks of half-submerged spheres: 1 % of the displaced mass's coefficients 1/2 in
/// heave and 0.2732 in surge (Hulme 1982). It covers the flat triangles: both are about their own
/// displaced volume.
void expect_half_sphere(const TriMesh& sphere) {
  const double displaced = wetted_volume(sphere, kWaterline);
  const Matrix6d A = solve_under(sphere, kWaterline).matrix / displaced;
  EXPECT_NEAR(A(2, 2), 0.5, tolerance(0.01 * 0.5));
  EXPECT_NEAR(A(0, 0), 0.2732, tolerance(0.01 * 0.2732));
  EXPECT_NEAR(A(1, 1), 0.2732, tolerance(0.01 * 0.2732));
}

TEST(SurfaceSolve, HalfSubmergedIcosphereHasTheKnownHeaveAndSurge) {
  expect_half_sphere(make_icosphere(1, 3));
}

TEST(SurfaceSolve, HalfSubmergedFineSphereHasTheKnownHeaveAndSurge) {
  expect_half_sphere(make_sphere(2, 50, 50));
}

// The 16 × 16 sphere is a polyhedron of 4 % less volume. Its coefficients are not the smooth
// sphere's: its rings of flat trapezoids make surge heavier and heave lighter, in unbounded fluid
// too. 2 % is the square of half the angle of its sides, (π/16)²/2, the order of what it lacks.
TEST(SurfaceSolve, CoarseSphereIsRightToTheSizeOfItsFlats) {
  const TriMesh sphere = make_sphere(1, 16, 16);
  const Matrix6d A = solve_under(sphere, kWaterline).matrix / wetted_volume(sphere, kWaterline);
  EXPECT_NEAR(A(2, 2), 0.5, tolerance(0.02 * 0.5));
  EXPECT_NEAR(A(0, 0), 0.2732, tolerance(0.02 * 0.2732));
}

// The exact coefficients in unbounded fluid: sphere 1/2; 2:1:1 spheroid along 0.2100 and across
// 0.7042 (Lamb 1932, art. 115); cube 0.6383. 1 % is what 250 patches are meant to give.
TEST(SurfaceSolve, UnboundedLimitHasTheKnownCoefficients) {
  const TriMesh spheroid = make_ellipsoid({2, 1, 1}, 48, 24);
  const Matrix6d of_spheroid =
      solve_under(spheroid, kUnbounded).matrix / wetted_volume(spheroid, kUnbounded);
  EXPECT_NEAR(of_spheroid(0, 0), 0.2100, tolerance(0.01 * 0.2100));
  EXPECT_NEAR(of_spheroid(2, 2), 0.7042, tolerance(0.01 * 0.7042));
  const Matrix6d of_cube = solve_under(make_box({2, 2, 2}), kUnbounded).matrix / 8;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(of_cube(i, i), 0.6383, tolerance(0.01 * 0.6383));
}

// A rigid heave, roll or pitch about the waterline of the body doubled by its image gives the same
// flow below: the half has half of the double's. In a random pose, so that nothing is along an
// axis. The double has twice the patches, so that they are as large; their errors then differ by
// the random cut of the patches only, well below the 1 % of each. Moments: of the larger one.
TEST(SurfaceSolve, HeaveRollAndPitchAreHalfOfTheDoubledBodys) {
  Random random(1);
  for (const TriMesh& body : {make_ellipsoid({2, 1, 1}, 32, 16), make_box({4, 2, 2})}) {
    const Matrix3d turn = random.rotation().toRotationMatrix();
    const TriMesh turned = transformed(body, Eigen::Isometry3d(turn));
    Matrix6d axes = Matrix6d::Zero();
    axes.topLeftCorner<3, 3>() = axes.bottomRightCorner<3, 3>() = turn;
    const WaterPlane plane{turn.col(2), 0};
    const Matrix6d half = axes.transpose() * solve_under(turned, plane).matrix * axes;
    const Matrix6d whole =
        axes.transpose() * solve_under(turned, kUnbounded, 2 * kSurfacePatches).matrix * axes;
    EXPECT_NEAR(half(2, 2), 0.5 * whole(2, 2), tolerance(0.01 * half(2, 2)));
    const double moment = std::max(half(3, 3), half(4, 4));
    for (const int i : {3, 4}) EXPECT_NEAR(half(i, i), 0.5 * whole(i, i), tolerance(0.01 * moment));
  }
}

// The image in the surface of the sphere's dipole moves with it in heave and against it in surge:
// A = V/2·(1 − 3/8 (R/h)³) and V/2·(1 − 3/16 (R/h)³), with the sign of the wall's image (Lamb 1932,
// art. 138) turned. The next terms, 3 ((R/2h)³)² and those of (R/2h)^5, are below 2e-4 at h = 3 R.
TEST(SurfaceSolve, SphereUnderTheSurfaceFeelsTheImageOfItsDipole) {
  const TriMesh sphere = make_icosphere(1, 3);
  const Matrix6d unbounded = solve_under(sphere, kUnbounded).matrix;
  const double cubed = 1.0 / 27;
  const Matrix6d A = solve_under(sphere, {Vector3d::UnitZ(), 3}).matrix;
  EXPECT_NEAR(A(2, 2) / unbounded(2, 2), 1 - 3.0 / 8 * cubed, tolerance(4e-4));
  EXPECT_NEAR(A(0, 0) / unbounded(0, 0), 1 - 3.0 / 16 * cubed, tolerance(4e-4));
}

// At 30 radii the image is felt by 3/8 · 30⁻³ = 1.4e-5 for a sphere; a body of thrice the added
// mass of its sphere would feel 4e-5.
TEST(SurfaceSolve, DeepBodyTendsToTheUnboundedOne) {
  Random random(2);
  const TriMesh star = support::random_star(random);
  const Matrix6d unbounded = solve_under(star, kUnbounded).matrix;
  const Matrix6d deep = solve_under(star, {random.vector(1).normalized(), 30}).matrix;
  EXPECT_LT(largest_difference(deep, unbounded), tolerance(5e-5 * unbounded.maxCoeff()));
}

// A film of water over a flat top has no potential across it, and so no load: a box just under is
// the same as one with its top in the surface. The film of 1e-4 moves less than that of the load.
TEST(SurfaceSolve, FilmOverAFlatTopChangesNothing) {
  const TriMesh box = make_box({4, 2, 1});
  const Matrix6d awash = solve_under(box, {Vector3d::UnitZ(), 0.5}).matrix;
  const Matrix6d under = solve_under(box, {Vector3d::UnitZ(), 0.5001}).matrix;
  EXPECT_LT(largest_difference(awash, under), tolerance(0.01 * awash.maxCoeff()));
}

// A flat plate's bottom just under the surface has half the added mass of the plate in unbounded
// fluid, 0.4548 side³ for a square one (Brennen 1982). The draught of a fiftieth of the side has
// about as large a part of the plate's own.
TEST(SurfaceSolve, ShallowFlatBottomHasHalfAPlate) {
  const double heave = solve_under(make_box({2, 2, 1}), {Vector3d::UnitZ(), -0.46}).matrix(2, 2);
  EXPECT_NEAR(heave, 0.5 * 0.4548 * 8, tolerance(0.1 * 0.5 * 0.4548 * 8));
}

TEST(SurfaceSolve, DryBodyHasNothing) {
  const Matrix6d A = solve_under(make_box({1, 1, 1}), {Vector3d::UnitZ(), -0.5}).matrix;
  EXPECT_TRUE(A.isZero(0));
}

/// Moved by p and turned by R, A becomes T A Tᵀ.
Matrix6d in_new_frame(const Matrix6d& A, const Eigen::Isometry3d& X) {
  const Vector3d p = X.translation();
  Matrix3d cross;
  cross << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
  Matrix6d T = Matrix6d::Zero();
  T.topLeftCorner<3, 3>() = T.bottomRightCorner<3, 3>() = X.linear();
  T.bottomLeftCorner<3, 3>() = cross * X.linear();
  return T * A * T.transpose();
}

// Patches are cut along the axes of B, so another frame has other patches: the results may differ
// by their error, 1 %.
TEST(SurfaceSolve, AnotherFrameGivesTheSameMatrix) {
  Random random(3);
  const TriMesh star = support::random_star(random);
  const Vector3d up = random.vector(1).normalized();
  const Matrix6d A = solve_under(star, {up, 0.1}).matrix;
  const Eigen::Isometry3d X = support::random_pose(random, 1);
  const Vector3d up_X = X.linear() * up;
  const Matrix6d moved =
      solve_under(transformed(star, X), {up_X, 0.1 + up_X.dot(X.translation())}).matrix;
  const Matrix6d expected = in_new_frame(A, X);
  EXPECT_LT(largest_difference(moved, expected), tolerance(0.01 * expected.maxCoeff()));
}

// 1 % again, from 12 to 7,500 triangles: the patches are as large for all of them.
TEST(SurfaceSolve, MeshOfTheSameSolidMattersLittle) {
  const WaterPlane plane{Vector3d(0.2, 0.1, 1).normalized(), 0.2};
  const Matrix6d coarse = solve_under(make_box({3, 2, 1}), plane).matrix;
  for (const int divisions : {5, 25}) {
    const Matrix6d A = solve_under(make_box({3, 2, 1}, divisions), plane).matrix;
    EXPECT_LT(largest_difference(A, coarse), tolerance(0.01 * coarse.maxCoeff())) << divisions;
  }
}

// In translation the fluid of a cavity moves with the walls: its own mass comes to the outer 1/2.
TEST(SurfaceSolve, FluidOfAClosedCavityMovesWithTheBody) {
  const TriMesh outer = make_icosphere(1, 3), inner = make_icosphere(0.6, 3);
  const TriMesh hollow = support::united(outer, flipped(inner));
  const double expected =
      solve_under(outer, kUnbounded).matrix(0, 0) + wetted_volume(inner, kUnbounded);
  const Matrix6d A = solve_under(hollow, {Vector3d::UnitZ(), 1e3}).matrix;
  // Two shells share the patches of one: the error of 1 % is that of twice as large ones.
  EXPECT_NEAR(A(0, 0), expected, tolerance(0.02 * expected));
}

// The direct equation does not give a symmetric matrix by itself; what it lacks is part of the
// error, and the two motions' errors of up to 1 % need not be alike.
TEST(SurfaceSolve, ReciprocityHoldsToTheErrorOfTheSolution) {
  Random random(4);
  const TriMesh star = support::random_star(random);
  for (const double height : {-0.5, 0.0, 0.5, 1.5}) {
    const SurfaceSolution solution = solve_under(star, {random.vector(1).normalized(), height});
    EXPECT_LT(solution.symmetry_error, tolerance(0.01));
    const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(solution.matrix);
    EXPECT_EQ(solution.matrix, Matrix6d(solution.matrix.transpose()));
    EXPECT_GE(eigen.eigenvalues()[0], -1e-12 * eigen.eigenvalues()[5]);
  }
}

}  // namespace
}  // namespace hydro

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>

#include "hydro/added_mass.h"
#include "hydro/mass_properties.h"
#include "hydro/primitives.h"
#include "hydro/weld.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

/// Added mass against exact values and the transformations of a body.

namespace {

using Eigen::Matrix3d;
using hydro::AddedMassMethod;
using hydro::Matrix6d;

double volume(const hydro::TriMesh& mesh) { return hydro::solid_properties(mesh).volume; }

/// Mean of the three translations over the volume: the orientation-free coefficient.
double coefficient(const hydro::TriMesh& mesh) {
  const Matrix6d A = hydro::solve_added_mass(mesh).matrix;
  return A.topLeftCorner<3, 3>().trace() / 3 / volume(mesh);
}

TEST(AddedMass, OfACubeOfTwelveTrianglesIsThatOfTheCube) {
  const Matrix6d A = hydro::solve_added_mass(hydro::make_box({2, 2, 2})).matrix;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(A(i, i) / 5.1073, 1, support::tolerance(2e-3));
  // Rotation about an edge-bound axis converges more slowly than translation.
  for (int i = 3; i < 6; ++i) EXPECT_NEAR(A(i, i) / 1.2564, 1, support::tolerance(8e-3));
}

TEST(AddedMass, OfASphereIsHalfOfTheDisplacedMass) {
  EXPECT_NEAR(coefficient(hydro::make_icosphere(1, 3)), 0.5, support::tolerance(1e-4));
}

TEST(AddedMass, OfAnEllipsoidIsLambs) {
  // Polyhedra inscribed in the ellipsoid: their volume counts, their shape errs to second order.
  const hydro::TriMesh mesh = hydro::make_ellipsoid({3, 2, 1}, 32, 32);
  const Matrix6d A = hydro::solve_added_mass(mesh).matrix / volume(mesh);
  EXPECT_NEAR(A(0, 0), 0.185256, support::tolerance(5e-3) * 0.185256);
  EXPECT_NEAR(A(1, 1), 0.364543, support::tolerance(5e-3) * 0.364543);
  EXPECT_NEAR(A(2, 2), 1.361527, support::tolerance(5e-3) * 1.361527);
}

TEST(AddedMass, OfATetrahedronFollowsFromItsFourTriangles) {
  const hydro::TriMesh corner = support::corner_tetrahedron({1, 1, 1});
  // Alternate corners of a cube make the regular one.
  hydro::TriMesh mesh = corner;
  mesh.vertices.col(0) << 0, 0, 0;
  mesh.vertices.col(1) << 1, 1, 0;
  mesh.vertices.col(2) << 0, 1, 1;
  mesh.vertices.col(3) << 1, 0, 1;
  if (volume(mesh) < 0) mesh = hydro::flipped(mesh);
  mesh = hydro::translated(mesh, -hydro::solid_properties(mesh).centroid);
  EXPECT_NEAR(coefficient(mesh) / 0.80708, 1, support::tolerance(5e-3));
}

Matrix6d both(const Matrix3d& m) {
  Matrix6d blocks = Matrix6d::Zero();
  blocks.topLeftCorner<3, 3>() = blocks.bottomRightCorner<3, 3>() = m;
  return blocks;
}

/// How far A of a mesh turned and scaled by 1.7 is from the transformed A, relative.
double transformation_error(const hydro::TriMesh& mesh, AddedMassMethod method,
                            const Matrix3d& turn) {
  const double s = 1.7;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = turn;
  const Matrix6d A = hydro::solve_added_mass(mesh, {.method = method}).matrix;
  const Matrix6d moved =
      hydro::solve_added_mass(hydro::scaled(hydro::transformed(mesh, X), s), {.method = method})
          .matrix;
  Matrix6d T = both(turn);
  T.bottomRows<3>() *= s;
  return (moved - s * s * s * T * A * T.transpose()).norm() / moved.norm();
}

TEST(AddedMass, TurnsAndScalesWithTheBody) {
  support::Random random(61);
  const hydro::TriMesh mesh = support::random_star(random, 1);
  const Matrix3d turn = random.rotation().toRotationMatrix();
  EXPECT_LT(transformation_error(mesh, AddedMassMethod::constant, turn), support::tolerance(1e-10));
  // Where the panels of its own are split is decided by sizes that may tie: within the tolerance.
  EXPECT_LT(transformation_error(mesh, AddedMassMethod::linear, turn), support::tolerance(1e-3));
}

TEST(AddedMass, IsSymmetricAndTakesWorkForEveryMotion) {
  support::Random random(62);
  const auto solution = hydro::solve_added_mass(support::random_star(random, 1));
  EXPECT_EQ(solution.matrix, solution.matrix.transpose());
  EXPECT_LT(solution.symmetry_error, 1e-2);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix6d>(solution.matrix).eigenvalues()[0], 0);
}

TEST(AddedMass, SharesOfTheFacesAddUpToTheWhole) {
  support::Random random(63);
  const hydro::TriMesh mesh = support::random_star(random, 1);
  const auto solution = hydro::solve_added_mass(mesh);
  Matrix6d sum = Matrix6d::Zero();
  for (Eigen::Index face = 0; face < mesh.face_count(); ++face) {
    std::array<Eigen::Vector3d, 3> corners;
    for (int i = 0; i < 3; ++i) corners[i] = mesh.vertices.col(mesh.faces(i, face));
    sum += hydro::triangle_share(corners, solution.potentials[face]);
  }
  EXPECT_LT((sum - solution.matrix).norm(), 1e-2 * solution.matrix.norm());
}

/// A 2 m cube of 12·n² triangles whose diagonals run the same way on opposite sides.
hydro::TriMesh evenly_cut_cube(int n) {
  hydro::TriMesh mesh{Eigen::Matrix3Xd(3, 36 * n * n), Eigen::Matrix3Xi(3, 12 * n * n)};
  int corner = 0;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1 : -1;
    const auto point = [&](int i, int j) {
      Eigen::Vector3d p;
      p[axis] = sign;
      p[(axis + 1) % 3] = 2.0 * i / n - 1;
      p[(axis + 2) % 3] = 2.0 * j / n - 1;
      return p;
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const Eigen::Vector3d b = sign > 0 ? point(i + 1, j) : point(i, j + 1);
        const Eigen::Vector3d d = sign > 0 ? point(i, j + 1) : point(i + 1, j);
        for (const Eigen::Vector3d& p :
             {point(i, j), b, point(i + 1, j + 1), point(i, j), point(i + 1, j + 1), d})
          mesh.vertices.col(corner++) = p;
      }
    }
  }
  for (Eigen::Index k = 0; k < mesh.faces.size(); ++k)
    mesh.faces(k % 3, k / 3) = static_cast<int>(k);
  return hydro::welded(mesh, 1e-9);
}

TEST(AddedMass, ByConstantPanelsIsThatOfTheThesissMethod) {
  // Collocation with closed-form integrals, per unit density; the values of an independent program.
  const double values[] = {6.99079533, 5.96495558, 5.49603180, 5.28007011};
  for (int i = 0; i < 4; ++i) {
    const Matrix6d A =
        hydro::solve_added_mass(evenly_cut_cube(1 << i), {.method = AddedMassMethod::constant})
            .matrix;
    const double mean = A.topLeftCorner<3, 3>().trace() / 3;
    EXPECT_NEAR(mean, values[i], 1e-6) << i;
  }
}

TEST(AddedMass, OfAnOpenMeshIsRefused) {
  hydro::TriMesh mesh = hydro::make_box({1, 1, 1});
  mesh.faces.conservativeResize(3, 11);
  EXPECT_THROW(hydro::solve_added_mass(mesh), std::invalid_argument);
}

}  // namespace

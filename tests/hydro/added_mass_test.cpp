#include "hydro/added_mass/added_mass.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "hydro/added_mass/bem/galerkin.h"
#include "hydro/added_mass/bem/surface.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "hydro/mesh/weld.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::AddedMassMethod;
using hydro::AddedMassSolution;
using hydro::Matrix6d;
using hydro::TriMesh;
using support::tolerance;
namespace bem = hydro::bem;

TriMesh centred(const TriMesh& mesh) {
  return hydro::translated(mesh, -hydro::solid_properties(mesh).centroid);
}

/// A cube of 2 m whose faces' diagonals all run the same way.
TriMesh plain_cube(int divisions) {
  TriMesh mesh = hydro::make_box({2, 2, 2}, 1);
  mesh = {Eigen::Matrix3Xd(3, 24 * divisions * divisions),
          Eigen::Matrix3Xi(3, 12 * divisions * divisions)};
  const double h = 2.0 / divisions;
  int face = 0, vertex = 0;
  for (int side = 0; side < 6; ++side) {
    const Vector3d n = (side < 3 ? 1 : -1) * Vector3d::Unit(side % 3);
    Vector3d u = Vector3d::Unit((side + 1) % 3), v = Vector3d::Unit((side + 2) % 3);
    if (side >= 3) std::swap(u, v);
    for (int i = 0; i < divisions; ++i) {
      for (int j = 0; j < divisions; ++j, vertex += 4, face += 2) {
        const Vector3d corner = n - u.cwiseAbs() - v.cwiseAbs() + h * (i * u + j * v);
        mesh.vertices.col(vertex) = corner;
        mesh.vertices.col(vertex + 1) = corner + h * u;
        mesh.vertices.col(vertex + 2) = corner + h * (u + v);
        mesh.vertices.col(vertex + 3) = corner + h * v;
        mesh.faces.col(face) << vertex, vertex + 1, vertex + 2;
        mesh.faces.col(face + 1) << vertex, vertex + 2, vertex + 3;
      }
    }
  }
  return hydro::welded(mesh, 1e-9);
}

/// The largest difference of two matrices over the largest element of the first.
double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff();
}

TEST(AddedMassSolve, OfPartsFarApartIsTheirSum) {
  const TriMesh ball = hydro::make_icosphere(1, 2);
  const TriMesh pair =
      support::united(hydro::translated(ball, {100, 0, 0}), hydro::translated(ball, {-100, 0, 0}));
  const Matrix6d one = hydro::solve_added_mass(ball, {.tolerance = 1}).matrix;
  const Matrix6d both = hydro::solve_added_mass(pair, {.tolerance = 1}).matrix;
  // What one ball feels of the other falls with the cube of the distance, 200 m.
  EXPECT_LT(difference(2 * one.topLeftCorner<3, 3>(), both.topLeftCorner<3, 3>()), tolerance(1e-6));
  EXPECT_NEAR(both(5, 5), 1e4 * both(1, 1), tolerance(1e-5) * both(5, 5));
}

TEST(AddedMassSolve, OfTheWaterInACavityIsItsMass) {
  const TriMesh ball = hydro::make_icosphere(1, 2);
  const TriMesh cavity = hydro::make_box({0.8, 0.6, 0.5}, 2);
  const TriMesh hollow = support::united(ball, hydro::flipped(cavity));
  const hydro::AddedMassOptions rough = {.tolerance = 1};
  const Matrix6d solid = hydro::solve_added_mass(ball, rough).matrix;
  const AddedMassSolution solution = hydro::solve_added_mass(hollow, rough);
  const Eigen::Matrix3d gained =
      solution.matrix.topLeftCorner<3, 3>() - solid.topLeftCorner<3, 3>();
  // In translation ψ is −x + constant in there: linear, so only round-off is left, and what the
  // iteration leaves of the solid's own part.
  EXPECT_LT((gained - 0.24 * Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), tolerance(1e-7));
}

TEST(AddedMassSolve, TurnsAndGrowsWithItsMesh) {
  support::Random random(11);
  const TriMesh mesh = centred(support::corner_tetrahedron({1, 1.3, 1.7}));
  const hydro::AddedMassOptions options = {.tolerance = 1e-6, .most_panels = 600};
  const Matrix6d matrix = hydro::solve_added_mass(mesh, options).matrix;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = random.rotation().toRotationMatrix();
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = X.linear();
  const Matrix6d turned = hydro::solve_added_mass(hydro::transformed(mesh, X), options).matrix;
  EXPECT_LT(difference(turn * matrix * turn.transpose(), turned), tolerance(1e-10));
  hydro::Vector6d growth;
  growth << Vector3d::Constant(std::pow(3.0, 1.5)), Vector3d::Constant(std::pow(3.0, 2.5));
  const Matrix6d grown = hydro::solve_added_mass(hydro::scaled(mesh, 3), options).matrix;
  EXPECT_LT(difference(growth.asDiagonal() * matrix * growth.asDiagonal(), grown),
            tolerance(1e-10));
}

TEST(AddedMassSolve, AboutAnotherPointFollowsByTheMotionThere) {
  const TriMesh mesh = centred(support::corner_tetrahedron({1, 1.3, 1.7}));
  const hydro::AddedMassOptions options = {.tolerance = 1, .most_panels = 100};
  const Vector3d offset(0.4, -0.3, 0.8);
  Eigen::Matrix3d cross;
  cross << 0, -offset.z(), offset.y(), offset.z(), 0, -offset.x(), -offset.y(), offset.x(), 0;
  // A turn about the new origin moves the old one by e × offset.
  Matrix6d motion = Matrix6d::Identity();
  motion.topRightCorner<3, 3>() = -cross;
  TriMesh finer = mesh;
  const Matrix6d here = hydro::solve_added_mass(finer, options).matrix;
  const Matrix6d there = hydro::solve_added_mass(hydro::translated(finer, offset), options).matrix;
  EXPECT_LT(difference(motion.transpose() * here * motion, there), tolerance(1e-10));
}

TEST(AddedMassSolve, IsSymmetricAndNotNegative) {
  support::Random random(5);
  for (int k = 0; k < 3; ++k) {
    const TriMesh mesh = centred(support::random_star(random, 1));
    const AddedMassSolution solution =
        hydro::solve_added_mass(mesh, {.tolerance = 1e-3, .most_panels = 1200});
    EXPECT_LT(solution.symmetry_error, solution.error_estimate);
    const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(solution.matrix);
    EXPECT_GT(eigen.eigenvalues().minCoeff(), -tolerance(1e-6));
  }
}

TEST(AddedMassSolve, IsTheSumOfTheSharesOfTheFaces) {
  const TriMesh mesh = centred(support::corner_tetrahedron({1, 1.3, 1.7}));
  const AddedMassSolution solution =
      hydro::solve_added_mass(mesh, {.tolerance = 1e-6, .most_panels = 500});
  Matrix6d sum = Matrix6d::Zero();
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    const std::array<Vector3d, 3> corners = {mesh.vertices.col(mesh.faces(0, f)),
                                             mesh.vertices.col(mesh.faces(1, f)),
                                             mesh.vertices.col(mesh.faces(2, f))};
    sum += hydro::triangle_share(corners, solution.potentials[static_cast<std::size_t>(f)]);
  }
  // By symmetry the sum is the matrix to what Galerkin's method leaves of it.
  EXPECT_LT(difference(solution.matrix, 0.5 * (sum + sum.transpose())), tolerance(1e-12));
}

TEST(AddedMassSolve, OfHalfASphereIsHalfOfTheSpheres) {
  // The constant in ψ counts for a part of the surface: on a sphere ψ_m is x_m / 2.
  const TriMesh mesh = hydro::make_icosphere(1, 3);
  const AddedMassSolution solution = hydro::solve_added_mass(mesh);
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const Vector3d at = mesh.vertices.col(mesh.faces(i, f));
      const Vector3d psi = solution.potentials[static_cast<std::size_t>(f)].col(i).head<3>();
      EXPECT_LT((psi - at / 2).norm(), tolerance(5e-3));  // facets of 0.15 m
    }
  }
}

TEST(AddedMassSolve, BySlowConstantPanelsIsThatOfThatMethod) {
  // With the integrals in closed form; the exact value is 5107.3.
  const std::vector<std::pair<int, double>> known = {
      {1, 6990.79533}, {2, 5964.95558}, {4, 5496.03180}, {8, 5280.07011}};
  for (const auto& [divisions, mass] : known) {
    const AddedMassSolution solution =
        hydro::solve_added_mass(plain_cube(divisions), {.method = AddedMassMethod::constant});
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(1000 * solution.matrix(i, i), mass, tolerance(1e-5)) << divisions;
  }
}

/// Triangles of very different sizes and shapes on the same cube.
TEST(AddedMassSolve, DoesNotDependOnTheMeshOfTheBody) {
  const hydro::AddedMassOptions options = {.tolerance = 2e-3};
  const Matrix6d coarse = hydro::solve_added_mass(hydro::make_box({2, 2, 2}), options).matrix;
  TriMesh uneven = plain_cube(4);
  // Vertices within faces and edges are drawn towards one corner.
  uneven.vertices =
      uneven.vertices.unaryExpr([](double x) { return -1 + 2 * std::pow((x + 1) / 2, 2.5); });
  const Matrix6d other = hydro::solve_added_mass(uneven, options).matrix;
  EXPECT_LT(difference(coarse, other), tolerance(1e-3));
}

TEST(AddedMassSolve, OfACylinderOfSliversKeepsToItsBar) {
  // The same prism from slivers and from well-shaped triangles.
  const auto slivers =
      hydro::solve_added_mass(hydro::make_cylinder(1, 2, 24, 1), {.tolerance = 1e-2});
  const auto even = hydro::solve_added_mass(hydro::make_cylinder(1, 2, 24, 6), {.tolerance = 2e-3});
  EXPECT_LT(difference(even.matrix, slivers.matrix), slivers.error_estimate + even.error_estimate);
  EXPECT_LT(slivers.error_estimate, tolerance(2e-2));
}

TEST(AddedMassSolve, IsBracketedByBothMethods) {
  const TriMesh mesh = plain_cube(4);
  const double above =
      hydro::solve_added_mass(mesh, {.method = AddedMassMethod::constant}).matrix(0, 0);
  const double between = hydro::solve_added_mass(mesh).matrix(0, 0);
  EXPECT_GT(above, 5.1073);
  EXPECT_NEAR(between, 5.1073, tolerance(2e-3) * 5.1073);
}

TEST(AddedMassSolve, OfAnOpenOrInwardMeshIsRefused) {
  TriMesh open = hydro::make_icosphere(1, 1);
  open.faces.conservativeResize(3, open.face_count() - 1);
  EXPECT_THROW(hydro::solve_added_mass(open), std::invalid_argument);
  const TriMesh inward = hydro::flipped(hydro::make_icosphere(1, 1));
  EXPECT_THROW(hydro::solve_added_mass(inward), std::invalid_argument);
}

TEST(Galerkin, ConvergesOnASphereFasterThanItsPanelsShrink) {
  std::vector<double> errors;
  for (const int subdivisions : {1, 2, 3}) {
    const bem::Surface surface = bem::make_surface(hydro::make_icosphere(1, subdivisions));
    const bem::Potential psi = bem::solve_dense(surface).psi;
    double volume = 0;
    for (const bem::Element& element : surface.elements)
      volume += element.area * element.centroid.dot(element.normal) / 3;
    errors.push_back(std::abs(psi.col(0).dot(bem::loads_on(surface).col(0)) / volume - 0.5));
  }
  // A polyhedron's added mass is off its ball's by order 3 in the edges.
  EXPECT_GT(errors[0] / errors[1], 5);
  EXPECT_GT(errors[1] / errors[2], 5);
  EXPECT_LT(errors[2], tolerance(1e-4));
}

TEST(AnchoredPotential, ForgetsTheConstantItWasGiven) {
  support::Random random(14);
  // The centroid is inside a box, beside a ring.
  for (const TriMesh& mesh : {hydro::make_box({3, 2, 1}, 2), support::make_torus(1, 0.3, 12, 8)}) {
    const bem::Surface surface = bem::make_surface(mesh);
    const bem::Potential psi = bem::solve_dense(surface).psi;
    bem::Potential shifted = psi;
    for (Eigen::Index m = 0; m < 6; ++m)
      shifted.col(m).head(surface.vertex_count()).array() += random.uniform(-9, 9);
    // Round-off of some hundred solid angles.
    EXPECT_LT((bem::with_far_field_constants(surface, shifted) -
               bem::with_far_field_constants(surface, psi))
                  .norm(),
              tolerance(1e-12) * shifted.norm());
  }
}

TEST(AnchoredPotential, VanishesFarAwayWhereverTheBodyIs) {
  const Vector3d apart(0.3, -0.7, 0.2);
  const bem::Surface surface =
      bem::make_surface(hydro::translated(hydro::make_icosphere(1, 2), apart));
  const bem::Potential psi = bem::with_far_field_constants(surface, bem::solve_dense(surface).psi);
  // At opposite vertices ψ of a translation is opposite: what is left is round-off.
  EXPECT_LT(psi.topLeftCorner(surface.vertex_count(), 3).colwise().mean().norm(), tolerance(1e-13));
}

TEST(Galerkin, GainsWhatItSaysItLacks) {
  // On coarse panels the error estimate covers what panels halved twice and more change.
  const bem::Surface coarse = bem::make_surface(hydro::make_box({2, 2, 2}, 4));
  const bem::Solution solution = bem::solve_dense(coarse);
  const hydro::Matrix6d matrix = solution.psi.transpose() * bem::loads_on(coarse);
  EXPECT_NEAR(matrix(0, 0), 5.1073, solution.error_estimate(0, 0));
  EXPECT_NEAR(matrix(4, 4), 1.2564, solution.error_estimate(4, 4));
}

/// The mesh with all edges halved.
TriMesh halved(const TriMesh& mesh) {
  const bem::Edges edges = bem::edges_of(mesh);
  const std::vector<int> parent(static_cast<std::size_t>(mesh.face_count()));
  return bem::bisected({mesh, parent}, edges, std::vector<bool>(edges.faces.size(), true)).mesh;
}

TEST(Split, OfFacesWithoutALongestEdgeIsInFourAlike) {
  const TriMesh mesh = hydro::make_icosphere(1, 0);
  const TriMesh finer = halved(mesh);
  ASSERT_EQ(finer.face_count(), 4 * mesh.face_count());
  const double length = bem::make_elements(mesh)[0].lengths[0];
  for (const bem::Element& element : bem::make_elements(finer))
    for (const double part : element.lengths) EXPECT_NEAR(part, length / 2, tolerance(1e-14));
}

}  // namespace

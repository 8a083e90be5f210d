#include <gtest/gtest.h>

#include <cmath>

#include "hydro/added_mass/added_mass.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

/// @file
/// Added mass against exact values, from meshes as users give them, at the default tolerance.

namespace {

using hydro::Matrix6d;
using hydro::TriMesh;
using support::tolerance;

double volume_of(const TriMesh& mesh) { return hydro::solid_properties(mesh).volume; }

Matrix6d added_mass(const TriMesh& mesh) { return hydro::solve_added_mass(mesh).matrix; }

/// An icosphere stretched along the axes: 1,280 triangles.
TriMesh smooth_ellipsoid(const Eigen::Vector3d& semi_axes) {
  TriMesh mesh = hydro::make_icosphere(1, 3);
  mesh.vertices = semi_axes.asDiagonal() * mesh.vertices;
  return mesh;
}

/// Added mass of an ellipsoid's mesh over V, and over V m^2 for turns, enlarged to the volume V of
/// the smooth body.
hydro::Vector6d coefficients(const TriMesh& mesh, double smooth_volume) {
  const double volume = volume_of(mesh), length = std::cbrt(smooth_volume / volume);
  hydro::Vector6d scales = hydro::Vector6d::Constant(1 / volume);
  scales.tail<3>() *= length * length;
  return added_mass(mesh).diagonal().cwiseProduct(scales);
}

TEST(AddedMass, OfACubeOfTwelveTrianglesIsThatOfTheCube) {
  const Matrix6d A = added_mass(hydro::make_box({2, 2, 2}));
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(A(i, i) / 5.1073, 1, tolerance(2e-3));
    EXPECT_NEAR(A(3 + i, 3 + i) / 1.2564, 1, tolerance(2e-3));
  }
}

TEST(AddedMass, OfEllipsoidsIsLambs) {
  // The polyhedron departs from its ellipsoid by 1e-4 (an icosphere from its ball: the same mesh).
  const double off = tolerance(1e-3);
  const auto two = coefficients(smooth_ellipsoid({2, 1, 1}), 8 * M_PI / 3);
  EXPECT_NEAR(two[0] / 0.210015, 1, off);
  EXPECT_NEAR(two[1] / 0.704210, 1, off);
  EXPECT_NEAR(two[2] / 0.704210, 1, off);
  EXPECT_NEAR(two[3], 0, off * 0.24);
  EXPECT_NEAR(two[4] / 0.239424, 1, off);
  const auto three = coefficients(smooth_ellipsoid({3, 2, 1}), 8 * M_PI);
  EXPECT_NEAR(three[0] / 0.185256, 1, off);
  EXPECT_NEAR(three[1] / 0.364543, 1, off);
  EXPECT_NEAR(three[2] / 1.361527, 1, off);
  // About the axis a, with the coefficients of the other two: k = γ/(2 − γ).
  const double beta = 2 * 0.364543 / 1.364543, gamma = 2 * 1.361527 / 2.361527;
  const double roll = 9 * (gamma - beta) / (6 - 5 * (gamma - beta)) / 5;
  EXPECT_NEAR(three[3] / roll, 1, off);
}

TEST(AddedMass, OfACylinderIsThatOfTheRoundOne) {
  const TriMesh mesh = hydro::make_cylinder(1, 2, 64, 8);  // 1,920 triangles
  const Matrix6d A = added_mass(mesh) * (2 * M_PI / volume_of(mesh));
  EXPECT_NEAR(A(0, 0) / 3.63982, 1, tolerance(3e-3));
  EXPECT_NEAR(A(2, 2) / 3.67796, 1, tolerance(3e-3));
  EXPECT_NEAR(A(3, 3) / 0.80990, 1, tolerance(3e-3));
}

TEST(AddedMass, OfATorusIsThatOfTheSmoothOne) {
  // 2,016 triangles, the tube so much thicker that the mesh has the volume of the smooth torus.
  const double volume = 2 * M_PI * M_PI * 0.09;
  double tube = 0.3;
  for (int i = 0; i < 4; ++i)
    tube *= std::sqrt(volume / volume_of(support::make_torus(1, tube, 56, 18)));
  const Matrix6d A = added_mass(support::make_torus(1, tube, 56, 18));
  EXPECT_NEAR(A(0, 0) / 0.79117, 1, tolerance(3e-3));
  EXPECT_NEAR(A(2, 2) / 1.83834, 1, tolerance(3e-3));
  EXPECT_NEAR(A(3, 3) / 0.77990, 1, tolerance(3e-3));
}

}  // namespace

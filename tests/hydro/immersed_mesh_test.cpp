#include "hydro/statics/immersed_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using hydro::Hydrostatics;
using hydro::ImmersedMesh;
using hydro::TriMesh;

double height_of(const TriMesh& mesh, double volume) {
  return ImmersedMesh(mesh).afloat(Matrix3d::Identity(), volume).height;
}

/// Largest difference of two results, each over its own size for a body of radius `r`.
double difference(const Hydrostatics& a, const Hydrostatics& b, double r) {
  return std::max(
      {std::abs(a.volume - b.volume) / (r * r * r),
       std::abs(a.wetted_surface - b.wetted_surface) / (r * r),
       // Moments of the volume: the centre of a small one is less sure.
       (a.volume * a.centre_of_buoyancy - b.volume * b.centre_of_buoyancy).norm() / std::pow(r, 4),
       std::abs(a.waterplane.area - b.waterplane.area) / (r * r),
       (a.waterplane.second_moment - b.waterplane.second_moment).norm() / std::pow(r, 4)});
}

/// Compares with the plain sums over all faces in random attitudes, from wholly wet to dry.
void expect_the_plain_sums(const TriMesh& mesh) {
  const ImmersedMesh immersed(mesh);
  const double r = mesh.vertices.colwise().norm().maxCoeff();
  support::Random random(7);
  for (int i = 0; i < 40; ++i) {
    const Matrix3d R_WB = random.rotation().toRotationMatrix();
    const double height = random.uniform(-1.1, 1.1) * r;
    const TriMesh mesh_G{R_WB * mesh.vertices, mesh.faces};
    // Round-off of sums of up to 20,000 terms.
    EXPECT_LT(difference(immersed.at(R_WB, height), hydro::hydrostatics(mesh_G, height), r),
              support::tolerance(1e-13))
        << i;
    EXPECT_NEAR(immersed.lowest(R_WB), mesh_G.vertices.row(2).minCoeff(), 1e-15 * r);
  }
}

TEST(ImmersedMesh, HasThePlainSumsInAnyAttitude) {
  expect_the_plain_sums(hydro::make_box({4, 2, 1}, 2));
  expect_the_plain_sums(hydro::translated(support::make_torus(2, 0.5, 60, 30), {3, -1, 0.5}));
  TriMesh ellipsoid = hydro::make_icosphere(1, 5);
  ellipsoid.vertices.row(0) *= 6;
  expect_the_plain_sums(ellipsoid);
}

TEST(ImmersedMesh, ClosesItsWaterlineThroughVertices) {
  // Rings of vertices and whole faces lie in the surface: whatever is wet, no edge is lost.
  const TriMesh box = hydro::make_box({4, 2, 1}, 8);
  const ImmersedMesh immersed(box);
  for (const double height : {-0.5, -0.375, -0.25, 0.0, 0.125, 0.375}) {
    const Hydrostatics h = immersed.at(Matrix3d::Identity(), height);
    EXPECT_NEAR(h.volume, 8 * (0.5 - height), support::tolerance(1e-13)) << height;
    // A deck in the surface is dry, and the waterplane is what the deck bounds.
    EXPECT_NEAR(h.waterplane.area, 8, support::tolerance(1e-13)) << height;
  }
  EXPECT_EQ(immersed.at(Matrix3d::Identity(), 0.5).volume, 0);
}

TEST(FloatingHeight, DisplacesWhatIsAskedOverTwelveDecades) {
  support::Random random(65);
  const TriMesh mesh = support::random_star(random);
  const double whole = hydro::solid_properties(mesh).volume;
  for (const double part : {1e-12, 1e-6, 1e-3, 0.1, 0.5, 0.9, 0.999, 1 - 1e-9}) {
    const double height = height_of(mesh, part * whole);
    const double lowest = mesh.vertices.row(2).minCoeff();
    // A height has 1e-16 of the body's size, which a thin tip feels as much more of its volume.
    const double felt = 3e-16 / (std::abs(lowest + height) * part) * (part < 0.1 ? 3 * part : 1);
    EXPECT_NEAR(hydro::hydrostatics(mesh, height).volume / (part * whole), 1,
                support::tolerance(std::max(felt, 1e-14)));
  }
}

TEST(FloatingHeight, IsFoundWhereTheWaterplaneJumps) {
  // A plate on a thin column on a plate: the waterplane jumps by a factor of 10,000 twice.
  const TriMesh plate = hydro::make_box({1, 1, 0.1});
  const TriMesh stack = support::united(
      support::united(hydro::translated(plate, {0, 0, -0.55}), hydro::make_box({0.01, 0.01, 1})),
      hydro::translated(plate, {0, 0, 0.55}));
  for (const double volume : {0.05, 0.1, 0.1 + 1e-12, 0.10005, 0.1001, 0.1001 + 1e-12, 0.15}) {
    const double height = height_of(stack, volume);
    // The area of 1 m^2 times the last digit of the height.
    EXPECT_NEAR(hydro::hydrostatics(stack, height).volume, volume, support::tolerance(3e-16));
  }
}

TEST(FloatingHeight, LiesInAGapBetweenPartsThatDisplaceExactlyTheirShare) {
  const TriMesh box = hydro::make_box({1, 1, 1});
  const TriMesh parts = support::united(hydro::translated(box, {0, 0, 2}), box);
  const double height = height_of(parts, 1);
  EXPECT_NEAR(hydro::hydrostatics(parts, height).volume, 1, support::tolerance(1e-13));
}

TEST(FloatingHeight, IsRefusedToWhatSinksOrWeighsNothing) {
  const TriMesh box = hydro::make_box({1, 1, 1});
  for (const double volume : {-1.0, 0.0, 1.0, 2.0, std::nan("")})
    EXPECT_THROW(height_of(box, volume), std::invalid_argument) << volume;
}

}  // namespace

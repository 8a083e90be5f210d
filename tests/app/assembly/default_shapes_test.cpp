#include <gtest/gtest.h>

#include "app/assembly/build.h"
#include "hydro/added_mass/added_mass.h"
#include "hydro/mesh/mass_properties.h"
#include "tests/app/scene_text.h"

/// The meshes of round shapes without counts of their own, against the smooth shapes.

namespace {

/// Largest number of triangles: the added mass of more takes seconds to solve.
constexpr int kMostTriangles = 2000;
/// Errors of volume and added mass by the flat faces, over those of the smooth shape.
constexpr double kVolumeError = 0.009, kAddedMassError = 0.011;

hydro::TriMesh mesh_of(const std::string& shape) {
  return assembly::build_without_added_mass(
             support::read_scene_text("plimsoll: 1\nduration: 1\nwater: {}\nbodies:\n"
                                      "  - {name: body, density: 500, " +
                                      shape + "}\n"))
      .spec.bodies[0]
      .mesh_B;
}

double volume_of(const hydro::TriMesh& mesh) { return hydro::solid_properties(mesh).volume; }

TEST(DefaultSphere, HasTheVolumeAndAddedMassOfASmoothOneWithinAHundredth) {
  const double radius = 0.3, ball = 4 * M_PI / 3 * radius * radius * radius;
  for (const std::string shape : {"sphere", "icosphere"}) {
    SCOPED_TRACE(shape);
    const hydro::TriMesh mesh = mesh_of(shape + ": {radius: 0.3}");
    EXPECT_LE(mesh.face_count(), kMostTriangles);
    EXPECT_NEAR(volume_of(mesh), ball, kVolumeError * ball);
    const hydro::Matrix6d A = hydro::solve_added_mass(mesh, {}).matrix;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(A(i, i), ball / 2, kAddedMassError * ball / 2) << i;
  }
}

TEST(DefaultEllipsoid, HasTheVolumeOfASmoothOneWithinAHundredth) {
  const hydro::TriMesh mesh = mesh_of("ellipsoid: {semi_axes: [1, 2, 3]}");
  EXPECT_LE(mesh.face_count(), kMostTriangles);
  EXPECT_NEAR(volume_of(mesh), 8 * M_PI, kVolumeError * 8 * M_PI);
}

}  // namespace

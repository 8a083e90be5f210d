#include "hydro/mesh/terrain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "hydro/mesh/mesh_check.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using hydro::HeightField;
using hydro::TriMesh;

HeightField random_field(int rows, int columns, unsigned seed) {
  support::Random random(seed);
  HeightField field{Eigen::MatrixXd(rows, columns), 0.5, {-3, 7}};
  for (double& height : field.heights.reshaped()) height = random.uniform(-1, 1);
  return field;
}

TEST(Terrain, VerticesAreTheFieldsPointsWithRowsAlongY) {
  const HeightField field = random_field(4, 6, 1);
  const TriMesh mesh = terrain_mesh(field);
  ASSERT_EQ(mesh.vertex_count(), 24);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 6; ++j)
      EXPECT_EQ(mesh.vertices.col(i * 6 + j),
                Eigen::Vector3d(-3 + 0.5 * j, 7 + 0.5 * i, field.heights(i, j)));
}

TEST(Terrain, EveryFaceLooksUpAndTogetherTheyCoverTheGridOnce) {
  const TriMesh mesh = terrain_mesh(random_field(4, 6, 2));
  EXPECT_EQ(mesh.face_count(), 2 * 3 * 5);
  double plan_area = 0;
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    const double plan = area_vector(mesh, f).z();
    EXPECT_GT(plan, 0);
    plan_area += plan;
  }
  EXPECT_NEAR(plan_area, 15 * 0.25, support::tolerance(1e-14));  // 30 terms, round-off
}

TEST(Terrain, OnlyTheRimIsOpen) {
  const hydro::MeshReport report = check_mesh(terrain_mesh(random_field(4, 6, 3)));
  EXPECT_EQ(report.open_edges.count, 2 * (3 + 5));
  EXPECT_EQ(report.crowded_edges.count, 0);
  EXPECT_EQ(report.misoriented_edges.count, 0);
  EXPECT_EQ(report.self_overlaps.count, 0);
}

TEST(Terrain, DepartsFromTheBilinearSurfaceByAtMostAQuarterOfTheTwist) {
  HeightField field{Eigen::MatrixXd::Zero(2, 2), 1, {0, 0}};
  field.heights(1, 1) = 1;  // twist 1; the bilinear surface is at 1/4 in the middle
  const TriMesh mesh = terrain_mesh(field);
  // The cut runs from (0, 0) to (1, 1), so the mesh is at 1/2 there.
  EXPECT_EQ(mesh.face_count(), 2);
  for (int f = 0; f < 2; ++f) {
    bool low = false, high = false;
    for (const int v : mesh.faces.col(f)) {
      low = low || v == 0;
      high = high || v == 3;
    }
    EXPECT_TRUE(low && high);
  }
}

TEST(Terrain, AFieldThatSpansNoCellIsRefused) {
  EXPECT_THROW(terrain_mesh(random_field(1, 5, 4)), std::invalid_argument);
  EXPECT_THROW(terrain_mesh(random_field(5, 1, 4)), std::invalid_argument);
  HeightField field = random_field(2, 2, 4);
  field.cell = 0;
  EXPECT_THROW(terrain_mesh(field), std::invalid_argument);
}

}  // namespace

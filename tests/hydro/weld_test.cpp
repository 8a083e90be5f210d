#include "hydro/mesh/weld.h"

#include <gtest/gtest.h>

#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"

namespace {

using hydro::TriMesh;
using support::Random;

/// Every face with three vertices of its own, as an STL file has them.
TriMesh exploded(const TriMesh& mesh) {
  TriMesh soup{Eigen::Matrix3Xd(3, 3 * mesh.face_count()), Eigen::Matrix3Xi(3, mesh.face_count())};
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      soup.vertices.col(3 * f + i) = mesh.vertices.col(mesh.faces(i, f));
      soup.faces(i, f) = static_cast<int>(3 * f) + i;
    }
  }
  return soup;
}

TEST(Weld, PutsAnExplodedMeshTogetherAgain) {
  Random random(1);
  for (const TriMesh& mesh : {hydro::make_box({1, 2, 3}, 4), support::random_star(random),
                              support::make_torus(2, 1, 8, 5)}) {
    const TriMesh whole = welded(exploded(mesh), 0);
    EXPECT_EQ(whole.vertex_count(), mesh.vertex_count());
    EXPECT_EQ(whole.face_count(), mesh.face_count());
    EXPECT_TRUE(check_mesh(whole).sound());
  }
}

TEST(Weld, KeepsTheFacesWhereTheyAreAndInOrder) {
  Random random(2);
  const TriMesh soup = exploded(support::random_star(random));
  const TriMesh whole = welded(soup, 0);
  ASSERT_EQ(whole.face_count(), soup.face_count());
  for (Eigen::Index f = 0; f < soup.face_count(); ++f)
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(whole.vertices.col(whole.faces(i, f)), soup.vertices.col(soup.faces(i, f)));
}

TEST(Weld, JoinsWithinTheToleranceAlongEveryAxisAndNotBeyond) {
  Random random(3);
  const double tolerance = 1e-3;
  for (int i = 0; i < 200; ++i) {
    // Two faces on an edge whose copies are `gap` apart along one axis, anywhere on the grid.
    TriMesh mesh{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 2)};
    for (int v = 0; v < 4; ++v) mesh.vertices.col(v) = random.vector(1);
    mesh.faces << 0, 1, 1, 3, 2, 0;
    const TriMesh apart = exploded(mesh);
    for (const double share : {0.99, -0.99, 1.01, -1.01}) {
      TriMesh shifted = apart;
      shifted.vertices.col(3)[i % 3] += share * tolerance;
      const bool joined = std::abs(share) < 1;
      EXPECT_EQ(welded(shifted, tolerance).vertex_count(), joined ? 4 : 5) << share;
    }
  }
}

TEST(Weld, DropsFacesThatLoseACornerAndVerticesThatNoFaceNames) {
  TriMesh mesh = support::corner_tetrahedron({1, 1, 1});
  mesh.vertices.conservativeResize(3, 6);
  mesh.vertices.col(4) << 1e-9, 0, 0;  // a second corner at the origin
  mesh.vertices.col(5) << 7, 7, 7;     // in no face
  mesh.faces.conservativeResize(3, 5);
  mesh.faces.col(4) << 0, 4, 2;
  const TriMesh clean = welded(mesh, 1e-8);
  EXPECT_EQ(clean.vertex_count(), 4);
  EXPECT_EQ(clean.face_count(), 4);
  EXPECT_TRUE(check_mesh(clean).sound());
}

TEST(Weld, NegativeZeroIsZero) {
  TriMesh mesh = exploded(support::corner_tetrahedron({1, 1, 1}));
  mesh.vertices.col(0) = -mesh.vertices.col(0);
  EXPECT_EQ(welded(mesh, 0).vertex_count(), 4);
}

TEST(Weld, AMeshWithoutVerticesStaysSo) { EXPECT_EQ(welded(TriMesh{}, 0).face_count(), 0); }

}  // namespace

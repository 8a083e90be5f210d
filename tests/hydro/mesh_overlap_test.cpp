#include "hydro/mesh/mesh_overlap.h"

#include <gtest/gtest.h>

#include "hydro/mesh/primitives.h"
#include "hydro/mesh/weld.h"
#include "tests/support/meshes.h"

namespace {

using hydro::Overlaps;
using hydro::TriMesh;
using support::Random;
using support::united;

Overlaps overlaps(const TriMesh& mesh) { return find_overlaps(mesh, hydro::FaceTree(mesh)); }

TriMesh centred_cube(const Eigen::Vector3d& middle, int divisions = 1) {
  return translated(hydro::make_box({1, 1, 1}, divisions), middle);
}

TEST(MeshOverlap, SolidsThatCutEachOtherAreFoundInAnyPose) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const TriMesh a = transformed(hydro::make_box({1, 1, 1}, 3), support::random_pose(random, 0.3));
    const TriMesh b = transformed(hydro::make_icosphere(0.6, 2), support::random_pose(random, 0.3));
    const Overlaps found = overlaps(transformed(united(a, b), support::random_pose(random, 100)));
    EXPECT_GT(found.count, 0);
  }
}

TEST(MeshOverlap, TheFirstPlaceLiesOnBothSolids) {
  const Overlaps found = overlaps(united(centred_cube({0, 0, 0}), centred_cube({0.3, 0.2, 0.4})));
  ASSERT_GT(found.count, 0);
  // On the skin of a cube the largest distance from its middle along an axis is a half.
  EXPECT_NEAR(found.first.cwiseAbs().maxCoeff(), 0.5, 1e-12);
  EXPECT_NEAR((found.first - Eigen::Vector3d(0.3, 0.2, 0.4)).cwiseAbs().maxCoeff(), 0.5, 1e-12);
}

TEST(MeshOverlap, CubesShiftedAlongAnAxisShareTheirSidesPlanes) {
  EXPECT_GT(overlaps(united(centred_cube({0, 0, 0}), centred_cube({0.5, 0, 0}))).count, 0);
  EXPECT_GT(overlaps(united(centred_cube({0, 0, 0}, 3), centred_cube({0.5, 0, 0}, 4))).count, 0);
}

TEST(MeshOverlap, PartsThatTouchDoNotCut) {
  Random random(2);
  for (const Eigen::Vector3d& middle :
       std::vector<Eigen::Vector3d>{{1, 0, 0}, {1, 0.3, 0.2}, {1, 1, 0}, {1, 1, 1}, {0, 0, 1.5}}) {
    for (const int divisions : {1, 3}) {
      const TriMesh mesh = united(centred_cube({0, 0, 0}), centred_cube(middle, divisions));
      EXPECT_EQ(overlaps(mesh).count, 0) << middle.transpose();
      TriMesh posed = transformed(mesh, support::random_pose(random, 1));
      posed.vertices = posed.vertices.cast<float>().cast<double>();
      EXPECT_EQ(overlaps(posed).count, 0) << middle.transpose();
    }
  }
}

TEST(MeshOverlap, APartInsideAnotherDoesNotCutIt) {
  EXPECT_EQ(overlaps(united(hydro::make_box({4, 4, 4}, 3), hydro::make_icosphere(1, 2))).count, 0);
}

TEST(MeshOverlap, AFaceThatPiercesANeighbourAtItsVertexIsFound) {
  // Two faces that share vertex 0; the far side of the second passes through the first.
  TriMesh mesh{Eigen::Matrix3Xd(3, 5), Eigen::Matrix3Xi(3, 2)};
  mesh.vertices << 0, 2, 0, 1, 0.4,  //
      0, 0, 2, 0.2, 0.6,             //
      0, 0, 0, 1, -1;
  mesh.faces << 0, 0, 1, 3, 2, 4;
  EXPECT_EQ(overlaps(mesh).count, 1);
}

TEST(MeshOverlap, EachPairCountsOnceAndTheCountDoesNotDependOnThePose) {
  Random random(3);
  const TriMesh crossing = united(support::random_star(random),
                                  translated(support::random_star(random), {0.7, 0.4, 0.5}));
  const Overlaps here = overlaps(crossing);
  Eigen::Index pairs = 0;
  for (Eigen::Index f = 0; f < 320; ++f) {
    for (Eigen::Index g = 320; g < 640; ++g) {
      TriMesh two{crossing.vertices, Eigen::Matrix3Xi(3, 2)};
      two.faces << crossing.faces.col(f), crossing.faces.col(g);
      pairs += overlaps(two).count;
    }
  }
  EXPECT_GT(here.count, 20);
  EXPECT_EQ(here.count, pairs);
  EXPECT_EQ(overlaps(transformed(crossing, support::random_pose(random, 10))).count, here.count);
}

}  // namespace

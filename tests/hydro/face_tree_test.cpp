#include "hydro/mesh/face_tree.h"

#include <gtest/gtest.h>

#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"

namespace {

using Eigen::Vector3d;

/// The nearest faces of a box to points beyond one of its sides are those of that side.
TEST(FaceTree, FindsTheSideOfABoxThatIsNearest) {
  support::Random random(17);
  const hydro::TriMesh box = hydro::make_box({2, 2, 2}, 6);
  const hydro::FaceTree tree(box);
  for (int i = 0; i < 200; ++i) {
    const int axis = i % 3;
    const double side = i % 2 == 0 ? 1 : -1;
    Vector3d point = random.vector(0.9);
    point[axis] = side * random.uniform(1, 3);
    const int face = tree.nearest(point);
    ASSERT_GE(face, 0);
    EXPECT_GT(side * hydro::area_vector(box, face).normalized()[axis], 0.99);
  }
}

/// No corner and no middle of another face is nearer than the face that is found.
TEST(FaceTree, FindsAFaceThatNoOtherIsNearerThan) {
  support::Random random(18);
  const hydro::TriMesh ball = hydro::make_icosphere(1, 3);
  const hydro::FaceTree tree(ball);
  const auto middle = [&](Eigen::Index face) -> Vector3d {
    return (ball.vertices.col(ball.faces(0, face)) + ball.vertices.col(ball.faces(1, face)) +
            ball.vertices.col(ball.faces(2, face))) /
           3;
  };
  for (Eigen::Index face = 0; face < ball.face_count(); ++face)
    EXPECT_EQ(tree.nearest(middle(face) * random.uniform(0.9, 1.5)), face);
}

TEST(FaceTree, WithoutFacesFindsNone) {
  const hydro::TriMesh nothing;
  EXPECT_EQ(hydro::FaceTree(nothing).nearest(Vector3d::Zero()), -1);
}

}  // namespace

#include "app/render/paint.h"

#include <gtest/gtest.h>

#include "hydro/mesh/primitives.h"
#include "tests/render/pictures.h"

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

const Vector3f kOwn(0.5F, 0.5F, 0.5F);
const Vector3f kUpper(0.9F, 0.1F, 0.1F);

/// A box of two triangles a side, the upper half of which, by the middles of the triangles, has a
/// colour.
render::Paint upper_half() {
  render::Paint paint{.surface_B = hydro::make_box({2, 2, 2}, 4), .colors = {}};
  paint.colors = Eigen::Matrix3Xf::Constant(3, paint.surface_B.face_count(), -1);
  for (Eigen::Index f = 0; f < paint.surface_B.face_count(); ++f) {
    double z = 0;
    for (const int v : paint.surface_B.faces.col(f)) z += paint.surface_B.vertices(2, v) / 3;
    if (z > 0) paint.colors.col(f) = kUpper;
  }
  return paint;
}

TEST(PaintedSkin, HasTheNearestColorInEachCornerOfATriangle) {
  // Its triangles are others than the paint's; none crosses the middle height.
  const render::ShadedMesh skin = render::make_shaded_mesh(hydro::make_box({2, 2, 2}, 10));
  const render::PaintedSkin painted = render::painted_skin(skin, upper_half(), kOwn);
  ASSERT_EQ(painted.skin.triangles.cols(), skin.triangles.cols());
  for (Eigen::Index f = 0; f < skin.triangles.cols(); ++f) {
    double z = 0;
    for (int i = 0; i < 3; ++i) {
      const int before = skin.triangles(i, f), after = painted.skin.triangles(i, f);
      EXPECT_EQ(painted.skin.vertices.col(after), skin.vertices.col(before));
      EXPECT_EQ(painted.skin.normals.col(after), skin.normals.col(before));
      z += skin.vertices(2, before) / 3;
    }
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(painted.colors.col(painted.skin.triangles(i, f)), z > 0 ? kUpper : kOwn) << z;
  }
}

TEST(PaintedSkin, RepeatsOnlyVerticesBetweenColors) {
  const render::ShadedMesh skin = render::make_shaded_mesh(hydro::make_box({2, 2, 2}, 4));
  const render::PaintedSkin painted = render::painted_skin(skin, upper_half(), kOwn);
  // At the middle height there are 5 vertices a side, those of the edges once for each side.
  EXPECT_EQ(painted.skin.vertices.cols(), skin.vertices.cols() + 4 * 5);
}

TEST(PaintedBody, LooksLikeOneOfThatColor) {
  pictures::Scene scene = pictures::ball_seen_level(0);
  scene.picture.sea.reset();
  render::BodyAppearance& ball = scene.picture.bodies[0];
  ball.color = {0.9F, 0.1F, 0.1F};
  const render::Image plain = pictures::draw(scene);
  ball.color = {0.2, 0.4, 0.6};
  ball.paint = std::make_shared<render::Paint>(render::Paint{
      .surface_B = ball.mesh_B, .colors = kUpper.replicate(1, ball.mesh_B.face_count())});
  EXPECT_EQ(pictures::draw(scene), plain);
}

}  // namespace

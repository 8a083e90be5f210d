#include "app/render/shade.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/render/pictures.h"

namespace {

using Eigen::Vector3d;
using pictures::Scene;
using render::Image;
using render::View;

/// A ball of radius 1 m that hangs 3 m over the plane z = 0, seen from above its shadow's side.
Scene hanging_ball() {
  Scene scene = pictures::ball_seen_level(3);
  scene.picture.camera = {.from = {0, -14, 9}, .to = {0, 0, 1}, .field_of_view = 0.9};
  return scene;
}

Scene over_water() {
  Scene scene = hanging_ball();
  scene.picture.water_visible = true;
  return scene;
}

Scene over_ground() {
  Scene scene = hanging_ball();
  scene.picture.sea.reset();
  scene.picture.ground_z = 0;
  return scene;
}

/// Sum of the colours of the pixel at a point of W.
int brightness(const Image& image, const View& view, const Vector3d& p_W) {
  const Eigen::Vector4d clip = view.clip_from_E * (p_W - view.eye_W).homogeneous();
  const auto x = static_cast<int>((clip.x() / clip.w() + 1) / 2 * image.width);
  const auto y = static_cast<int>((1 - clip.y() / clip.w()) / 2 * image.height);
  const std::uint8_t* pixel = image.pixel(x, y);
  return pixel[0] + pixel[1] + pixel[2];
}

/// The light that the ball of a scene takes from a point, as a part of that without the ball.
double taken(const Scene& scene, const Vector3d& p_W) {
  render::Renderer renderer(scene.picture, pictures::shader_folder());
  const Image with = renderer.draw(scene.states, 0);
  std::vector<hydro::BodyState> away = scene.states;
  away[0].position.y() = -100;
  const Image without = renderer.draw(away, 0);
  const double left = brightness(with, renderer.view(), p_W);
  return 1 - left / brightness(without, renderer.view(), p_W);
}

Vector3d light_of(const Scene& scene) {
  const render::SceneDescription& picture = scene.picture;
  return key_light(render::make_view(picture.camera, picture.width, picture.height));
}

/// Where the ray of the main light through a point meets the plane z = 0.
Vector3d shadow_of(const Scene& scene, const Vector3d& p_W) {
  const Vector3d light = light_of(scene);
  return p_W - p_W.z() / light.z() * light;
}

/// A level unit vector across the light, along which a ball's shadow is as wide as the ball.
Vector3d across_light(const Scene& scene) {
  return Vector3d::UnitZ().cross(light_of(scene)).normalized();
}

class Shade : public testing::TestWithParam<Scene> {};

TEST_P(Shade, FallsWhereTheRayOfTheLightMeetsWaterOrGround) {
  const Scene& scene = GetParam();
  const Vector3d ball = scene.states[0].position;
  // Well within its rim the shadow is whole, and takes the main light, more than a fifth of all
  // that sand and water have; 1.3 radii off there is none.
  const Vector3d across = across_light(scene);
  for (const double off : {-0.7, 0.0, 0.7})
    EXPECT_GT(taken(scene, shadow_of(scene, ball + off * across)), 0.15) << off;
  for (const double off : {-1.3, 1.3})
    EXPECT_NEAR(taken(scene, shadow_of(scene, ball + off * across)), 0, 0.01) << off;
}

TEST_P(Shade, GrowsSoftlyFromItsRim) {
  const Scene& scene = GetParam();
  const Vector3d ball = scene.states[0].position;
  const double whole = taken(scene, shadow_of(scene, ball));
  const double rim = taken(scene, shadow_of(scene, ball + across_light(scene)));
  EXPECT_GT(rim, 0.2 * whole);
  EXPECT_LT(rim, 0.8 * whole);
}

std::string name_of(const testing::TestParamInfo<Scene>& info) {
  return info.param.picture.sea ? "OnWater" : "OnGround";
}

INSTANTIATE_TEST_SUITE_P(Of, Shade, testing::Values(over_water(), over_ground()), name_of);

TEST(ShadeOfGround, IsOfWhatIsAboveItAlone) {
  Scene sunk = over_ground();
  sunk.states[0].position.z() = -3;
  EXPECT_EQ(taken(sunk, shadow_of(sunk, sunk.states[0].position)), 0);
}

TEST(ShadeOfWater, IsOfWhatIsAboveItAlone) {
  Scene sunk = over_water();
  sunk.states[0].position.z() = -3;
  // The ray through the ball meets the surface before the ball.
  const Vector3d place = shadow_of(sunk, sunk.states[0].position);
  EXPECT_NEAR(taken(sunk, place), 0, 0.01);
}

TEST(ShadedPart, HoldsTheBodiesNearThePointLookedAtAlone) {
  const Scene scene = over_ground();
  const View view = render::make_view(scene.picture.camera, 320, 240);
  const auto side = [&](const std::vector<render::Ball>& balls) {
    return 1 / render::shaded_part(view, balls).square.z();
  };
  const auto at = [&](double y) { return render::Ball{Vector3d(0, y, 0) - view.eye_W, 1}; };
  const double one = side({at(0)});
  EXPECT_GT(one, 2);
  EXPECT_LT(one, 4);
  EXPECT_GT(side({at(0), at(3)}), one + 2.9);
  EXPECT_LT(side({at(0), at(1000)}), 4 * picture_size(view));
  EXPECT_EQ(side({at(1000)}), 1);
  EXPECT_EQ(side({}), 1);
}

}  // namespace

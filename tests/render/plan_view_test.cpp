#include "app/render/plan_view.h"

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

class Shadow : public testing::TestWithParam<Scene> {};

TEST_P(Shadow, FallsWhereTheRayOfTheLightMeetsWaterOrGround) {
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

TEST_P(Shadow, GrowsSoftlyFromItsRim) {
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

INSTANTIATE_TEST_SUITE_P(Of, Shadow, testing::Values(over_water(), over_ground()), name_of);

TEST(ShadowOnGround, IsOfWhatIsAboveItAlone) {
  Scene sunk = over_ground();
  sunk.states[0].position.z() = -3;
  EXPECT_EQ(taken(sunk, shadow_of(sunk, sunk.states[0].position)), 0);
}

TEST(ShadowOnWater, IsOfWhatIsAboveItAlone) {
  Scene sunk = over_water();
  sunk.states[0].position.z() = -3;
  // The ray through the ball meets the surface before the ball.
  const Vector3d place = shadow_of(sunk, sunk.states[0].position);
  EXPECT_NEAR(taken(sunk, place), 0, 0.01);
}

/// A ball of radius 1 m, its middle at a height over still water, seen from above.
Scene plunging_ball(double height, double speed) {
  Scene scene = over_water();
  scene.picture.camera = {.from = {0, -3, 14}, .to = {0, 0, 0}, .field_of_view = 0.5};
  scene.states[0].position = {0, 0, height};
  scene.states[0].linear_velocity = {0, 0, -speed};
  return scene;
}

/// Mean brightness over the right half of a circle about the ball on the water; the shadow falls on
/// the left one.
double brightness_about(const Scene& scene, double radius) {
  render::Renderer renderer(scene.picture, pictures::shader_folder());
  const Image image = renderer.draw(scene.states, 0);
  constexpr int kPoints = 60;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = -1.2 + 2.4 * i / kPoints;
    sum +=
        brightness(image, renderer.view(), radius * Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  return sum / kPoints;
}

/// How much brighter the water is at a radius for the speed of the ball.
double foam_at(double radius, double height, double speed) {
  return brightness_about(plunging_ball(height, speed), radius) -
         brightness_about(plunging_ball(height, 0), radius);
}

TEST(Foam, LiesAboutTheWaterlineOfAMovingBodyAlone) {
  // The ball is cut at its equator. The foam ends some 12 texels off, of 232 that are 2.7 m wide.
  EXPECT_GT(foam_at(1.03, 0, 3), 100);
  EXPECT_LT(foam_at(1.08, 0, 3), foam_at(1.03, 0, 3) - 20);
  EXPECT_NEAR(foam_at(1.4, 0, 3), 0, 1);
  EXPECT_NEAR(foam_at(1.03, 1.5, 3), 0, 1) << "in the air";
  EXPECT_NEAR(foam_at(1.03, -1.5, 3), 0, 1) << "under water";
}

TEST(Foam, IsMoreForAFasterBody) {
  EXPECT_GT(foam_at(1.03, 0, 0.5), 20);
  EXPECT_GT(foam_at(1.03, 0, 1), foam_at(1.03, 0, 0.5) + 20);
}

TEST(Foam, OfABodyThatTheWaterCarriesIsThatOfOneAtRest) {
  Scene scene = plunging_ball(0, 0);
  const double at_rest = brightness_about(scene, 1.03);
  scene.picture.sea->current = {2, 1, 0};
  scene.states[0].linear_velocity = scene.picture.sea->current;
  EXPECT_EQ(brightness_about(scene, 1.03), at_rest);
  scene.states[0].linear_velocity.setZero();
  EXPECT_GT(brightness_about(scene, 1.03), at_rest + 50);
}

TEST(PlanPart, HoldsTheBodiesNearThePointLookedAtAlone) {
  const Scene scene = over_ground();
  const View view = render::make_view(scene.picture.camera, 320, 240);
  const auto side = [&](const std::vector<render::Ball>& balls) {
    return 1 / render::plan_part(view, balls).square.z();
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

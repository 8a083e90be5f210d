#include "app/view/orbit.h"

#include <gtest/gtest.h>

#include <numbers>

#include "app/render/view.h"
#include "tests/support/tolerance.h"

namespace {

using app::Orbit;
using Eigen::Vector2d;
using Eigen::Vector3d;
using support::tolerance;

constexpr double kPi = std::numbers::pi;

render::Camera some_camera() {
  return {.from = {7, -4, 5}, .to = {1, 2, -0.5}, .field_of_view = 0.7};
}

/// Where a point of the world is in a window of 4:3, in half heights.
Vector2d place(const render::Camera& camera, const Vector3d& p_W) {
  const render::View view = render::make_view(camera, 800, 600);
  const Eigen::Vector4d clip = view.clip_from_E * (p_W - view.eye_W).homogeneous();
  return {clip.x() / clip.w() * 800 / 600, clip.y() / clip.w()};
}

TEST(Orbit, IsTheCameraThatItIsMadeOf) {
  const render::Camera camera = some_camera();
  const render::Camera back = app::camera_of(app::orbit_of(camera));
  EXPECT_LT((back.from - camera.from).norm(), tolerance(1e-14));
  EXPECT_EQ(back.to, camera.to);
  EXPECT_EQ(back.field_of_view, camera.field_of_view);
}

TEST(Orbit, TurnsAboutThePointLookedAtWithTheHand) {
  const Orbit orbit = app::orbit_of(some_camera());
  const render::Camera camera = app::camera_of(app::turned(orbit, {0.1, 0.05}));
  EXPECT_EQ(camera.to, orbit.to);
  EXPECT_NEAR((camera.from - camera.to).norm(), orbit.distance, tolerance(1e-14));
  // What is nearer than the point looked at goes the way of the hand, to the right and up.
  const Vector3d front = orbit.to + 0.2 * (some_camera().from - orbit.to);
  const Vector2d moved = place(camera, front) - place(some_camera(), front);
  EXPECT_GT(moved.x(), 0.01);
  EXPECT_GT(moved.y(), 0.005);
}

TEST(Orbit, TurnsHalfAroundOverTheHeightOfTheWindow) {
  const Orbit orbit{.azimuth = -1};
  EXPECT_NEAR(app::turned(orbit, {-2, 0}).azimuth, kPi - 1, tolerance(1e-14));
}

TEST(Orbit, StaysClearOfTheVertical) {
  const Orbit orbit = app::orbit_of(some_camera());
  for (const double up : {-50.0, 50.0}) {
    const Orbit steep = app::turned(orbit, {0, up});
    EXPECT_LT(std::abs(steep.elevation), kPi / 2 - 0.01);
    EXPECT_EQ(steep.azimuth, orbit.azimuth);
  }
}

TEST(Orbit, MovesThePointLookedAtUnderTheHand) {
  const Orbit orbit = app::orbit_of(some_camera());
  const Vector2d way(0.4, -0.3);
  const render::Camera camera = app::camera_of(app::panned(orbit, way));
  EXPECT_LT((place(camera, orbit.to) - way).norm(), tolerance(1e-12));
  const Vector3d arm = some_camera().from - orbit.to;
  EXPECT_LT((camera.from - camera.to - arm).norm(), tolerance(1e-13));
}

TEST(Orbit, ComesNearerAndBackByTheWheel) {
  const Orbit orbit = app::orbit_of(some_camera());
  EXPECT_NEAR(app::zoomed(orbit, 1).distance, 0.85 * orbit.distance, tolerance(1e-14));
  EXPECT_NEAR(app::zoomed(app::zoomed(orbit, 3), -3).distance, orbit.distance, tolerance(1e-13));
  EXPECT_GT(app::zoomed(orbit, 1e4).distance, 0);
  EXPECT_LT(app::zoomed(orbit, -1e4).distance, 1e7);
}

TEST(Ray, GoesThroughWhatItsPointShows) {
  const render::Camera camera = some_camera();
  const Vector3d p_W(2, 1.5, 1);
  const app::Ray ray = app::ray_through(camera, place(camera, p_W));
  EXPECT_EQ(ray.from_W, camera.from);
  EXPECT_LT(ray.along_W.normalized().cross((p_W - camera.from).normalized()).norm(),
            tolerance(1e-12));
  EXPECT_NEAR(ray.along_W.dot((camera.to - camera.from).normalized()), 1, tolerance(1e-14));
}

}  // namespace

#include "app/view/picking.h"

#include <gtest/gtest.h>

#include <random>

#include "hydro/mesh/primitives.h"
#include "tests/support/tolerance.h"

namespace {

using app::Hit;
using app::Ray;
using Eigen::Vector3d;
using support::tolerance;

/// Two balls of radius 1, in arbitrary attitudes.
struct Balls {
  std::vector<engine::BodySpec> bodies;
  std::vector<hydro::BodyState> states;
};

Balls two_balls(const Vector3d& first, const Vector3d& second) {
  Balls balls;
  double angle = 0.4;
  for (const Vector3d& place : {first, second}) {
    balls.bodies.push_back({.name = "ball", .mesh_B = hydro::make_icosphere(1, 4)});
    hydro::BodyState state;
    state.position = place;
    angle += 0.9;
    state.orientation = Eigen::AngleAxisd(angle, Vector3d(3, -1, 2).normalized());
    balls.states.push_back(state);
  }
  return balls;
}

Vector3d point_W(const Balls& balls, const Hit& hit) {
  const hydro::BodyState& state = balls.states[static_cast<std::size_t>(hit.body)];
  return state.position + state.orientation * hit.at_B;
}

TEST(Picking, FindsTheNearestBodyWhereTheRayMeetsIt) {
  const Balls balls = two_balls({10, 5, -2}, {4, 2, -0.8});
  const Ray ray{.from_W = {0, 0, 0}, .along_W = Vector3d(10, 5, -2) / 10};
  const auto hit = app::first_hit(ray, balls.bodies, balls.states);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->body, 1);
  const Vector3d expected = balls.states[1].position - ray.along_W.normalized();
  EXPECT_LT((point_W(balls, *hit) - expected).norm(), 0.01);  // the mesh's facets
  EXPECT_LT((point_W(balls, *hit) - hit->depth * ray.along_W).norm(), tolerance(1e-13));
}

TEST(Picking, MeetsABallAsOftenAsItsDiscIsWide) {
  const Balls balls = two_balls({6, 0, 0}, {1e3, 0, 0});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-1.5, 1.5);
  for (int i = 0; i < 300; ++i) {
    const Vector3d from(0, offset(random), offset(random));
    const double miss = from.norm();
    if (miss > 0.98 && miss < 1) continue;  // between the facets and the ball
    const auto hit = app::first_hit({from, Vector3d::UnitX()}, balls.bodies, balls.states);
    EXPECT_EQ(hit.has_value(), miss < 1);
  }
}

TEST(Picking, SeesNothingBehindTheEye) {
  const Balls balls = two_balls({-4, 0, 0}, {-8, 0, 0});
  EXPECT_FALSE(app::first_hit({{0, 0, 0}, Vector3d::UnitX()}, balls.bodies, balls.states));
}

TEST(Pulling, DrawsThePointTakenHoldOfToTheMouseAtItsDepth) {
  const render::Camera camera{.from = {0, -9, 3}, .to = {0, 0, 0}, .field_of_view = 0.6};
  const Hit held{.body = 0, .at_B = {0.2, 0.1, 0.3}, .depth = 7};
  const Ray ray = app::ray_through(camera, {0.3, -0.2});
  const engine::Pull pull = app::pull_towards(held, ray);
  EXPECT_EQ(pull.at_B, held.at_B);
  EXPECT_GT(pull.rate, 0);
  const Vector3d forward = (camera.to - camera.from).normalized();
  EXPECT_NEAR((pull.to_W - camera.from).dot(forward), 7, tolerance(1e-13));
  const Vector3d direction = ray.along_W.normalized();
  EXPECT_LT((pull.to_W - camera.from).cross(direction).norm(), tolerance(1e-13));
}

}  // namespace

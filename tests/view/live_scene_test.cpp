#include "app/view/live_scene.h"

#include <gtest/gtest.h>

#include "hydro/mesh/primitives.h"

namespace {

using Eigen::Vector3d;

/// A ball of 2 m that falls into water from just above it.
struct Ball {
  scene::Scene scene;
  assembly::BuiltScene built;

  Ball() {
    scene.step = 0.01;
    scene.render.emplace();
    engine::BodySpec body{.name = "ball", .mesh_B = hydro::make_icosphere(1, 2), .mass = 3000};
    body.inertia_B = 1200 * Eigen::Matrix3d::Identity();
    body.initial.position = {0, 0, 1.5};
    built.spec = {.step = scene.step, .sea = hydro::Sea{}, .bodies = {body}};
    scene.bodies.resize(1);
  }
};

TEST(LiveScene, TakesTheStepsAskedForAndAtLeastOne) {
  const Ball ball;
  app::LiveScene live(ball.scene, ball.built);
  EXPECT_EQ(live.advance(5, 100), 5);
  EXPECT_EQ(live.advance(1000, 0), 1);
  EXPECT_EQ(live.simulation().steps(), 6);
}

TEST(LiveScene, StartsAgainAsItStarted) {
  const Ball ball;
  app::LiveScene live(ball.scene, ball.built);
  live.advance(20, 100);
  const hydro::BodyState first = live.simulation().states()[0];
  live.hold(app::Controls::Held{0, {.to_W = {3, 0, 4}}});
  live.advance(20, 100);
  live.restart();
  EXPECT_EQ(live.simulation().steps(), 0);
  live.hold(std::nullopt);
  live.advance(20, 100);
  EXPECT_EQ(live.simulation().states()[0], first);
}

TEST(LiveScene, HoldsABodyUntilItIsLetGo) {
  const Ball ball;
  app::LiveScene live(ball.scene, ball.built);
  const Vector3d to(0, 0, 5);
  live.hold(app::Controls::Held{0, {.to_W = to, .rate = 20}});
  live.advance(300, 100);
  EXPECT_LT((live.simulation().states()[0].position - to).norm(), 0.1);
  live.hold(std::nullopt);
  live.advance(50, 100);
  EXPECT_LT(live.simulation().states()[0].position.z(), 4.5);
}

TEST(LiveScene, DrawsInAnotherSizeAsIfItHadHadItAlways) {
  const Ball ball;
  app::LiveScene resized(ball.scene, ball.built), fresh(ball.scene, ball.built);
  EXPECT_EQ(resized.picture({}, 400, 300, "").width, 400);
  EXPECT_EQ(resized.picture({}, 240, 180, ""), fresh.picture({}, 240, 180, ""));
}

TEST(LiveScene, ShowsTheForcesAndCentresOfTheScene) {
  Ball ball;
  app::LiveScene plain(ball.scene, ball.built);
  const render::Image without = plain.picture({}, 240, 180, "");
  for (bool scene::Show::*what : {&scene::Show::forces, &scene::Show::centres}) {
    ball.scene.render->show = {};
    ball.scene.render->show.*what = true;
    app::LiveScene live(ball.scene, ball.built);
    EXPECT_NE(live.picture({}, 240, 180, ""), without);
  }
}

}  // namespace

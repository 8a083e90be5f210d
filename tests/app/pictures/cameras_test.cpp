#include "app/pictures/cameras.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/pictures/picture_files.h"
#include "app/render/view.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using app::camera_at;
using Eigen::Vector3d;
using scene::Camera;

/// A turn and a sum of coordinates below 20 m: a few ulp.
const double kCameraRoundOff = support::tolerance(1e-14);

/// A projection of such points: some hundred ulp.
const double kViewRoundOff = support::tolerance(1e-12);

/// Two bodies, the second of which starts at (1, 2, 3).
assembly::BuiltScene two_bodies() {
  assembly::BuiltScene built;
  built.spec.bodies.resize(2);
  built.spec.bodies[0].name = "a";
  built.spec.bodies[1].name = "b";
  built.spec.bodies[1].initial.position = {1, 2, 3};
  built.centers_of_mass = {Vector3d::Zero(), Vector3d::Zero()};
  return built;
}

app::Shot shot_at(double time, const Vector3d& second_body) {
  app::Shot shot{.time = time, .states = std::vector<hydro::BodyState>(2)};
  shot.states[0].position = {100, 100, 100};
  shot.states[1].position = second_body;
  return shot;
}

TEST(Camera, StaysWhereItIsPutUnlessToldToMove) {
  const Camera camera = {.from = Vector3d(6, -8, 3), .to = Vector3d(0, 1, 2), .field_of_view = 0.5};
  const render::Camera view = camera_at(camera, two_bodies(), shot_at(7, {9, 9, 9}));
  EXPECT_EQ(view.from, *camera.from);
  EXPECT_EQ(view.to, *camera.to);
  EXPECT_EQ(view.field_of_view, 0.5);
  EXPECT_EQ(camera_at(camera, two_bodies(), shot_at(8, {1, 2, 3})), view);
}

TEST(Camera, ThatFollowsMovesByAsMuchAsTheBodyHas) {
  const Camera camera = {.from = Vector3d(6, -8, 3), .to = Vector3d(0, 1, 2), .follow = "b"};
  const render::Camera first = camera_at(camera, two_bodies(), shot_at(0, {1, 2, 3}));
  EXPECT_EQ(first.from, *camera.from);
  EXPECT_EQ(first.to, *camera.to);
  const render::Camera later = camera_at(camera, two_bodies(), shot_at(5, {1.5, 0, 4}));
  EXPECT_EQ(later.from, *camera.from + Vector3d(0.5, -2, 1));
  EXPECT_EQ(later.to, *camera.to + Vector3d(0.5, -2, 1));
}

TEST(Camera, ThatOrbitsTurnsAboutTheVerticalThroughWhatItLooksAt) {
  const double rate = 0.3;
  const Vector3d to(1, -2, 0.5);
  const Camera camera = {.from = to + Vector3d(5, 0, 2), .to = to, .orbit = rate};
  for (const double time : {0.0, 1.0, 4.0, 50.0}) {
    const render::Camera view = camera_at(camera, two_bodies(), shot_at(time, {9, 9, 9}));
    const double angle = rate * time;  // from x to y is counter-clockwise from above
    EXPECT_LE((view.from - to - Vector3d(5 * std::cos(angle), 5 * std::sin(angle), 2)).norm(),
              kCameraRoundOff);
    EXPECT_EQ(view.to, to);
  }
}

TEST(Camera, ThatOrbitsABodyItFollowsTurnsAboutTheBody) {
  const Vector3d start(1, 2, 3), away(0, -8, 1), moved(10, 20, -1);
  const Camera camera = {
      .from = start + away, .to = start, .follow = "b", .orbit = std::numbers::pi / 2};
  const render::Camera view = camera_at(camera, two_bodies(), shot_at(1, start + moved));
  EXPECT_LE((view.from - start - moved - Vector3d(8, 0, 1)).norm(), kCameraRoundOff);
  EXPECT_LE((view.to - start - moved).norm(), kCameraRoundOff);
}

/// A body's own points keep their places in the picture, whatever the body does.
TEST(Camera, OnABodySeesItsPointsAlwaysAtTheSamePlaces) {
  support::Random random(31);
  assembly::BuiltScene built = two_bodies();
  built.centers_of_mass[1] = {0.4, -0.3, 0.2};
  built.spec.bodies[1].initial.orientation = random.rotation();
  const Camera camera = {.from = Vector3d(0, 0, 3), .to = Vector3d(10, 0, 2), .on = "b"};
  const Vector3d bow_M(9, 1, 0.5);
  const auto place_of_bow = [&](const hydro::BodyState& state, const render::Camera& placed) {
    const render::View view = render::make_view(placed, 400, 300);
    const Vector3d p_W = state.position + state.orientation * (bow_M - built.centers_of_mass[1]);
    return Eigen::Vector2d(
        (view.clip_from_E * (p_W - view.eye_W).homogeneous()).eval().hnormalized().head<2>());
  };
  // In the mesh frame: from (0, 0, 3) toward (10, 0, 2), with z up and y to the left.
  const render::Camera in_M = {.from = *camera.from, .to = *camera.to};
  const render::View view_M = render::make_view(in_M, 400, 300);
  const Eigen::Vector2d expected =
      (view_M.clip_from_E * (bow_M - view_M.eye_W).homogeneous()).eval().hnormalized().head<2>();
  const hydro::BodyState& start = built.spec.bodies[1].initial;
  EXPECT_LE((place_of_bow(start, app::camera_at_start(camera, built)) - expected).norm(),
            kViewRoundOff);
  for (int i = 0; i < 5; ++i) {
    app::Shot shot = shot_at(i, random.vector(20));
    shot.states[1].orientation = random.rotation();
    EXPECT_LE((place_of_bow(shot.states[1], camera_at(camera, built, shot)) - expected).norm(),
              kViewRoundOff);
  }
}

/// A barge of 40 m and a buoy beside it.
assembly::BuiltScene barge_and_buoy() {
  assembly::BuiltScene built = two_bodies();
  built.spec.bodies[0].mesh_B = hydro::make_box({40, 10, 4});
  built.spec.bodies[1].mesh_B = hydro::make_sphere(1, 12, 8);
  built.spec.bodies[1].initial.position = {30, -12, 4};
  return built;
}

/// True if all vertices of all bodies at their start are in the picture.
bool shows_all(const render::Camera& camera, const assembly::BuiltScene& built) {
  const render::View view = render::make_view(camera, 960, 720);
  bool all = true;
  for (const engine::BodySpec& body : built.spec.bodies)
    for (const auto& vertex : body.mesh_B.vertices.colwise()) {
      const Vector3d p_E = body.initial.position + vertex - view.eye_W;
      const Eigen::Vector4d clip = view.clip_from_E * p_E.homogeneous();
      all = all && clip.head<2>().cwiseAbs().maxCoeff() < clip.w();
    }
  return all;
}

TEST(Camera, WithoutAPlaceShowsAllBodies) {
  const assembly::BuiltScene built = barge_and_buoy();
  EXPECT_FALSE(shows_all({}, built));  // it stands in the barge
  for (const Camera& camera : {Camera{}, Camera{.field_of_view = 0.2},
                               Camera{.to = Vector3d(10, 5, 0)}, Camera{.follow = "b"}})
    EXPECT_TRUE(shows_all(app::camera_at_start(camera, built), built));
}

TEST(Camera, StandsAndLooksWhereTheSceneSaysAndChoosesTheRest) {
  const assembly::BuiltScene built = barge_and_buoy();
  const Vector3d place(10, 5, -3), middle = app::camera_at_start({}, built).to;
  const render::Camera from = app::camera_at_start({.from = place}, built);
  EXPECT_EQ(from.from, place);
  EXPECT_EQ(from.to, middle);
  EXPECT_EQ(app::camera_at_start({.to = place}, built).to, place);
  // Not along the vertical, which is up in pictures.
  const render::Camera above = app::camera_at_start({.from = middle + Vector3d(0, 0, 50)}, built);
  EXPECT_EQ(above.from, middle + Vector3d(0, 0, 50));
  EXPECT_GT((above.to - above.from).head<2>().norm(), 0.1);
}

TEST(Camera, OfASceneWithoutBodiesStandsSomewhere) {
  const render::Camera camera = app::camera_at_start({}, {});
  EXPECT_EQ(camera, render::Camera{});
}

TEST(Cameras, OfASceneAreThoseWithNamesOrElseTheOneWithout) {
  scene::Render render;
  render.camera.orbit = 1;
  ASSERT_EQ(app::cameras_of(render).size(), 1u);
  EXPECT_EQ(app::cameras_of(render)[0].orbit, 1);
  render.cameras = {{.name = "bow"}};
  EXPECT_EQ(app::cameras_of(render)[0].orbit, 0);
  EXPECT_EQ(app::cameras_of(render)[0].name, "");  // alone it needs no folder of its own
  render.cameras.push_back({.name = "stern"});
  EXPECT_EQ(app::cameras_of(render)[0].name, "bow");
  EXPECT_EQ(app::cameras_of(render)[1].name, "stern");
}

TEST(PictureFiles, AreNamedByTheCameraWhereThereAreSeveral) {
  EXPECT_EQ(app::frame_file("o", "", 7), "o/frames/frame_0007.png");
  EXPECT_EQ(app::frame_file("o", "bow", 12345), "o/frames/bow/frame_12345.png");
  EXPECT_EQ(app::sheet_file("o", ""), "o/sheet.png");
  EXPECT_EQ(app::sheet_file("o", "bow"), "o/sheet_bow.png");
  EXPECT_EQ(app::video_file("v/drop.mp4", ""), "v/drop.mp4");
  EXPECT_EQ(app::video_file("v/drop.2.mp4", "bow"), "v/drop.2-bow.mp4");
  EXPECT_EQ(app::video_file("drop.gif", "bow"), "drop-bow.gif");
}

}  // namespace

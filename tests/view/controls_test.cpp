#include "app/view/controls.h"

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace {

using app::Button;
using app::ButtonPress;
using app::ButtonRelease;
using app::Controls;
using app::Key;
using app::KeyPress;
using app::MouseMove;
using app::Wheel;
using Eigen::Vector2d;
using support::tolerance;

const render::Camera kHome{.from = {5, -6, 2}, .to = {0, 1, 0}, .field_of_view = 0.6};
constexpr double kStep = 0.01;  // [s]

/// A body that fills the right half of the window, 4 m off.
std::optional<app::Hit> on_the_right(const app::Ray& ray) {
  const Eigen::Vector3d right = (kHome.to - kHome.from).cross(Eigen::Vector3d::UnitZ());
  if (ray.along_W.dot(right) <= 0) return std::nullopt;
  return app::Hit{.body = 2, .at_B = {0, 0, 1}, .depth = 4};
}

Controls make_controls() { return Controls(kHome, kStep, on_the_right); }

void drag(Controls& controls, const ButtonPress& press, const Vector2d& to) {
  controls.take(press);
  controls.take(MouseMove{to});
  controls.take(ButtonRelease{});
}

bool same_camera(const render::Camera& a, const render::Camera& b) {
  return (a.from - b.from).norm() < tolerance(1e-12) && (a.to - b.to).norm() < tolerance(1e-12);
}

TEST(Controls, TurnByALeftDragOnlyWhileItLasts) {
  Controls controls = make_controls();
  controls.take(MouseMove{{0.4, 0.4}});
  EXPECT_TRUE(same_camera(controls.camera(), kHome));
  drag(controls, {.at = {0, 0}}, {0.2, 0.1});
  const render::Camera turned = camera_of(app::turned(app::orbit_of(kHome), {0.2, 0.1}));
  EXPECT_TRUE(same_camera(controls.camera(), turned));
  controls.take(MouseMove{{-0.5, 0}});
  EXPECT_TRUE(same_camera(controls.camera(), turned));
}

TEST(Controls, MoveTheSceneByARightDragOrAShiftedOne) {
  const render::Camera panned = camera_of(app::panned(app::orbit_of(kHome), {0.3, -0.1}));
  for (const ButtonPress& press :
       {ButtonPress{.button = Button::right}, ButtonPress{.shift = true}}) {
    Controls controls = make_controls();
    drag(controls, press, {0.3, -0.1});
    EXPECT_TRUE(same_camera(controls.camera(), panned));
  }
}

TEST(Controls, ZoomByTheWheelAndComeHome) {
  Controls controls = make_controls();
  controls.take(Wheel{2});
  EXPECT_LT((controls.camera().from - kHome.to).norm(), (kHome.from - kHome.to).norm());
  controls.take(KeyPress{Key::home});
  EXPECT_TRUE(same_camera(controls.camera(), kHome));
}

TEST(Controls, PullTheBodyUnderTheMouseUntilItIsLetGo) {
  for (const ButtonPress& press : {ButtonPress{.at = {0.2, 0}, .control = true},
                                   ButtonPress{.button = Button::middle, .at = {0.2, 0}}}) {
    Controls controls = make_controls();
    controls.take(press);
    controls.take(MouseMove{{0.5, 0.3}});
    ASSERT_TRUE(controls.held());
    EXPECT_EQ(controls.held()->body, 2);
    const app::Ray ray = app::ray_through(kHome, {0.5, 0.3});
    EXPECT_LT((controls.held()->pull.to_W - ray.from_W - 4 * ray.along_W).norm(), tolerance(1e-12));
    EXPECT_TRUE(same_camera(controls.camera(), kHome));
    controls.take(ButtonRelease{});
    EXPECT_FALSE(controls.held());
  }
}

TEST(Controls, PullNothingBesideABody) {
  Controls controls = make_controls();
  controls.take(ButtonPress{.at = {-0.2, 0}, .control = true});
  controls.take(MouseMove{{0.5, 0.3}});
  EXPECT_FALSE(controls.held());
  EXPECT_TRUE(same_camera(controls.camera(), kHome));
}

TEST(Controls, LetGoAndGoBackInTimeOnceForEachRestart) {
  Controls controls = make_controls();
  controls.take(ButtonPress{.at = {0.2, 0}, .control = true});
  controls.take(KeyPress{Key::restart});
  EXPECT_FALSE(controls.held());
  EXPECT_TRUE(controls.take_restart());
  EXPECT_FALSE(controls.take_restart());
}

TEST(Controls, PassTheKeysOfTimeToThePace) {
  Controls controls = make_controls();
  controls.take(KeyPress{Key::faster});
  EXPECT_EQ(controls.playback().speed(), 2);
  controls.take(KeyPress{Key::slower});
  EXPECT_EQ(controls.playback().speed(), 1);
  controls.take(KeyPress{Key::pause});
  controls.take(KeyPress{Key::step});
  EXPECT_EQ(controls.playback().steps_due(1), 1);
}

TEST(Controls, ShowHelpAndQuit) {
  Controls controls = make_controls();
  controls.take(KeyPress{Key::help});
  EXPECT_TRUE(controls.help());
  controls.take(KeyPress{Key::help});
  EXPECT_FALSE(controls.help());
  EXPECT_FALSE(controls.quit());
  controls.take(KeyPress{Key::quit});
  EXPECT_TRUE(controls.quit());
}

}  // namespace

#include "app/view/window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/render/png.h"
#include "tests/app/program/program.h"

/// The window as a screen shows it, without a monitor.

namespace {

using render::Image;
using render::Rgb;
using support::lines_of;
using support::Outcome;
using support::Workplace;
using testing::EndsWith;
using testing::HasSubstr;

constexpr int kWidth = 400, kHeight = 300;

/// A red box that hangs above the middle of the picture and falls; `more` are keys of a body.
std::string red_box(const std::string& more = "") {
  return "plimsoll: 1\nduration: 1\nstep: 0.01\nwater: {}\nbodies:\n"
         "  - {name: box, box: {size: [2, 2, 2]}, density: 500, position: [0, 0, 2.6], "
         "color: [0.9, 0.1, 0.1], hydro: {added_mass: none}" +
         more +
         "}\nrender: {size: [400, 300], camera: {from: [0, -14, 2], to: [0, 0, 1], fov_deg: 40}}\n";
}

class LiveWindow : public testing::Test {
 protected:
  void SetUp() override {
    if (!app::why_no_window().empty()) GTEST_SKIP() << app::why_no_window();
    here.write("scene.yaml", red_box());
  }

  /// Runs `plimsoll view` with these words on a screen without a monitor.
  Outcome view(const std::string& words) const {
    return here.shell("sh " PLIMSOLL_SOURCE_DIR "/tests/view/on_screen.sh \"$PLIMSOLL\" view " +
                      words);
  }
  bool has_screens() const { return here.shell("command -v Xvfb").code == 0; }

  Workplace here;
};

bool is_red(const Rgb& color) { return color.r > 100 && color.r > 2 * color.g; }
bool is_blue(const Rgb& color) { return color.b > color.r + 10; }

/// Share of the pixels that are red: the box above the water.
double red_share(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += is_red(image.at(x, y));
  return static_cast<double>(count) / (image.width * image.height);
}

TEST_F(LiveWindow, ShowsTheSceneAsTimeGoesOn) {
  if (!has_screens()) GTEST_SKIP() << "Xvfb is not installed";
  const Outcome first = view("scene.yaml --snapshot first.png");
  ASSERT_EQ(first.code, 0) << first.err;
  const Image start = render::read_png(here / "first.png");
  EXPECT_EQ(start.width, kWidth);
  EXPECT_EQ(start.height, kHeight);
  EXPECT_TRUE(is_red(start.at(kWidth / 2, 100)));
  const Rgb sky = start.at(kWidth - 30, 20), water = start.at(kWidth / 2, kHeight - 30);
  EXPECT_TRUE(is_blue(sky));
  EXPECT_TRUE(is_blue(water));
  EXPECT_GT(sky.r + sky.g + sky.b, water.r + water.g + water.b + 90);

  const Outcome second = view("scene.yaml --snapshot second.png --after 0.8");
  ASSERT_EQ(second.code, 0) << second.err;
  const Image later = render::read_png(here / "second.png");
  EXPECT_EQ(later.width, kWidth);
  EXPECT_LT(red_share(later), 0.8 * red_share(start));  // it has dived
  EXPECT_GT(red_share(later), 0.001);
}

TEST_F(LiveWindow, ShowsASceneWithoutARenderBlock) {
  if (!has_screens()) GTEST_SKIP() << "Xvfb is not installed";
  const std::string scene = red_box();
  here.write("plain.yaml", scene.substr(0, scene.find("render:")));
  const Outcome outcome = view("plain.yaml --snapshot plain.png");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GT(red_share(render::read_png(here / "plain.png")), 0.03);
}

TEST_F(LiveWindow, TellsOfAMotionThatCannotGoOn) {
  if (!has_screens()) GTEST_SKIP() << "Xvfb is not installed";
  here.write("bad.yaml", red_box(", forces: [{force: [1e300, 0, 0], start: 0.05}]"));
  const Outcome outcome = view("bad.yaml --snapshot bad.png --after 1");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("error: body 'box' at t = 0.05 s: "));
}

TEST_F(LiveWindow, NeedsAScreen) {
  const Outcome outcome =
      here.shell("env -u DISPLAY -u WAYLAND_DISPLAY \"$PLIMSOLL\" view scene.yaml");
  EXPECT_EQ(outcome.code, 2);
  ASSERT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("there is no screen"));
}

TEST_F(LiveWindow, TellsWhatIsWrongWithASceneBeforeItLooksForAScreen) {
  here.write("wrong.yaml", red_box(", densty: 3"));
  const Outcome outcome =
      here.shell("env -u DISPLAY -u WAYLAND_DISPLAY \"$PLIMSOLL\" view wrong.yaml");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("bodies[0].densty: unknown key"));
  EXPECT_THAT(outcome.err, EndsWith("1 problem, nothing was run.\n"));
}

TEST(NoWindow, IsToldInOneLine) {
  if (app::why_no_window().empty()) GTEST_SKIP() << "there are windows";
  const Workplace here;
  here.write("scene.yaml", red_box());
  const Outcome outcome = here.run({"view", "scene.yaml"});
  EXPECT_EQ(outcome.code, 2);
  ASSERT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("libglfw3-dev"));
}

}  // namespace

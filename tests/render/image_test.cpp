#include "app/render/image.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>
#include <set>
#include <string>

#include "app/render/color_scale.h"
#include "app/render/overlay.h"
#include "app/render/png.h"
#include "app/render/text.h"
#include "tests/support/random_pose.h"

namespace {

using render::Image;
using render::Rgb;

Image random_image(int width, int height, unsigned seed) {
  support::Random random(seed);
  Image image = render::filled_image(width, height, {});
  for (std::uint8_t& value : image.rgb) value = static_cast<std::uint8_t>(random.uniform(0, 256));
  return image;
}

double mean(const Image& image) {
  return std::accumulate(image.rgb.begin(), image.rgb.end(), 0.0) /
         static_cast<double>(image.rgb.size());
}

double dark_share(const Image& image) {
  const auto dark =
      std::count_if(image.rgb.begin(), image.rgb.end(), [](int v) { return v < 128; });
  return static_cast<double>(dark) / static_cast<double>(image.rgb.size());
}

TEST(Png, ReadsBackThePixelsWritten) {
  const Image image = random_image(37, 23, 1);
  const auto file = std::filesystem::temp_directory_path() / "plimsoll_round_trip.png";
  render::write_png(image, file);
  EXPECT_EQ(render::read_png(file), image);
  std::filesystem::remove(file);
}

TEST(Png, NamesAFileThatCannotBeWrittenOrRead) {
  const Image image = random_image(4, 4, 2);
  EXPECT_THAT([&] { render::write_png(image, "/no/such/folder/a.png"); },
              testing::ThrowsMessage<render::Error>(testing::HasSubstr("/no/such/folder/a.png")));
  EXPECT_THAT([] { render::read_png("/no/such/b.png"); },
              testing::ThrowsMessage<render::Error>(testing::HasSubstr("/no/such/b.png")));
}

TEST(Resized, KeepsAnEvenColor) {
  const Image even = render::filled_image(64, 48, {200, 100, 50});
  EXPECT_EQ(render::resized(even, 31, 17), render::filled_image(31, 17, {200, 100, 50}));
}

TEST(Resized, ToTheSameSizeIsTheSameImage) {
  const Image image = random_image(20, 16, 3);
  EXPECT_EQ(render::resized(image, 20, 16), image);
}

TEST(Resized, KeepsTheMeanOfFineDetail) {
  // Lobes of the window are cut at the border and values at 0 and 255: one level of 255 for both.
  const Image image = random_image(240, 180, 4);
  EXPECT_NEAR(mean(render::resized(image, 80, 60)), mean(image), 1.0);
}

TEST(ScaleColors, RunFromBlueOverGreenToRed) {
  const auto& colors = render::scale_colors();
  EXPECT_GT(colors.front().b, colors.front().r);
  EXPECT_GT(colors[128].g, colors[128].r);
  EXPECT_GT(colors[128].g, colors[128].b);
  EXPECT_GT(colors.back().r, 4 * colors.back().g);
  for (std::size_t i = 1; i < colors.size(); ++i) EXPECT_NE(colors[i], colors[i - 1]) << i;
}

TEST(ScaleColors, OfAllNamesDifferAndHaveNoJumps) {
  std::set<std::string> ends;
  for (const auto& [name, map] : render::color_maps()) {
    const auto& colors = render::scale_colors(map);
    for (std::size_t i = 1; i < colors.size(); ++i) {
      const auto step = [&](std::uint8_t a, std::uint8_t b) { return std::abs(a - b); };
      const render::Rgb a = colors[i - 1], b = colors[i];
      EXPECT_LE(std::max({step(a.r, b.r), step(a.g, b.g), step(a.b, b.b)}), 8) << name << ' ' << i;
    }
    ends.insert(fmt::format("{} {} {}", colors[0].r, colors[64].g, colors[255].b));
  }
  EXPECT_EQ(ends.size(), render::color_maps().size());
}

TEST(ScaleColors, OfTheThesisRunFromBlueToRed) {
  const auto& colors = render::scale_colors(render::ColorMap::thesis);
  EXPECT_EQ(colors.front(), (render::Rgb{0, 0, 255}));
  EXPECT_EQ(colors.back(), (render::Rgb{255, 0, 0}));
}

TEST(ScaleColors, HoldBeyondTheEnds) {
  const render::PressureScale scale{.min = 100, .max = 300};
  EXPECT_EQ(render::scale_color(scale, -1e9), render::scale_colors().front());
  EXPECT_EQ(render::scale_color(scale, 1e9), render::scale_colors().back());
  EXPECT_EQ(render::scale_color(scale, 200), render::scale_colors()[128]);
}

std::vector<std::string> labels(double min, double max) {
  std::vector<std::string> result;
  for (const render::Tick& tick : render::round_ticks({.min = min, .max = max}))
    result.push_back(tick.label);
  return result;
}

TEST(Ticks, AreRoundKilopascals) {
  EXPECT_THAT(labels(0, 20e3), testing::ElementsAre("0", "5", "10", "15", "20"));
  EXPECT_THAT(labels(0, 1234),
              testing::ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0", "1.2"));
  EXPECT_THAT(labels(-300, 300), testing::ElementsAre("-0.2", "0.0", "0.2"));
  EXPECT_THAT(labels(95e3, 130e3), testing::ElementsAre("100", "110", "120", "130"));
}

TEST(Ticks, AreThreeToEightAndInPlace) {
  support::Random random(5);
  for (int i = 0; i < 200; ++i) {
    const double low = random.uniform(-1e4, 1e4);
    const double range = std::exp(random.uniform(0, 15));
    const auto ticks = render::round_ticks({.min = low, .max = low + range});
    EXPECT_GE(ticks.size(), 3u);
    EXPECT_LE(ticks.size(), 8u);
    for (const render::Tick& tick : ticks) {
      // A label is exact to half of its last digit, which is at most a fifth of a step of ticks,
      // itself at most a third of the range.
      EXPECT_NEAR(low + tick.place * range, 1000 * std::stod(tick.label), range / 30);
    }
  }
}

TEST(Font, WritesInkInsideItsWidthOnly) {
  const render::Font font(20);
  Image image = render::filled_image(200, 60, {255, 255, 255});
  font.write(image, "t = 0.30 s", 100, 40, render::Align::center, {0, 0, 0});
  const double half = font.width("t = 0.30 s") / 2;
  int ink = 0, outside = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.at(x, y).r < 200) {
        ++ink;
        outside += std::abs(x + 0.5 - 100) > half + 1 || y > 45 || y < 40 - 20;
      }
  EXPECT_GT(ink, 100);
  EXPECT_EQ(outside, 0);
}

TEST(Font, DigitsAreOneWidth) {
  const render::Font font(18);
  EXPECT_DOUBLE_EQ(font.width("t = 0.30 s"), font.width("t = 1.87 s"));
}

TEST(Overlay, LeavesTheMiddleOfThePictureAlone) {
  const Image blank = render::filled_image(960, 720, {40, 90, 120});
  Image image = blank;
  render::add_overlay(image, render::PressureScale{.max = 1e4}, 0.3);
  EXPECT_NE(image, blank);
  for (int y = 200; y < 520; ++y)
    for (int x = 0; x < 800; ++x) ASSERT_EQ(image.at(x, y), blank.at(x, y)) << x << ", " << y;
}

TEST(Overlay, ShowsTheScalesColorsAndTheTime) {
  const Image blank = render::filled_image(960, 720, {128, 128, 128});
  Image early = blank, late = blank, dry = blank;
  render::add_overlay(early, render::PressureScale{.max = 1e4}, 0.3);
  render::add_overlay(late, render::PressureScale{.max = 1e4}, 0.6);
  render::add_overlay(dry, std::nullopt, 0.3);
  EXPECT_NE(early, late);
  EXPECT_EQ(render::time_label(0.3), "t = 0.30 s");
  const auto has = [](const Image& image, Rgb color) {
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        if (image.at(x, y) == color) return true;
    return false;
  };
  for (const std::size_t i : {10u, 128u, 245u}) {
    EXPECT_TRUE(has(early, render::scale_colors()[i])) << i;
    EXPECT_FALSE(has(dry, render::scale_colors()[i])) << i;
  }
}

TEST(Overlay, TakesLittleOfANarrowPicture) {
  const Image blank = render::filled_image(200, 900, {40, 90, 120});
  Image image = blank;
  render::add_overlay(image, render::PressureScale{.max = 1e4}, 0.3);
  for (int y = 60; y < 680; ++y)
    for (int x = 0; x < 200; ++x) ASSERT_EQ(image.at(x, y), blank.at(x, y)) << x << ", " << y;
}

TEST(Overlay, StaysAtTheEdgesOfWideAndSquarePictures) {
  for (const auto& [width, height] : {std::pair(1280, 360), {1920, 816}, {600, 600}}) {
    const Image blank = render::filled_image(width, height, {40, 90, 120});
    Image image = blank;
    render::add_overlay(image, render::PressureScale{.max = 1e4}, 0.3, 2);
    EXPECT_NE(image, blank);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const bool middle = x > width / 4 && x < 0.85 * width;
        const bool edge = x < 4 || y < 4 || x >= width - 4 || y >= height - 4;
        if (!middle && !edge) continue;
        ASSERT_EQ(image.at(x, y), blank.at(x, y)) << x << ", " << y;
      }
  }
}

TEST(Overlay, IsLeftOutWhereItWouldNotBeLegible) {
  const Image blank = render::filled_image(400, 100, {40, 90, 120});
  Image image = blank;
  render::add_overlay(image, render::PressureScale{.max = 1e4}, 0.3);
  EXPECT_EQ(image, blank);
}

TEST(Overlay, StaysInsideASmallPicture) {
  Image image = render::filled_image(160, 120, {255, 255, 255});
  render::add_overlay(image, render::PressureScale{.max = 1e4}, 12.5);
  EXPECT_GT(dark_share(image), 0.01);
}

}  // namespace

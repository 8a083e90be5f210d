#include "app/view/status.h"

#include <gtest/gtest.h>

namespace {

using app::PlaybackClock;
using render::Image;

constexpr render::Rgb kBlack = {0, 0, 0};

/// The first column with anything on it, from the left; the image's width if there is none.
int first_column(const Image& image) {
  for (int x = 0; x < image.width; ++x)
    for (int y = 0; y < image.height; ++y)
      if (image.at(x, y) != kBlack) return x;
  return image.width;
}

long marked(const Image& image) {
  long count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += image.at(x, y) != kBlack;
  return count;
}

TEST(Status, TellsTheSpeedAndWhatOfItWasReached) {
  PlaybackClock playback(0.1);
  EXPECT_EQ(app::playback_text(playback), "speed 1");
  for (int i = 0; i < 3; ++i) playback.slower();
  playback.note(1, 1);
  EXPECT_EQ(app::playback_text(playback), "speed 1/8, reached 0.10");
  playback.pause_or_go_on();
  EXPECT_EQ(app::playback_text(playback), "speed 1/8, paused");
  for (int i = 0; i < 5; ++i) playback.faster();
  EXPECT_EQ(app::playback_text(playback), "speed 4, paused");
}

TEST(Help, LeavesTheLeftFreeAndGrowsWhenItIsWhole) {
  Image brief = render::filled_image(640, 480, kBlack), full = brief;
  app::add_help(brief, false);
  app::add_help(full, true);
  EXPECT_GT(first_column(brief), 320);
  EXPECT_GT(first_column(full), 240);
  EXPECT_GT(marked(full), 3 * marked(brief));
}

TEST(Help, LeavesSmallPicturesAlone) {
  Image image = render::filled_image(100, 400, kBlack);
  app::add_help(image, true);
  EXPECT_EQ(marked(image), 0);
}

}  // namespace

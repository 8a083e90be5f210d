#include "app/view/status.h"

#include <gtest/gtest.h>

namespace {

using app::Pace;
using render::Image;

constexpr render::Rgb kBlack = {0, 0, 0};

/// The highest row with anything on it, from above; the image's height if there is none.
int first_row(const Image& image) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.at(x, y) != kBlack) return y;
  return image.height;
}

long marked(const Image& image) {
  long count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += image.at(x, y) != kBlack;
  return count;
}

TEST(Status, TellsTheSpeedAndWhatOfItWasReached) {
  Pace pace(0.1);
  EXPECT_EQ(app::pace_text(pace), "speed 1");
  for (int i = 0; i < 3; ++i) pace.slower();
  pace.note(1, 1);
  EXPECT_EQ(app::pace_text(pace), "speed 1/8, reached 0.10");
  pace.pause_or_go_on();
  EXPECT_EQ(app::pace_text(pace), "speed 1/8, paused");
  for (int i = 0; i < 5; ++i) pace.faster();
  EXPECT_EQ(app::pace_text(pace), "speed 4, paused");
}

TEST(Status, LeavesRoomForTheTimeAndGrowsWithHelp) {
  const Pace pace(0.1);
  Image brief = render::filled_image(640, 480, kBlack), full = brief;
  app::add_status(brief, pace, false);
  app::add_status(full, pace, true);
  EXPECT_GT(first_row(brief), 30);
  EXPECT_GT(marked(full), 3 * marked(brief));
}

TEST(Status, LeavesSmallPicturesAlone) {
  Image image = render::filled_image(100, 400, kBlack);
  app::add_status(image, Pace(0.1), true);
  EXPECT_EQ(marked(image), 0);
}

}  // namespace

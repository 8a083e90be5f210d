#include "tests/golden/pictures/difference.h"

#include <gtest/gtest.h>

namespace {

using golden::Difference;
using render::Image;

constexpr render::Rgb kGray = {100, 100, 100};

/// With the green of the first pixels changed.
Image changed(Image image, int pixels, int change) {
  for (int i = 0; i < pixels; ++i) {
    std::uint8_t& green = image.pixel(i % image.width, i / image.width)[1];
    green = static_cast<std::uint8_t>(green + change);
  }
  return image;
}

TEST(PictureDifference, OfAPictureFromItselfIsNone) {
  const Image image = render::filled_image(40, 50, kGray);
  const Difference found = golden::difference(image, image);
  EXPECT_EQ(found.largest, 0);
  EXPECT_EQ(found.mean, 0);
  EXPECT_TRUE(found.within_tolerance());
}

TEST(PictureDifference, IsSlightWhereverItIsAsRoundingsAre) {
  const Image image = render::filled_image(40, 50, kGray);
  for (const int change : {golden::kSlight, -golden::kSlight}) {
    const Difference found = golden::difference(image, changed(image, 2000, change));
    EXPECT_EQ(found.largest, golden::kSlight);
    EXPECT_EQ(found.marked, 0);
    EXPECT_DOUBLE_EQ(found.mean, golden::kSlight / 3.0);
    EXPECT_TRUE(found.within_tolerance());
  }
}

/// Of 2,000 pixels two may be on an edge, not three.
TEST(PictureDifference, IsToldByTheShareOfThePixels) {
  const Image image = render::filled_image(40, 50, kGray);
  EXPECT_TRUE(golden::difference(image, changed(image, 2, 80)).within_tolerance());
  const Difference found = golden::difference(image, changed(image, 3, golden::kSlight + 1));
  EXPECT_DOUBLE_EQ(found.marked, 3 / 2000.0);
  EXPECT_FALSE(found.within_tolerance());
}

TEST(PictureDifference, ShowsWhereItIs) {
  const Image image = render::filled_image(40, 50, kGray);
  const Image shown = golden::difference_image(image, changed(image, 7, 9));
  EXPECT_EQ(shown.at(6, 0), (render::Rgb{200, 0, 0}));
  EXPECT_EQ(shown.at(7, 0), (render::Rgb{255, 255, 255}));
}

TEST(PictureDifference, IsNotThatOfTwoSizes) {
  const Image image = render::filled_image(40, 50, kGray);
  EXPECT_THROW(golden::difference(image, render::filled_image(50, 40, kGray)),
               std::invalid_argument);
}

}  // namespace

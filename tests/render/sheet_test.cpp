#include "app/render/sheet.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/render/png.h"
#include "tests/render/pictures.h"

namespace {

using render::ContactSheet;
using render::Image;
using render::Rgb;

constexpr Rgb kWhite = {255, 255, 255};

Image gray(int i) {
  const auto level = static_cast<std::uint8_t>(20 + 2 * (i % 100));
  return render::filled_image(96, 72, {level, level, level});
}

/// Pixels of a rectangle that are not white.
int ink(const Image& image, int left, int top, int width, int height) {
  int count = 0;
  for (int y = top; y < top + height; ++y)
    for (int x = left; x < left + width; ++x) count += !(image.at(x, y) == kWhite);
  return count;
}

ContactSheet sheet_of(int count, double every, std::optional<render::PressureScale> scale) {
  ContactSheet sheet(scale);
  for (int i = 0; i < count; ++i) sheet.add(gray(i), i * every);
  return sheet;
}

TEST(ContactSheet, HasAFurtherScaleInARowOfItsOwn) {
  const Rgb first = {10, 200, 30}, last = {220, 40, 50};
  ContactSheet plain({}), with({}, {}, render::LegendRamp{"tension 0 to 8 kN", {first, last}});
  plain.add(gray(0), 0);
  with.add(gray(0), 0);
  const Image without_scale = plain.image(), sheet = with.image();
  ASSERT_EQ(sheet.width, without_scale.width);
  ASSERT_GT(sheet.height, without_scale.height);
  int firsts = 0, lasts = 0;
  for (int y = without_scale.height; y < sheet.height; ++y)
    for (int x = 0; x < sheet.width; ++x) {
      firsts += sheet.at(x, y) == first;
      lasts += sheet.at(x, y) == last;
    }
  EXPECT_GT(firsts, 1000);
  EXPECT_EQ(firsts, lasts);
  // Its name stands right of it.
  EXPECT_GT(ink(sheet, sheet.width / 2 + 8, without_scale.height, sheet.width / 2 - 8,
                sheet.height - without_scale.height),
            100);
}

TEST(SheetColumns, AreFourForTwelvePictures) { EXPECT_EQ(render::sheet_columns(12, 4.0 / 3), 4); }

TEST(SheetColumns, AreNeverMoreThanPictures) {
  for (int count = 1; count <= ContactSheet::kMostFrames; ++count) {
    EXPECT_GE(render::sheet_columns(count, 4.0 / 3), 1) << count;
    EXPECT_LE(render::sheet_columns(count, 4.0 / 3), count);
  }
}

TEST(ContactSheet, IsLandscapeAndHoldsTwelvePicturesInThreeRows) {
  const Image image = sheet_of(12, 0.3, render::PressureScale{.max = 1e4}).image();
  const double aspect = static_cast<double>(image.width) / image.height;
  EXPECT_GT(aspect, 4.0 / 3 - 0.1);
  EXPECT_LT(aspect, 16.0 / 9);
  EXPECT_GT(image.width, 4 * ContactSheet::kFrameWidth);
  EXPECT_LT(image.width, 4.3 * ContactSheet::kFrameWidth);
}

TEST(ContactSheet, HasALetterAndATimeUnderEachPicture) {
  const Image image = sheet_of(2, 0.3, std::nullopt).image();
  const Image other_times = sheet_of(2, 0.4, std::nullopt).image();
  const int bottom = image.height - 50, half = image.width / 2;
  EXPECT_GT(ink(image, 0, bottom, half, 40), 200);
  EXPECT_GT(ink(image, half, bottom, half, 40), 200);
  EXPECT_NE(image, other_times);
}

TEST(ContactSheet, HasTheScaleBelowIfThereIsOne) {
  const Image dry = sheet_of(3, 0.3, std::nullopt).image();
  const Image wet = sheet_of(3, 0.3, render::PressureScale{.max = 1e4}).image();
  EXPECT_EQ(wet.width, dry.width);
  ASSERT_GT(wet.height, dry.height);
  EXPECT_GT(ink(wet, 0, dry.height, wet.width, wet.height - dry.height), 2000);
}

TEST(ContactSheet, HasTheColumnsAskedForButNoneWithoutPictures) {
  const auto width = [](int count, std::optional<int> columns) {
    ContactSheet sheet(std::nullopt, columns);
    for (int i = 0; i < count; ++i) sheet.add(gray(i), i);
    return sheet.image().width;
  };
  EXPECT_EQ(width(6, 1), width(1, std::nullopt));
  EXPECT_EQ(width(6, 2), width(2, 2));
  EXPECT_EQ(width(24, 24) - width(24, 23), width(3, 2) - width(3, 1));
  EXPECT_EQ(width(3, 24), width(3, 3));
}

TEST(ContactSheet, KeepsManyPicturesEvenlySpacedFromTheFirst) {
  for (const int count : {1, 5, 24, 25, 26, 47, 48, 49, 100, 250}) {
    const std::vector<double> times = sheet_of(count, 0.5, std::nullopt).times();
    ASSERT_LE(times.size(), static_cast<std::size_t>(ContactSheet::kMostFrames)) << count;
    EXPECT_EQ(times.front(), 0);
    for (std::size_t i = 2; i < times.size(); ++i)
      EXPECT_DOUBLE_EQ(times[i] - times[i - 1], times[1]) << count;
    // The last picture shown is less than one spacing from the end.
    if (times.size() > 1) {
      EXPECT_GT(times.back() + times[1], 0.5 * (count - 1)) << count;
      EXPECT_GE(times.size(), std::min<std::size_t>(static_cast<std::size_t>(count), 12)) << count;
    }
  }
}

TEST(ContactSheet, ShowsTheFirstPictureAtItsTopLeftHoweverManyThereAre) {
  for (const int count : {1, 24, 25, 49, 200}) {
    const Image image = sheet_of(count, 0.5, std::nullopt).image();
    EXPECT_TRUE(image.at(40, 40) == gray(0).at(0, 0)) << count;
  }
}

TEST(ContactSheet, WithoutPicturesIsAnError) {
  EXPECT_THROW(ContactSheet(std::nullopt).image(), render::Error);
}

TEST(ContactSheet, OfAFallingBallIsWrittenToBeLookedAt) {
  pictures::Scene scene = pictures::gallery()[3];
  ContactSheet sheet(scene.picture.pressure);
  render::Renderer renderer(scene.picture, pictures::shader_folder());
  for (int i = 0; i < 12; ++i) {
    scene.states[0].position.z() = 1.1 - 0.245 * i;
    sheet.add(renderer.draw(scene.states, 0.06 * i), 0.06 * i);
  }
  std::filesystem::create_directories("gallery");
  const Image image = sheet.image();
  render::write_png(image, "gallery/sheet.png");
  EXPECT_EQ(render::read_png("gallery/sheet.png"), image);
}

}  // namespace

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <tuple>

#include "app/render/overlay.h"
#include "app/render/png.h"
#include "tests/render/pictures.h"

/// One of everything that can be drawn. The pictures are left in `gallery/` to be looked at.

namespace {

using pictures::Scene;

class Gallery : public testing::TestWithParam<Scene> {};

std::size_t color_count(const render::Image& image) {
  std::set<std::tuple<int, int, int>> colors;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const render::Rgb c = image.at(x, y);
      colors.insert({c.r, c.g, c.b});
    }
  return colors.size();
}

TEST_P(Gallery, DrawsTheSameShadedPictureTwice) {
  const Scene& scene = GetParam();
  render::Renderer renderer(scene.picture, pictures::shader_folder());
  render::Image image = renderer.draw(scene.states, scene.time);
  EXPECT_EQ(image, renderer.draw(scene.states, scene.time));
  EXPECT_EQ(image.width, scene.picture.width);
  EXPECT_EQ(image.height, scene.picture.height);
  // Shading alone gives hundreds of colours; a picture in which nothing is drawn is a gradient of
  // a few dozen.
  EXPECT_GT(color_count(image), 500u);
  render::add_overlay(image, pictures::scale_of(scene), scene.time);
  std::filesystem::create_directories("gallery");
  render::write_png(image, "gallery/" + scene.name + ".png");
}

INSTANTIATE_TEST_SUITE_P(All, Gallery, testing::ValuesIn(pictures::gallery()),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace

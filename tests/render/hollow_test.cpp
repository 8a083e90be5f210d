#include <gtest/gtest.h>

#include <array>

#include "app/render/renderer.h"
#include "tests/render/pictures.h"
#include "tests/support/hollows.h"

/// A hollow body seen from above: the open box of hollows.h, afloat.

namespace {

using pictures::Scene;
using render::Hollows;
using render::Image;
using Pixel = std::array<int, 3>;

constexpr int kSize = 200;

/// The box at a draught of 0.4 m, its mouth in the middle of the picture.
Scene box_from_above(Hollows hollows) {
  Scene scene{.name = "hollow"};
  scene.picture = {.width = kSize, .height = kSize};
  scene.picture.camera.from = {0, -0.01, 9};
  scene.picture.camera.to = {0, 0, 0};
  scene.picture.pressure.max = 10000;
  scene.picture.sea = hydro::Sea{};
  scene.picture.bodies = {{.mesh_B = hydro::translated(support::open_box(), {0, 0, -0.5}),
                           .color = {0.8, 0.6, 0.2},
                           .hollows = hollows}};
  scene.states.resize(1);
  scene.states[0].position.z() = 0.1;
  return scene;
}

/// The pixel in the middle of the picture, which shows the floor.
Pixel floor_of(const Scene& scene, const render::Interiors& interiors = {}) {
  const Image image =
      render::Renderer(scene.picture, pictures::shader_folder()).draw(scene.states, 0, interiors);
  const std::uint8_t* pixel = image.pixel(kSize / 2, kSize / 2);
  return {pixel[0], pixel[1], pixel[2]};
}

bool is_yellowish(const Pixel& c) { return c[0] > c[1] && c[1] > c[2] + 20; }

TEST(HollowPicture, AFloorThatIsDryHasTheColourOfTheBody) {
  EXPECT_TRUE(is_yellowish(floor_of(box_from_above(Hollows::flooding))));
  EXPECT_TRUE(is_yellowish(floor_of(box_from_above(Hollows::dry))));
  EXPECT_FALSE(is_yellowish(floor_of(box_from_above(Hollows::none))));
}

TEST(HollowPicture, WaterInsideShowsItsOwnPressure) {
  const Scene scene = box_from_above(Hollows::flooding);
  const auto water = [](double level) {
    return render::Interiors{{{.at_W = {0, 0, 0}, .level = level}}};
  };
  // The floor is at z = −0.35: water of 0.6 m stands higher than the sea.
  const Pixel shallow = floor_of(scene, water(-0.3)), deep = floor_of(scene, water(0.25));
  EXPECT_FALSE(is_yellowish(shallow));
  EXPECT_FALSE(is_yellowish(deep));
  EXPECT_GT(shallow[2], deep[2]);  // Turbo goes from blue to red.
  EXPECT_GT(deep[1], deep[2]);
}

TEST(HollowPicture, AFloodedHollowLooksLikeTheSea) {
  const Pixel flooded =
      floor_of(box_from_above(Hollows::flooding), {{{.at_W = {0, 0, 0}, .flooded = true}}});
  const Pixel wet = floor_of(box_from_above(Hollows::none));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(flooded[i], wet[i], 1);
}

TEST(HollowPicture, ADryHollowIsDryUntilItsWaterIsTold) {
  const Scene scene = box_from_above(Hollows::flooding);
  EXPECT_EQ(floor_of(scene), floor_of(scene, {{}}));
  EXPECT_NE(floor_of(scene), floor_of(scene, {{{.at_W = {0, 0, 0}, .level = 0}}}));
}

}  // namespace

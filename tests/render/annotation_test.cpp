#include "app/render/annotation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/render/renderer.h"

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using render::Image;
using render::Rgb;

constexpr Rgb kBlank = {200, 210, 220};
constexpr Rgb kRed = {255, 0, 0};

const render::Camera kCamera = {.from = {3, -7, 4}, .to = {1, 2, 0.5}, .field_of_view = 0.7};

TEST(PixelOf, HasThePointLookedAtInTheMiddle) {
  const Image image = render::filled_image(320, 200, kBlank);
  const render::View view = render::make_view(kCamera, 320, 200);
  EXPECT_LT((*render::pixel_of(view, image, kCamera.to) - Vector2d(160, 100)).norm(), 1e-9);
}

TEST(PixelOf, HasRaysThroughCornersThere) {
  const Image image = render::filled_image(320, 200, kBlank);
  const render::View view = render::make_view(kCamera, 320, 200);
  for (const double far : {1.0, 30.0}) {
    const Vector3d corner = view.eye_W + far * view.ray(-1, 1);
    EXPECT_LT(render::pixel_of(view, image, corner)->norm(), 1e-9);
    const Vector3d other = view.eye_W + far * view.ray(1, -1);
    EXPECT_LT((*render::pixel_of(view, image, other) - Vector2d(320, 200)).norm(), 1e-9);
  }
}

TEST(PixelOf, IsNoneBehindTheEye) {
  const Image image = render::filled_image(320, 200, kBlank);
  const render::View view = render::make_view(kCamera, 320, 200);
  EXPECT_FALSE(render::pixel_of(view, image, view.eye_W - view.forward_W));
}

TEST(Annotations, DrawAnArrowFromItsFootToItsTip) {
  Image image = render::filled_image(320, 240, kBlank);
  const render::View view = render::make_view(kCamera, 320, 240);
  const Vector3d to = kCamera.to + 1.5 * view.up_W;
  render::annotate(image, view, {.arrows = {{kCamera.to, to, kRed}}});
  const Vector2d tip = *render::pixel_of(view, image, to);
  for (const double part : {0.05, 0.3, 0.6, 0.9}) {
    const Vector2d p = Vector2d(160, 120) + part * (tip - Vector2d(160, 120));
    EXPECT_EQ(image.at(static_cast<int>(p.x()), static_cast<int>(p.y())), kRed) << part;
  }
  EXPECT_EQ(image.at(160, static_cast<int>(tip.y()) - 4), kBlank);
  EXPECT_EQ(image.at(160, 126), kBlank);
}

TEST(Annotations, LeaveAPictureWithoutAnyAsItIs) {
  Image image = render::filled_image(320, 240, kBlank);
  const Image before = image;
  const render::View view = render::make_view(kCamera, 320, 240);
  render::annotate(image, view, {});
  render::add_legend(image, view, {});
  EXPECT_EQ(image, before);
}

TEST(Annotations, BeyondThePictureAreCutOff) {
  Image image = render::filled_image(64, 48, kBlank);
  const render::View view = render::make_view(kCamera, 64, 48);
  const Vector3d far = kCamera.to + 200 * view.right_W;
  render::annotate(image, view, {.arrows = {{kCamera.to, far, kRed}}, .marks = {{far, "G", kRed}}});
  EXPECT_EQ(image.at(63, 24), kRed);
}

TEST(Line, CoversItsWidth) {
  Image image = render::filled_image(40, 40, kBlank);
  render::draw_line(image, {10, 20}, {30, 20}, 6, kRed);
  int rows = 0;
  for (int y = 0; y < 40; ++y) rows += image.at(20, y) == kRed;
  EXPECT_EQ(rows, 6);
}

}  // namespace

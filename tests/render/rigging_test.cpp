#include "app/render/rigging.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/render/annotation.h"
#include "app/render/gl_rigging.h"
#include "app/render/part_meshes.h"
#include "hydro/mesh/primitives.h"
#include "tests/render/pictures.h"
#include "tests/support/tolerance.h"

/// Lines and parts in pictures.

namespace {

using Eigen::Vector3d;
using render::Image;
using render::Rgb;

const Vector3d kPaint = {0.9, 0.05, 0.05};

/// Looks along +y from 10 m away at a region 3 m high and 4 m wide; nothing is there.
render::SceneDescription empty_picture() {
  render::SceneDescription picture = pictures::ball_seen_level(0).picture;
  picture.bodies.clear();
  picture.sea.reset();
  return picture;
}

Image draw(const render::SceneDescription& picture, const render::Rigging& rigging) {
  return render::Renderer(picture, pictures::shader_folder()).draw({}, 0, {}, rigging);
}

render::Tube straight(const Vector3d& from, const Vector3d& to, double radius) {
  Eigen::Matrix3Xd points(3, 2);
  points << from, to;
  return {.points_W = points, .radius = radius, .color = kPaint};
}

bool is_red(Rgb c) { return c.r > 1.6 * c.g && c.r > 1.6 * c.b; }

int red_in_row(const Image& image, int y) {
  int count = 0;
  for (int x = 0; x < image.width; ++x) count += is_red(image.at(x, y));
  return count;
}

int red_pixels(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) count += red_in_row(image, y);
  return count;
}

TEST(Rigging, ShowsATautLineWhereItIs) {
  // 80 pixels to a metre at the distance of the line.
  const Image image =
      draw(empty_picture(), {.tubes = {straight({0.5, 0, -1}, {0.5, 0, 1}, 0.05)}, .parts = {}});
  for (int y = 45; y < 195; y += 10) {
    EXPECT_TRUE(is_red(image.at(200, y))) << y;
    EXPECT_NEAR(red_in_row(image, y), 8, 2) << y;
    EXPECT_FALSE(is_red(image.at(190, y))) << y;
    EXPECT_FALSE(is_red(image.at(210, y))) << y;
  }
  EXPECT_EQ(red_in_row(image, 35), 0);
  EXPECT_EQ(red_in_row(image, 205), 0);
}

TEST(Rigging, ShowsALineHoweverThinAndFarItIs) {
  render::SceneDescription picture = empty_picture();
  for (const double distance : {1.0, 10.0, 1000.0}) {
    picture.camera.from = {0, -distance, 0};
    const double half = 0.1 * distance;
    const Image image =
        draw(picture, {.tubes = {straight({0, 0, -half}, {0, 0, half}, 1e-6)}, .parts = {}});
    for (int y = 50; y < 190; y += 20) {
      EXPECT_GE(red_in_row(image, y), 2) << distance << " " << y;
      EXPECT_LE(red_in_row(image, y), 4) << distance << " " << y;
    }
  }
}

TEST(Rigging, ThickensALineTowardItsFarEndOnly) {
  const render::View view = render::make_view({.from = {0, 0, 0}, .to = {0, 10, 0}}, 320, 240);
  const hydro::TriMesh mesh =
      render::drawn_tube(straight({0, 1, 0}, {0, 100, 0}, 0.05), view, 0.001);
  const auto radius = [&](int ring) {
    const Vector3d p = mesh.vertices.col(ring * render::kTubeSides);
    return std::hypot(p.x(), p.z());
  };
  EXPECT_NEAR(radius(0), 0.05, support::tolerance(1e-12));
  EXPECT_NEAR(radius(1), 0.1, support::tolerance(1e-12));
}

TEST(Rigging, IsSeenThroughTheWater) {
  render::SceneDescription picture = empty_picture();
  picture.camera.from = {0, -10, 4};
  const render::Rigging line = {.tubes = {straight({0, 0, -1.2}, {0, 0, 1}, 0.05)}, .parts = {}};
  const auto color_at = [&](double z) {
    const Image image = draw(picture, line);
    const render::View view = render::make_view(picture.camera, image.width, image.height);
    const Eigen::Vector2d p = *render::pixel_of(view, image, {0, -0.05, z});
    return image.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
  };
  const Rgb dry = color_at(-1);
  picture.sea = hydro::Sea{};
  picture.water_visible = true;
  const Rgb wet = color_at(-1), above = color_at(0.5);
  EXPECT_TRUE(is_red(dry));
  EXPECT_TRUE(is_red(above));
  EXPECT_LT(wet.r, dry.r - 20);
  EXPECT_GT(wet.b, dry.b + 20);
  EXPECT_GT(wet.r, wet.g);
}

TEST(Rigging, HasNoColoursOfPressure) {
  // The same part in air and, under water that is not drawn, in the sea.
  const auto box = std::make_shared<const hydro::TriMesh>(hydro::make_box({1, 1, 1}));
  Eigen::Isometry3d pose(Eigen::Translation3d(0, 0, -0.8));
  const render::Rigging rigging = {.tubes = {},
                                   .parts = {{.mesh_P = box, .X_WP = pose, .color = kPaint}}};
  render::SceneDescription picture = empty_picture();
  const Image dry = draw(picture, rigging);
  picture.sea = hydro::Sea{};
  EXPECT_GT(red_pixels(dry), 2000);
  EXPECT_EQ(draw(picture, rigging), dry);
}

TEST(Rigging, TurnsAPartWithItsPose) {
  const auto plate = std::make_shared<const hydro::TriMesh>(render::wing_mesh(1, 1, 0.05));
  const auto width = [&](double angle) {
    Eigen::Isometry3d pose(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
    return red_in_row(
        draw(empty_picture(),
             {.tubes = {}, .parts = {{.mesh_P = plate, .X_WP = pose, .color = kPaint}}}),
        120);
  };
  // The chord of 1 m spans 80 pixels across the view, and half of that at 60 degrees.
  EXPECT_NEAR(width(0), 80, 3);
  EXPECT_NEAR(width(M_PI / 3), 40, 4);
}

TEST(Rigging, OfNothingLeavesAPictureAsItIs) {
  const pictures::Scene scene = pictures::gallery().front();
  render::Renderer renderer(scene.picture, pictures::shader_folder());
  const Image bare = renderer.draw(scene.states, scene.time);
  renderer.draw(scene.states, scene.time, {},
                {.tubes = {straight({0, 0, 0}, {0, 0, 2}, 0.1)}, .parts = {}});
  EXPECT_EQ(renderer.draw(scene.states, scene.time), bare);
}

TEST(Legend, OfARampHasItsColoursFromLeftToRight) {
  Image image = render::filled_image(640, 480, {255, 255, 255});
  render::Annotations notes;
  notes.ramp = render::LegendRamp{.name = "tension 0 to 120 kN",
                                  .colors = {{0, 0, 255}, {0, 255, 0}, {255, 0, 0}}};
  render::add_legend(image, {}, notes);
  std::vector<Rgb> seen;
  for (int y = 400; y < 480 && seen.empty(); ++y)
    for (int x = 0; x < 120; ++x) {
      const Rgb c = image.at(x, y);
      const bool pure = (c.r == 255) + (c.g == 255) + (c.b == 255) == 1 &&
                        (c.r == 0) + (c.g == 0) + (c.b == 0) == 2;
      if (pure && (seen.empty() || !(seen.back() == c))) seen.push_back(c);
    }
  EXPECT_EQ(seen, notes.ramp->colors);
}

}  // namespace

#include "app/render/water_grid.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "app/render/renderer.h"
#include "app/render/shaded_mesh.h"
#include "hydro/wave_spectrum.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using render::Camera;
using render::View;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

bool inside(const render::PolarGrid& grid, const Eigen::Matrix3Xi& triangles, const Vector2d& p) {
  for (const auto t : triangles.colwise()) {
    const Vector2d a = grid.points_W.col(t[0]), b = grid.points_W.col(t[1]),
                   c = grid.points_W.col(t[2]);
    const double u = cross(b - a, p - a), v = cross(c - b, p - b), w = cross(a - c, p - c);
    if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) return true;
  }
  return false;
}

std::vector<Camera> cameras() {
  return {{.from = {6, -8, 3}, .to = {0, 0, 0}},
          {.from = {0, 0, 12}, .to = {0, 0, 0}},
          {.from = {5, 5, 0.3}, .to = {-20, 3, 1}},
          {.from = {2, 3, -4}, .to = {1, 8, -2}},
          {.from = {40, -3, 30}, .to = {0, 0, 0}},
          {.from = {1, 1, -5}, .to = {1.5, 1, 0}},
          {.from = {-9, 4, 6}, .to = {2, 1, 5}, .field_of_view = 1.2}};
}

TEST(View, PutsThePointLookedAtInTheMiddleAndWorldsUpUp) {
  for (const Camera& camera : cameras()) {
    const View view = render::make_view(camera, 960, 720);
    const Vector3d to_E = camera.to - camera.from;
    const Eigen::Vector4d clip = view.clip_from_E * to_E.homogeneous();
    EXPECT_NEAR(clip.x() / clip.w(), 0, support::tolerance(1e-12));
    EXPECT_NEAR(clip.y() / clip.w(), 0, support::tolerance(1e-12));
    EXPECT_GE(view.up_W.z(), 0);
    EXPECT_NEAR(view.right_W.z(), 0, support::tolerance(1e-15));
  }
}

TEST(View, ProjectsARayBackToItsPlaceInThePicture) {
  support::Random random(11);
  for (const Camera& camera : cameras()) {
    const View view = render::make_view(camera, 640, 360);
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const Eigen::Vector4d clip = view.clip_from_E * (3 * view.ray(x, y)).homogeneous();
    EXPECT_NEAR(clip.x() / clip.w(), x, support::tolerance(1e-12));
    EXPECT_NEAR(clip.y() / clip.w(), y, support::tolerance(1e-12));
  }
}

TEST(PolarGrid, FillsThePictureWhereverTheSurfaceMayBe) {
  const render::Slab slab{.level = 0, .lowest = -0.25, .highest = 0.25};
  support::Random random(12);
  for (const Camera& camera : cameras()) {
    const View view = render::make_view(camera, 960, 720);
    const render::PolarGrid grid =
        render::make_polar_grid(view, slab, {.length = 0.2, .angle = 0.01, .columns = 80});
    const Eigen::Matrix3Xi triangles = grid.triangles();
    for (int i = 0; i < 100; ++i) {
      const Vector3d ray = view.ray(random.uniform(-1, 1), random.uniform(-1, 1));
      const double z = random.uniform(slab.lowest, slab.highest);
      const double along = (z - view.eye_W.z()) / ray.z();
      if (along <= view.near || along > 50 * view.distance) continue;
      const Vector2d p = (view.eye_W + along * ray).head<2>();
      EXPECT_TRUE(inside(grid, triangles, p)) << camera.from.transpose() << ": " << p.transpose();
    }
  }
}

TEST(PolarGrid, BoundsItsRowsHoweverShortTheWaves) {
  const View view = render::make_view({}, 960, 720);
  const render::PolarGrid grid =
      render::make_polar_grid(view, {.level = 0, .lowest = -1, .highest = 1},
                              {.length = 1e-3, .angle = 1e-6, .columns = 9});
  EXPECT_LE(grid.rows, 320);
  EXPECT_GT(grid.rows, 200);
  EXPECT_EQ(grid.points_W.cols(), Index{9} * grid.rows);
}

TEST(WaterSurface, HasTheSeasHeightsAndSlopesWhereItsCellsAreSmall) {
  hydro::Sea sea{.level = 2};
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.3, 9, 0.7, 0.2, sea.gravity),
                                    hydro::deep_water_wave(0.2, 7, -0.4, 1, sea.gravity)}};
  const View view = render::make_view({.from = {6, -8, 5}, .to = {0, 0, 2}}, 960, 720);
  const render::WaterSurface surface(sea, view, 0.4);
  const double time = 1.7;
  const Eigen::MatrixXf vertices = surface.vertices(time);
  int compared = 0;
  for (Index i = 0; i < vertices.cols(); ++i) {
    if (surface.grid().cell[static_cast<std::size_t>(i / surface.grid().columns)] > 0.5) continue;
    const Vector3d p_W = vertices.col(i).head<3>().cast<double>() + view.eye_W;
    // Single precision of lengths up to some 100 m.
    EXPECT_NEAR(p_W.z(), hydro::surface_height(sea, p_W.x(), p_W.y(), time),
                support::tolerance(1e-4));
    // A central difference over 2 x 0.4 m: (k d)^2 / 6 of the slope, 2 %; one-sided at the border
    // k d / 2, 18 % of at most 0.39.
    const Vector2d slope = hydro::surface_slope(sea, p_W.x(), p_W.y(), time);
    EXPECT_LT((vertices.col(i).tail<2>().cast<double>() - slope).norm(), support::tolerance(0.07));
    ++compared;
  }
  EXPECT_GT(compared, 1000);
}

TEST(WaterSurface, LeavesOutWavesThatItsCellsCannotShow) {
  hydro::Sea sea;
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.1, 0.5, 0, 0, sea.gravity)}};
  const View view = render::make_view({.from = {0, -80, 20}, .to = {0, 0, 0}}, 960, 720);
  const render::WaterSurface surface(sea, view, 0.05);
  const Eigen::MatrixXf vertices = surface.vertices(0);
  EXPECT_NEAR(vertices.row(2).maxCoeff(), -20, support::tolerance(1e-5));
  EXPECT_NEAR(vertices.row(2).minCoeff(), -20, support::tolerance(1e-5));
}

}  // namespace

#include "hydro/sea.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hydro/loads/refine.h"
#include "hydro/wave_spectrum.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using hydro::Sea;

Sea wave_sea() {
  return {.level = 2,
          .surface = hydro::WaveSurface{{hydro::deep_water_wave(0.5, 12, 0.3, 1, 9.80665),
                                         hydro::deep_water_wave(0.2, 5, -2, 0, 9.80665)}}};
}

Sea grid_sea() {
  Eigen::MatrixXd heights = Eigen::MatrixXd::Zero(2, 3);
  heights << 0, 1, 4,  //
      2, 3, 8;
  return {.level = 10, .surface = hydro::make_height_field(heights, 0.5, {1, 2})};
}

TEST(Surface, OfStillWaterIsItsLevel) {
  EXPECT_EQ(hydro::surface_height({.level = 1.5}, 7, -3, 2), 1.5);
  EXPECT_EQ(hydro::surface_slope({.level = 1.5}, 7, -3, 2), Vector2d::Zero());
}

TEST(Surface, OfAWaveTravelsAtTheDispersionSpeed) {
  const double wavelength = 12, heading = 0.7;
  const Sea sea{.surface = hydro::WaveSurface{
                    {hydro::deep_water_wave(0.3, wavelength, heading, 0, 9.80665)}}};
  const double speed = std::sqrt(9.80665 * wavelength / (2 * M_PI));
  const Vector2d along(std::cos(heading), std::sin(heading));
  EXPECT_DOUBLE_EQ(hydro::surface_height(sea, 0, 0, 0), 0.3);
  for (const double time : {0.1, 1.0, 7.0}) {
    const Vector2d crest = speed * time * along;
    EXPECT_NEAR(hydro::surface_height(sea, crest.x(), crest.y(), time), 0.3, 1e-12);
    const Vector2d trough = crest + wavelength / 2 * along;
    EXPECT_NEAR(hydro::surface_height(sea, trough.x(), trough.y(), time), -0.3, 1e-12);
  }
}

TEST(Surface, OfAGridIsBilinearWithRowsAlongY) {
  const Sea sea = grid_sea();
  EXPECT_DOUBLE_EQ(hydro::surface_height(sea, 1, 2, 0), 10);
  EXPECT_DOUBLE_EQ(hydro::surface_height(sea, 2, 2, 0), 14);    // last column, first row
  EXPECT_DOUBLE_EQ(hydro::surface_height(sea, 1, 2.5, 0), 12);  // first column, last row
  EXPECT_DOUBLE_EQ(hydro::surface_height(sea, 1.75, 2.25, 0), 10 + (1 + 4 + 3 + 8) / 4.0);
}

TEST(Surface, OutsideAGridIsThatOfItsNearestEdge) {
  const Sea sea = grid_sea();
  EXPECT_DOUBLE_EQ(hydro::surface_height(sea, -100, 2.25, 0), 11);
  EXPECT_DOUBLE_EQ(hydro::surface_height(sea, 1e9, 1e9, 0), 18);
  EXPECT_EQ(hydro::surface_slope(sea, 1e9, 1e9, 0), Vector2d::Zero());
}

TEST(Surface, SlopeIsTheDerivativeOfTheHeight) {
  support::Random random(41);
  for (const Sea& sea : {wave_sea(), grid_sea()}) {
    for (int i = 0; i < 50; ++i) {
      const double x = random.uniform(1.02, 1.48), y = random.uniform(2.02, 2.48), t = 3;
      const double d = 1e-5;  // central differences err by d² times the third derivative
      const Vector2d slope = hydro::surface_slope(sea, x, y, t);
      EXPECT_NEAR(
          slope.x(),
          (hydro::surface_height(sea, x + d, y, t) - hydro::surface_height(sea, x - d, y, t)) /
              (2 * d),
          support::tolerance(1e-9));
      EXPECT_NEAR(
          slope.y(),
          (hydro::surface_height(sea, x, y + d, t) - hydro::surface_height(sea, x, y - d, t)) /
              (2 * d),
          support::tolerance(1e-9));
    }
  }
}

TEST(Surface, NeverLeavesItsBounds) {
  support::Random random(42);
  for (const Sea& sea : {wave_sea(), grid_sea()}) {
    const hydro::SurfaceBounds bounds = hydro::surface_bounds(sea);
    for (int i = 0; i < 500; ++i) {
      const double height = hydro::surface_height(sea, random.uniform(-50, 50),
                                                  random.uniform(-50, 50), random.uniform(0, 9));
      EXPECT_GE(height, bounds.lowest);
      EXPECT_LE(height, bounds.highest);
    }
  }
}

TEST(HeightField, RefusesWhatIsNoGrid) {
  EXPECT_THROW(hydro::make_height_field({}, 1, {0, 0}), std::invalid_argument);
  EXPECT_THROW(hydro::make_height_field(Eigen::MatrixXd::Zero(2, 2), 0, {0, 0}),
               std::invalid_argument);
  Eigen::MatrixXd bad = Eigen::MatrixXd::Zero(2, 2);
  bad(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(hydro::make_height_field(bad, 1, {0, 0}), std::invalid_argument);
}

TEST(SurfaceSampler, SplitsPanelsUntilTheSurfaceIsLinearOverThem) {
  support::Random random(43);
  Eigen::MatrixXd bumps(20, 20);
  for (Eigen::Index i = 0; i < bumps.size(); ++i) bumps(i) = random.uniform(-1, 1);
  Sea grid{.surface = hydro::make_height_field(bumps, 1, {-10, -10})};
  const double deviations[] = {std::sqrt(0.5 * 0.25 + 0.5 * 0.04),
                               std::get<hydro::HeightField>(grid.surface).deviation};
  int number = 0;
  for (const Sea& sea : {wave_sea(), grid}) {
    const Vector3d position = random.vector(3);
    const hydro::SurfaceSampler surface(sea, position, 0.5, 1e-3);
    const hydro::Panel panel = {random.vector(5), random.vector(5), random.vector(5)};
    Vector3d heights;
    for (int i = 0; i < 3; ++i) heights[i] = surface.elevation(panel[i]);
    Vector3d area = Vector3d::Zero();
    int pieces = 0;
    hydro::for_each_linear_piece(
        panel, heights, surface, [&](const hydro::Panel& piece, const Vector3d& elevation) {
          ++pieces;
          area += hydro::area_vector(piece);
          const Vector3d centre = (piece[0] + piece[1] + piece[2]) / 3;
          // Inside a piece the surface may sag a little more than along its edges.
          EXPECT_NEAR(surface.elevation(centre), elevation.mean(),
                      support::tolerance(4) * hydro::kSagTolerance * deviations[number]);
        });
    EXPECT_GT(pieces, 10);
    EXPECT_LT((area - hydro::area_vector(panel)).norm(), support::tolerance(1e-12));
    ++number;
  }
}

TEST(SurfaceSampler, LeavesAPanelWholeOnStillWaterAndOnAPlane) {
  Eigen::MatrixXd plane(30, 30);
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < 30; ++column) plane(row, column) = 0.1 * row - 0.2 * column;
  const Sea sloping{.surface = hydro::make_height_field(plane, 1, {-15, -15})};
  for (const Sea& sea : {Sea{}, sloping}) {
    const hydro::SurfaceSampler surface(sea, Vector3d::Zero(), 0, 1e-3);
    EXPECT_FALSE(surface.bends_between({-9, 3, 0}, {8, -7, 2}));
  }
}

/// m_n / m_0 of a set of waves over ω, ω in units of `peak`.
double moment(const hydro::WaveSurface& sea, int order, double peak) {
  double m0 = 0, mn = 0;
  for (const auto& w : sea.components) {
    m0 += w.amplitude * w.amplitude;
    mn += w.amplitude * w.amplitude * std::pow(w.omega / peak, order);
  }
  return mn / m0;
}

TEST(Jonswap, HasItsSignificantHeightExactly) {
  for (const int components : {1, 7, 64, 300}) {
    const auto sea =
        hydro::jonswap_sea({.significant_height = 1.7, .spreading = 5, .components = components},
                           {.gravity = 9.80665});
    double variance = 0;
    for (const auto& w : sea.components) variance += w.amplitude * w.amplitude / 2;
    EXPECT_EQ(sea.components.size(), components);
    EXPECT_NEAR(4 * std::sqrt(variance), 1.7, 1e-12);
  }
}

TEST(Jonswap, HasTheMeanPeriodsOfTheSpectrum) {
  // T01/Tp and T02/Tp by quadrature of the spectrum to 60 rad/s; the sea takes each band at its
  // mean frequency, which keeps T01 and costs the tail's part of T02.
  const double table[][3] = {
      {1, 0.771773, 0.710420}, {3.3, 0.834329, 0.777441}, {7, 0.877476, 0.828533}};
  for (const auto& [gamma, t01, t02] : table) {
    const auto sea = hydro::jonswap_sea({.peak_period = 8, .gamma = gamma, .components = 500},
                                        {.gravity = 9.80665});
    const double peak = 2 * M_PI / 8;
    EXPECT_NEAR(1 / moment(sea, 1, peak), t01, support::tolerance(5e-4));
    EXPECT_NEAR(1 / std::sqrt(moment(sea, 2, peak)), t02, support::tolerance(0.01));
  }
}

TEST(Jonswap, SpreadsAboutItsHeadingAsTheCosinePowerSays) {
  // The mean of cos θ under cos^2s(θ/2) is s/(s+1).
  const double s = 6, heading = 1.1;
  const auto sea = hydro::jonswap_sea(
      {.heading = heading, .spreading = s, .seed = 3, .components = 1000}, {.gravity = 9.80665});
  double cosine = 0, sine = 0;
  for (const auto& w : sea.components) {
    const double theta = std::atan2(w.ky, w.kx) - heading;
    cosine += std::cos(theta) / 1000;
    sine += std::sin(theta) / 1000;
  }
  EXPECT_NEAR(cosine, s / (s + 1), support::tolerance(1e-3));
  EXPECT_NEAR(sine, 0, support::tolerance(1e-3));
}

TEST(Jonswap, WithoutSpreadingIsLongCrested) {
  for (const auto& w : hydro::jonswap_sea({.heading = 0.5}, {.gravity = 9.80665}).components)
    EXPECT_NEAR(std::atan2(w.ky, w.kx), 0.5, 1e-12);
}

TEST(Jonswap, DependsOnItsSeedAlone) {
  const auto height = [](int seed) {
    const Sea sea{.surface =
                      hydro::jonswap_sea({.spreading = 4, .seed = seed}, {.gravity = 9.80665})};
    return hydro::surface_height(sea, 3, 4, 5);
  };
  EXPECT_EQ(height(1), height(1));
  EXPECT_NE(height(1), height(2));
}

}  // namespace

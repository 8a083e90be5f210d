#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/render/view.h"
#include "hydro/airy_waves.h"
#include "hydro/mesh/primitives.h"
#include "tests/render/pictures.h"
#include "tests/support/tolerance.h"

/// What the colours on a ball say, at places that pinhole projection gives.

namespace {

using pictures::Scene;
using render::Image;
using render::Rgb;

// The camera of `ball_seen_level`: 10 m away, 120 pixels for a slope of 0.15.
constexpr double kDistance = 10;
constexpr double kPixelsPerSlope = 120 / 0.15;
constexpr double kMiddleRow = 120;
constexpr int kMiddleColumn = 160;

constexpr double kWeight = 1000 * 9.80665;  // of still water of the default density [N/m^3]

/// Row in the middle column at which the ball's front shows the height z above its middle.
double row_of_height(double z) {
  return kMiddleRow - kPixelsPerSlope * z / (kDistance - std::sqrt(1 - z * z));
}

/// Height above the ball's middle that a row of the middle column shows: the near root of the
/// ray's meeting with the unit sphere.
double height_of_row(int row) {
  const double slope = (kMiddleRow - row - 0.5) / kPixelsPerSlope;
  const double a = 1 + slope * slope;
  const double along =
      (kDistance - std::sqrt(kDistance * kDistance - a * (kDistance * kDistance - 1))) / a;
  return slope * along;
}

Scene ball_in_water_to(double level) {
  Scene scene = pictures::ball_seen_level(0);
  scene.picture.sea->level = level;
  return scene;
}

int brightness(Rgb c) { return c.r + c.g + c.b; }

/// The brightest row of the middle column between two rows: the white line between the colours.
int brightest_row(const Image& image, int first, int last) {
  int best = first;
  for (int row = first; row <= last; ++row)
    if (brightness(image.at(kMiddleColumn, row)) > brightness(image.at(kMiddleColumn, best)))
      best = row;
  return best;
}

constexpr double kScaleEnd = 10e3;  // [Pa]

// The scale has 256 colours for 10 kPa, 39 Pa each, of which a few neighbours look the same; a flat
// panel lies up to 2 mm (20 Pa) inside the ball.
constexpr double kReading = 140;

// Two colours between which the device interpolates, and the rounding of the channels [of 255].
constexpr double kSameColor = 3;

/// Largest difference of the pressures that the ball's wet front shows from `expected(height)`, as
/// far as these are on the scale.
template <class Pressure>
double largest_error(const Scene& scene, double level, Pressure&& expected) {
  const Image image = pictures::draw(scene);
  double largest = 0;
  // Three pixels from the waterline its line is over; below -0.9 a pixel spans much of the scale.
  for (int row = static_cast<int>(row_of_height(level)) + 3; row < row_of_height(-0.9); ++row) {
    const double pressure = expected(height_of_row(row));
    if (pressure < 0 || pressure > kScaleEnd) continue;
    const pictures::Reading shown =
        pictures::read_color(scene.picture.pressure, image.at(kMiddleColumn, row));
    largest = std::max(largest, std::abs(shown.pressure - pressure));
    EXPECT_LT(shown.apart, kSameColor) << row;
  }
  return largest;
}

TEST(Waterline, LiesOnTheRowThatProjectionGives) {
  for (const double level : {-0.62, -0.3, -0.05, 0.17, 0.44}) {
    const Image image = pictures::draw(ball_in_water_to(level));
    const double row = row_of_height(level);
    const int found = brightest_row(image, static_cast<int>(row) - 8, static_cast<int>(row) + 8);
    EXPECT_NEAR(found + 0.5, row, support::tolerance(1.0)) << level;
  }
}

TEST(Waterline, IsSharpOnBigTriangles) {
  // A box of 12 triangles: colours of the two sides must not run into each other.
  Scene scene = ball_in_water_to(0.2);
  scene.picture.bodies[0].mesh_B = hydro::make_box({1.6, 1.6, 1.6});
  scene.picture.camera.from.z() = 0;
  const Image image = pictures::draw(scene);
  const double row = kMiddleRow - kPixelsPerSlope * 0.2 / (kDistance - 0.8);
  const int found = brightest_row(image, static_cast<int>(row) - 8, static_cast<int>(row) + 8);
  EXPECT_NEAR(found + 0.5, row, support::tolerance(1.0));
  const Rgb above = image.at(kMiddleColumn, found - 3), below = image.at(kMiddleColumn, found + 3);
  EXPECT_GT(above.r, above.b);
  EXPECT_GT(below.b, below.r);
}

TEST(BodyColor, IsItsOwnAboveTheWater) {
  Scene scene = ball_in_water_to(-0.2);
  for (const Eigen::Vector3d& color :
       {Eigen::Vector3d(0.8, 0.6, 0.2), Eigen::Vector3d(0.2, 0.7, 0.4)}) {
    scene.picture.bodies[0].color = color;
    const Rgb c = pictures::draw(scene).at(kMiddleColumn, static_cast<int>(row_of_height(0.1)));
    const Eigen::Vector3d shown = Eigen::Vector3d(c.r, c.g, c.b).normalized();
    // Sheen and rim add a little white: at most 0.1 of a colour of length about 1.
    EXPECT_LT((shown - color.normalized()).norm(), support::tolerance(0.1));
  }
}

TEST(BodyColor, IsItsOwnEverywhereInADryScene) {
  Scene scene = ball_in_water_to(0);
  scene.picture.sea.reset();
  const Image image = pictures::draw(scene);
  for (const double z : {-0.8, -0.4, 0.0, 0.4}) {
    const Rgb c = image.at(kMiddleColumn, static_cast<int>(row_of_height(z)));
    EXPECT_GT(c.r, c.g) << z;
    EXPECT_GT(c.g, c.b) << z;
  }
}

TEST(BodyColor, IsItsOwnUnderWaterWithoutPressures) {
  Scene scene = ball_in_water_to(0.2);
  scene.picture.pressure_visible = false;
  Scene dry = scene;
  dry.picture.sea.reset();
  EXPECT_EQ(pictures::draw(scene), pictures::draw(dry));
}

TEST(Waterline, IsTheSameWithoutPressuresIfItIsBold) {
  constexpr int kWidth = 4;  // [px], and one for its soft edges
  Scene scene = ball_in_water_to(0.2);
  scene.picture.bold_waterline = true;
  const Image colored = pictures::draw(scene);
  scene.picture.pressure_visible = false;
  const Image plain = pictures::draw(scene);
  scene.picture.bold_waterline = false;
  const Image bare = pictures::draw(scene);
  const int row = static_cast<int>(row_of_height(0.2));
  EXPECT_EQ(plain.at(kMiddleColumn, row), colored.at(kMiddleColumn, row));
  EXPECT_NE(plain.at(kMiddleColumn, row), bare.at(kMiddleColumn, row));
  for (const int off : {row - kWidth, row + kWidth})
    EXPECT_EQ(plain.at(kMiddleColumn, off), bare.at(kMiddleColumn, off));
}

TEST(PressureColor, ReadsBackAsTheWeightOfWaterAbove) {
  for (const double level : {0.0, 0.5}) {
    const double error = largest_error(ball_in_water_to(level), level,
                                       [&](double z) { return kWeight * (level - z); });
    EXPECT_LT(error, support::tolerance(kReading)) << level;
  }
}

TEST(PressureColor, AddsTheDragsPressureByTheSpeedAlongTheNormal) {
  constexpr double kDrag = 0.6316;
  for (const double speed : {-2.5, 1.5}) {
    Scene scene = ball_in_water_to(0.2);
    scene.picture.bodies[0].coefficients.pressure_drag = {kDrag, kDrag};
    scene.states[0].linear_velocity = {0, 0, speed};
    const double error = largest_error(scene, 0.2, [&](double z) {
      const double along_normal = speed * z;  // a unit ball's normal is its point
      const double dynamic = 0.5 * 1000 * kDrag * along_normal * std::abs(along_normal);
      return kWeight * (0.2 - z) + dynamic;
    });
    EXPECT_LT(error, support::tolerance(kReading)) << speed;
  }
}

/// The ball's middle 0.1 m below the level of a sea with one wave along the line of sight.
Scene ball_in_a_wave() {
  Scene scene = ball_in_water_to(0.1);
  hydro::Sea& sea = *scene.picture.sea;
  sea.current = {0.3, -0.2, 0.1};
  sea.surface = hydro::WaveSurface{{hydro::linear_wave(sea, 0.4, 2 * M_PI / 8, M_PI / 2, 0.3)}};
  scene.states[0].linear_velocity = sea.current;
  scene.time = 0.2;
  return scene;
}

/// The ball's front at a height, in the middle column.
Eigen::Vector3d front(double z) { return {0, -std::sqrt(1 - z * z), z}; }

/// Height at which the ball's front meets the water.
double waterline(const Scene& scene) {
  double low = -1, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double z = (low + high) / 2;
    const double y = front(z).y();
    (hydro::surface_height(*scene.picture.sea, 0, y, scene.time) > z ? low : high) = z;
  }
  return low;
}

TEST(PressureColor, InWavesIsThatOfTheWaterAtThePlace) {
  Scene scene = ball_in_a_wave();
  scene.picture.pressure.shows = render::Pressure::hydrostatic;
  const double top = waterline(scene);
  const hydro::Sea& sea = *scene.picture.sea;
  const auto depth = [&](double z) {
    return hydro::surface_height(sea, 0, front(z).y(), scene.time) - z;
  };
  const auto head = [&](double z) { return hydro::water_at(sea, front(z), scene.time).head; };
  EXPECT_LT(largest_error(scene, top, [&](double z) { return kWeight * head(z); }),
            support::tolerance(kReading));
  EXPECT_GT(largest_error(scene, top, [&](double z) { return kWeight * depth(z); }), 1000);
  std::get<hydro::WaveSurface>(scene.picture.sea->surface).kinematics =
      hydro::Kinematics::hydrostatic;
  EXPECT_LT(largest_error(scene, top, [&](double z) { return kWeight * depth(z); }),
            support::tolerance(kReading));
}

TEST(PressureColor, OfDragIsByTheSpeedThroughTheWaterOfTheWaves) {
  constexpr double kDrag = 12;  // makes much of small speeds
  Scene scene = ball_in_a_wave();
  scene.picture.bodies[0].coefficients.pressure_drag = {kDrag, kDrag};
  scene.picture.pressure.shows = render::Pressure::dynamic;
  const hydro::Sea& sea = *scene.picture.sea;
  double highest = 0;
  const auto dynamic = [&](double z) {
    const Eigen::Vector3d flow = hydro::water_at(sea, front(z), scene.time).velocity;
    const double u = (scene.states[0].linear_velocity - flow).dot(front(z));
    const double pressure = 0.5 * 1000 * kDrag * u * std::abs(u);
    highest = std::max(highest, pressure);
    return pressure;
  };
  EXPECT_LT(largest_error(scene, waterline(scene), dynamic), support::tolerance(kReading));
  EXPECT_GT(highest, 3000);
}

TEST(PressureColor, ShowsOnePartOfThePressureWhereAsked) {
  constexpr double kDrag = 0.6316, kSpeed = -4;
  Scene scene = ball_in_water_to(0.2);
  scene.picture.bodies[0].coefficients.pressure_drag = {kDrag, kDrag};
  scene.states[0].linear_velocity = {0, 0, kSpeed};
  scene.picture.pressure.shows = render::Pressure::hydrostatic;
  EXPECT_LT(largest_error(scene, 0.2, [&](double z) { return kWeight * (0.2 - z); }),
            support::tolerance(kReading));
  scene.picture.pressure.shows = render::Pressure::dynamic;
  const auto dynamic = [&](double z) {
    return 0.5 * 1000 * kDrag * kSpeed * z * std::abs(kSpeed * z);
  };
  EXPECT_LT(largest_error(scene, 0.2, dynamic), support::tolerance(kReading));
}

TEST(Waterline, IsDrawnBoldWhereAsked) {
  Scene scene = ball_in_water_to(0.17);
  scene.picture.bold_waterline = true;
  const Image image = pictures::draw(scene);
  const double row = row_of_height(0.17);
  int pink = 0;
  for (int y = 0; y < image.height; ++y) {
    const Rgb c = image.at(kMiddleColumn, y);
    if (c.r < c.g + 100 || c.b < c.g + 50) continue;
    ++pink;
    EXPECT_NEAR(y + 0.5, row, 3);
  }
  EXPECT_GE(pink, 3);
}

/// Of a box of 12 triangles: each side has its diagonal, and no other line in its middle.
TEST(Wireframe, ShowsTheEdgesOfTheMesh) {
  Scene scene = ball_in_water_to(0);
  scene.picture.sea.reset();
  scene.picture.bodies[0].mesh_B = hydro::make_box({1.6, 1.6, 1.6});
  scene.picture.camera.from.z() = 0;
  const Image plain = pictures::draw(scene);
  scene.picture.wireframe = true;
  const Image lined = pictures::draw(scene);
  const int half = static_cast<int>(kPixelsPerSlope * 0.8 / (kDistance - 0.8));
  int darker = 0;
  for (int x = kMiddleColumn - half / 2; x < kMiddleColumn + half / 2; ++x)
    darker += brightness(plain.at(x, 100)) - brightness(lined.at(x, 100)) > 60;
  EXPECT_GE(darker, 1);
  EXPECT_LE(darker, 4);
  EXPECT_EQ(plain.at(10, 10), lined.at(10, 10));
}

TEST(PressureColor, OfABodyThatDriftsWithTheWaterIsThatOfABodyAtRest) {
  Scene drifting = ball_in_water_to(0.2);
  drifting.picture.bodies[0].coefficients.pressure_drag = {0.6316, 0.6316};
  const Image at_rest = pictures::draw(drifting);
  drifting.states[0].linear_velocity = {1, 2, 0};
  EXPECT_NE(pictures::draw(drifting), at_rest);
  drifting.picture.sea->current = {1, 2, 0};
  EXPECT_EQ(pictures::draw(drifting), at_rest);
}

/// Places of a picture where a ball's wet surface is in sight, with the pressure there.
struct Place {
  int x, y;
  double pressure;  ///< [Pa]
};

/// Of the ball of `scene`, whose middle is the origin, in still water to `level`.
std::vector<Place> wet_places(const Scene& scene, double level) {
  const render::SceneDescription& p = scene.picture;
  const render::View view = render::make_view(p.camera, p.width, p.height);
  std::vector<Place> places;
  for (int y = 0; y < p.height; y += 3)
    for (int x = 0; x < p.width; x += 3) {
      const Eigen::Vector3d ray =
          (view.forward_W + view.half_width * (2 * (x + 0.5) / p.width - 1) * view.right_W +
           view.half_height * (1 - 2 * (y + 0.5) / p.height) * view.up_W)
              .normalized();
      const double b = ray.dot(view.eye_W), c = view.eye_W.squaredNorm() - 1;
      if (b * b < c) continue;
      const Eigen::Vector3d at = view.eye_W - (b + std::sqrt(b * b - c)) * ray;
      const double depth = level - at.z();
      // Within the width of the waterline, and along the outline, a pixel is of several colours.
      if (depth < 0.06 || at.dot(-ray) < 0.3) continue;
      places.push_back({x, y, kWeight * depth});
    }
  return places;
}

/// With each colour map, through the water from above and from below, near and far.
TEST(PressureColor, SeenThroughTheWaterIsThatOfTheBar) {
  constexpr double kLevel = 0.2;
  const std::vector<Eigen::Vector3d> eyes = {{0, -9, 4}, {-4, -5, 7}, {0, -7, -2}, {3, -30, -8}};
  for (const auto& [name, map] : render::color_maps()) {
    Scene scene = ball_in_water_to(kLevel);
    scene.picture.pressure = {.min = -2e3, .max = 14e3, .colors = map};
    scene.picture.water_visible = true;
    scene.picture.ground_z = -9;
    render::Renderer renderer(scene.picture, pictures::shader_folder());
    for (const Eigen::Vector3d& eye : eyes) {
      scene.picture.camera = {.from = eye, .to = {0, 0, 0}, .field_of_view = 3 / eye.norm()};
      renderer.look(scene.picture.camera);
      const Image image = renderer.draw(scene.states, scene.time);
      const std::vector<Place> places = wet_places(scene, kLevel);
      EXPECT_GT(places.size(), 200u);
      double error = 0, apart = 0;
      for (const Place& place : places) {
        const pictures::Reading shown =
            pictures::read_color(scene.picture.pressure, image.at(place.x, place.y));
        error = std::max(error, std::abs(shown.pressure - place.pressure));
        apart = std::max(apart, shown.apart);
      }
      EXPECT_LT(error, support::tolerance(0.02 * 16e3)) << name << " from " << eye.transpose();
      EXPECT_LT(apart, support::tolerance(kSameColor)) << name << " from " << eye.transpose();
    }
  }
}

/// Share of white pixels (brightness 255 of each channel) and of black ones in a row of the ball.
std::array<double, 2> striped(const Image& image, int row, int half) {
  int white = 0, black = 0;
  for (int x = kMiddleColumn - half; x < kMiddleColumn + half; ++x) {
    white += brightness(image.at(x, row)) == 3 * 255;
    black += brightness(image.at(x, row)) == 0;
  }
  return {white / (2.0 * half), black / (2.0 * half)};
}

TEST(PressureColor, BeyondAnEndOfTheScaleIsStriped) {
  Scene scene = ball_in_water_to(0.7);
  scene.picture.pressure.min = 4e3;
  scene.picture.pressure.max = 8e3;
  const Image image = pictures::draw(scene);
  const auto at_pressure = [&](double pressure) {
    return striped(image, static_cast<int>(row_of_height(0.7 - pressure / kWeight)), 30);
  };
  EXPECT_NEAR(at_pressure(2.5e3)[1], 0.5, 0.1);
  EXPECT_EQ(at_pressure(2.5e3)[0], 0);
  EXPECT_EQ(at_pressure(6e3), (std::array<double, 2>{0, 0}));
  EXPECT_NEAR(at_pressure(10e3)[0], 0.5, 0.1);
  EXPECT_EQ(at_pressure(10e3)[1], 0);
}

TEST(PressureColor, DoesNotDependOnWhereInTheWorldTheSceneLies) {
  Scene scene = ball_in_water_to(0.2);
  const Image here = pictures::draw(scene);
  const Eigen::Vector3d away(3e6, -1e6, 2000);
  scene.picture.camera.from += away;
  scene.picture.camera.to += away;
  scene.picture.sea->level += away.z();
  scene.states[0].position += away;
  const Image there = pictures::draw(scene);
  int largest = 0;
  for (std::size_t i = 0; i < here.rgb.size(); ++i)
    largest = std::max(largest, std::abs(here.rgb[i] - there.rgb[i]));
  // Positions of 3e6 m are known to 5e-10 m: depths and outlines may round differently.
  EXPECT_LE(largest, support::tolerance(3));
}

}  // namespace

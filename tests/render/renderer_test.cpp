#include "app/render/renderer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "app/render/gl_program.h"
#include "hydro/airy_waves.h"
#include "hydro/mesh/primitives.h"
#include "tests/render/pictures.h"

namespace {

namespace fs = std::filesystem;
using pictures::Scene;
using render::Image;
using testing::AnyOf;
using testing::HasSubstr;

/// Share of the pixels that differ by more than `least` in some channel.
double differing_share(const Image& a, const Image& b, int least) {
  int count = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const std::uint8_t *p = a.pixel(x, y), *q = b.pixel(x, y);
      count += std::abs(p[0] - q[0]) > least || std::abs(p[1] - q[1]) > least ||
               std::abs(p[2] - q[2]) > least;
    }
  return static_cast<double>(count) / (a.width * a.height);
}

Scene ball_from_above() {
  Scene scene = pictures::ball_seen_level(0);
  scene.picture.camera.from.z() = 4;
  scene.picture.water_visible = true;
  return scene;
}

std::string error_of(const Scene& scene, const fs::path& shaders) {
  try {
    render::Renderer(scene.picture, shaders);
  } catch (const render::Error& error) {
    return error.what();
  }
  return "no error";
}

/// A copy of the shaders that a test may spoil.
class SpoiltShaders : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::copy(pictures::shader_folder(), folder_, fs::copy_options::recursive);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void append(const std::string& file, const std::string& line) {
    std::ofstream(folder_ / file, std::ios::app) << line << '\n';
  }
  long lines(const std::string& file) {
    std::ifstream in(folder_ / file);
    return std::count(std::istreambuf_iterator<char>(in), {}, '\n');
  }

  fs::path folder_ = fs::temp_directory_path() /
                     ("plimsoll_shaders_" +
                      std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(SpoiltShaders, AreNamedWithTheLineThatDoesNotCompile) {
  append("body.frag", "float spoilt = nonsense;");
  const std::string place = "body.frag:" + std::to_string(lines("body.frag"));
  EXPECT_THAT(error_of(ball_from_above(), folder_), HasSubstr(place));
}

TEST_F(SpoiltShaders, AreNamedWithTheLineOfTheSharedFile) {
  append("common.glsl", "float spoilt = nonsense;");
  const std::string place = "common.glsl:" + std::to_string(lines("common.glsl"));
  EXPECT_THAT(error_of(ball_from_above(), folder_), HasSubstr(place));
}

TEST_F(SpoiltShaders, AreNamedIfTheyAreMissing) {
  fs::remove(folder_ / "water.vert");
  EXPECT_THAT(error_of(ball_from_above(), folder_), HasSubstr("water.vert"));
}

TEST(ShaderError, HasItsPlaceWhateverTheCompilersStyle) {
  const auto place = [](const std::string& log) {
    return render::place_of_shader_error(log, "shaders/common.glsl", "shaders/body.frag");
  };
  EXPECT_EQ(place("0:100041(7): error: `x' undeclared\nmore"),
            "shaders/body.frag:41: error: `x' undeclared");
  EXPECT_EQ(place("0(12) : error C1503: undefined"),
            "shaders/common.glsl:12: error C1503: undefined");
  EXPECT_EQ(place("ERROR: 0:100005: 'x' : undeclared"), "shaders/body.frag:5: 'x' : undeclared");
  EXPECT_EQ(place("out of memory"), "shaders/body.frag: out of memory");
}

TEST(Renderer, NamesASoftwareRasteriserWhenToldToUseNoOther) {
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  const render::Renderer renderer(ball_from_above().picture, pictures::shader_folder());
  EXPECT_THAT(renderer.device(), AnyOf(HasSubstr("llvmpipe"), HasSubstr("softpipe")));
}

bool graphics_library_is_loaded() {
  std::ifstream maps("/proc/self/maps");
  const std::string text{std::istreambuf_iterator<char>(maps), {}};
  return text.find("libEGL") != std::string::npos || text.find("libGL") != std::string::npos;
}

// What happens in a process of its own, where nothing was drawn before.
class FreshProcess : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(FreshProcess, LoadsTheGraphicsLibraryWithTheFirstRendererOnly) {
  EXPECT_EXIT(
      {
        const bool before = graphics_library_is_loaded();
        const render::Renderer renderer(ball_from_above().picture, pictures::shader_folder());
        std::exit(!before && graphics_library_is_loaded() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST_F(FreshProcess, WithoutAGraphicsDriverNamesThePackagesToInstall) {
  EXPECT_EXIT(
      {
        setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
        std::fputs(error_of(ball_from_above(), pictures::shader_folder()).c_str(), stderr);
        std::exit(0);
      },
      testing::ExitedWithCode(0), "libegl-mesa0 libgl1-mesa-dri");
}

TEST(Renderer, DrawsTheSameNextToAnotherRenderer) {
  const Scene scene = ball_from_above();
  render::Renderer first(scene.picture, pictures::shader_folder());
  const Image alone = first.draw(scene.states, 0);
  {
    render::Renderer second(pictures::gallery()[1].picture, pictures::shader_folder());
    second.draw(pictures::gallery()[1].states, 0);
    EXPECT_EQ(first.draw(scene.states, 0), alone);
  }
  EXPECT_EQ(first.draw(scene.states, 0), alone);
}

TEST(Renderer, ForgetsThePictureBefore) {
  const Scene scene = ball_from_above();
  render::Renderer renderer(scene.picture, pictures::shader_folder());
  const Image before = renderer.draw(scene.states, 0);
  std::vector<hydro::BodyState> moved = scene.states;
  moved[0].position.x() += 0.5;
  EXPECT_NE(renderer.draw(moved, 0), before);
  EXPECT_EQ(renderer.draw(scene.states, 0), before);
}

TEST(Renderer, LooksFromAnotherPlaceAsOneMadeThereDoes) {
  Scene scene = ball_from_above();
  scene.picture.ground_z = -3;
  render::Renderer renderer(scene.picture, pictures::shader_folder());
  const Image before = renderer.draw(scene.states, 0);
  const render::Camera first = scene.picture.camera;
  scene.picture.camera = {.from = {7, 5, 3}, .to = {0.5, 0, 0}, .field_of_view = 0.8};
  renderer.look(scene.picture.camera);
  EXPECT_EQ(renderer.draw(scene.states, 0), pictures::draw(scene));
  renderer.look(first);
  EXPECT_EQ(renderer.draw(scene.states, 0), before);
}

TEST(Renderer, DrawsInAnotherSizeAsOneMadeForItDoes) {
  Scene scene = ball_from_above();
  render::Renderer renderer(scene.picture, pictures::shader_folder());
  const Image before = renderer.draw(scene.states, 0);
  const int width = scene.picture.width, height = scene.picture.height;
  scene.picture.width = 330;
  scene.picture.height = 150;
  renderer.resize(330, 150);
  EXPECT_EQ(renderer.draw(scene.states, 0), pictures::draw(scene));
  renderer.resize(width, height);
  EXPECT_EQ(renderer.draw(scene.states, 0), before);
}

TEST(WaterPicture, CoversTheSceneWithWater) {
  Scene scene = ball_from_above();
  const Image with = pictures::draw(scene);
  scene.picture.water_visible = false;
  EXPECT_GT(differing_share(with, pictures::draw(scene), 20), 0.5);
}

TEST(WaterPicture, ShowsWavesAndTheirMotion) {
  Scene scene = ball_from_above();
  const Image flat = pictures::draw(scene);
  scene.picture.sea->surface =
      hydro::WaveSurface{{hydro::deep_water_wave(0.15, 2, 0.5, 0, scene.picture.sea->gravity)}};
  const Image waves = pictures::draw(scene);
  EXPECT_GT(differing_share(flat, waves, 4), 0.3);
  scene.time = 0.4;
  EXPECT_GT(differing_share(waves, pictures::draw(scene), 4), 0.3);
}

/// Largest difference of the red of pixels side by side, which lines make.
int largest_step(const Image& image) {
  int largest = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 1; x < image.width; ++x)
      largest = std::max(largest, std::abs(image.at(x, y).r - image.at(x - 1, y).r));
  return largest;
}

TEST(WaterPicture, OfStillWaterWithoutAGridIsSmooth) {
  Scene scene = ball_from_above();
  scene.picture.bodies.clear();
  scene.states.clear();
  for (const bool water : {true, false}) {
    scene.picture.water_visible = water;
    if (!water) scene.picture.ground_z = -1;
    scene.picture.grid_visible = true;
    EXPECT_GT(largest_step(pictures::draw(scene)), 8) << water;
    scene.picture.grid_visible = false;
    EXPECT_LE(largest_step(pictures::draw(scene)), 1) << water;
    EXPECT_EQ(render::Renderer(scene.picture, pictures::shader_folder()).grid(), 0);
  }
}

TEST(WaterPicture, HasItsHorizonWhereTheCameraSays) {
  // A level camera of 240 rows has it in the middle. The sky just above is nearly white, the water
  // some way below blue.
  Scene scene = pictures::ball_seen_level(0);
  scene.picture.camera = {.from = {0, -10, 1.5}, .to = {0, 0, 1.5}};
  scene.picture.water_visible = true;
  const Image image = pictures::draw(scene);
  const auto blue_over_red = [&](int row) { return image.at(20, row).b - image.at(20, row).r; };
  EXPECT_LT(blue_over_red(118), 40);
  EXPECT_GT(blue_over_red(160), 50);
}

TEST(WaterPicture, ShowsASunkenBodyThroughTheSurfaceOverIt) {
  const auto distance = [](render::Rgb a, render::Rgb b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
  };
  constexpr int kSeen = 40;  // of 765
  for (const double depth : {1.2, 3.0, 8.0}) {
    Scene scene = ball_from_above();
    scene.picture.pressure_visible = false;
    scene.picture.grid_visible = false;
    scene.states[0].position.z() = -depth;
    scene.picture.camera.to = scene.states[0].position;
    const render::Rgb ball = pictures::draw(scene).at(160, 120);
    Scene dry = scene, open = scene;
    dry.picture.sea.reset();
    open.picture.bodies.clear();
    open.states.clear();
    EXPECT_GT(distance(ball, pictures::draw(open).at(160, 120)), kSeen) << depth;
    EXPECT_GT(distance(ball, pictures::draw(dry).at(160, 120)), kSeen) << depth;
  }
}

TEST(WaterPicture, FromUnderWaterStillShowsBodiesAndSurface) {
  Scene scene = ball_from_above();
  scene.picture.camera.from = {0, -8, -2};
  const Image image = pictures::draw(scene);
  // The ball's wet half, in the middle, against the water beside it.
  const render::Rgb ball = image.at(160, 125), beside = image.at(20, 125);
  EXPECT_GT(std::abs(ball.r - beside.r) + std::abs(ball.g - beside.g) + std::abs(ball.b - beside.b),
            40);
  // Light comes from above.
  EXPECT_GT(image.at(20, 10).g, image.at(20, 230).g);
}

TEST(GroundPicture, HidesWhatLiesUnderIt) {
  Scene scene = ball_from_above();
  scene.picture.sea.reset();
  scene.picture.ground_z = 1.5;
  const Image plane = pictures::draw(scene);
  Scene empty = scene;
  empty.picture.bodies.clear();
  empty.states.clear();
  EXPECT_EQ(plane, pictures::draw(empty));
  scene.picture.ground_z = -1.5;
  EXPECT_GT(differing_share(pictures::draw(scene), pictures::draw(empty), 20), 0.05);
}

TEST(GroundPicture, OfAMeshIsSeenThroughTheWater) {
  Scene scene = ball_from_above();
  const Image open = pictures::draw(scene);
  hydro::TriMesh floor;
  floor.vertices.resize(3, 4);
  floor.vertices << -4, 4, 4, -4, -4, -4, 4, 4, -1.2, -1.2, -1.2, -1.2;
  floor.faces.resize(3, 2);
  floor.faces << 0, 0, 1, 2, 2, 3;
  scene.picture.ground_W = floor;
  EXPECT_GT(differing_share(open, pictures::draw(scene), 10), 0.3);
}

}  // namespace

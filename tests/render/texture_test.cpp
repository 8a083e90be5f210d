#include <gtest/gtest.h>

#include <string>

#include "app/render/jpeg.h"
#include "app/render/paint.h"
#include "app/render/png.h"
#include "app/render/texture_map.h"
#include "hydro/mesh/primitives.h"
#include "tests/render/pictures.h"
#include "tests/support/files.h"

/// Images of textures, and their place on drawn meshes.

namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using Eigen::Vector3f;
using render::CornerCoordinates;
using render::Image;
using render::Rgb;

constexpr double kMostPixels = 1e6;
constexpr Rgb kRed = {255, 0, 0}, kGreen = {0, 255, 0}, kBlue = {0, 0, 255}, kGray = {90, 90, 90};

/// Red and green above, blue and grey below.
Image four_colors() {
  Image image = render::filled_image(2, 2, kRed);
  const Rgb colors[] = {kRed, kGreen, kBlue, kGray};
  for (int i = 0; i < 4; ++i) {
    const Rgb c = colors[i];
    std::copy_n(std::array{c.r, c.g, c.b}.begin(), 3, image.pixel(i % 2, i / 2));
  }
  return image;
}

Vector3f share(Rgb c) { return Vector3f(c.r, c.g, c.b) / 255; }

/// A triangle inside a square of half a unit with this lower left corner.
CornerCoordinates triangle_at(float u, float v) {
  CornerCoordinates corners;
  corners << u + 0.05F, u + 0.45F, u + 0.1F, v + 0.05F, v + 0.1F, v + 0.45F;
  return corners;
}

std::string bytes_of(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}

/// 8 × 8 pixels of (202, 40, 61).
const std::string kJpeg = bytes_of(
    "ffd8ffe000104a46494600010100000100010000ffdb0043000d090a0b0a080d0b0a0b0e0e0d0f1320151312"
    "1213271c1e17202e2931302e292d2c333a4a3e333646372c2d405741464c4e525352323e5a615a50604a5152"
    "4fffdb0043010e0e0e131113261515264f352d354f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f"
    "4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4fffc000110800080008030122000211010311"
    "01ffc4001500010100000000000000000000000000000005ffc4001410010000000000000000000000000000"
    "0000ffc4001501010100000000000000000000000000000406ffc40014110100000000000000000000000000"
    "000000ffda000c03010002110311003f009000aad7ffd9");
/// 8 × 8 pixels of grey 91.
const std::string kGrayJpeg = bytes_of(
    "ffd8ffe000104a46494600010100000100010000ffdb0043000d090a0b0a080d0b0a0b0e0e0d0f1320151312"
    "1213271c1e17202e2931302e292d2c333a4a3e333646372c2d405741464c4e525352323e5a615a50604a5152"
    "4fffc0000b080008000801011100ffc40014000100000000000000000000000000000005ffc4001410010000"
    "0000000000000000000000000000ffda0008010100003f0021ffd9");

std::string png_bytes(const Image& image) {
  const fs::path file = fs::path(testing::TempDir()) / "plimsoll_texture_test.png";
  render::write_png(image, file);
  const std::string bytes = support::bytes_in(file);
  fs::remove(file);
  return bytes;
}

TEST(DecodedPng, IsTheImageThatWasWritten) {
  EXPECT_EQ(render::decode_png(png_bytes(four_colors()), kMostPixels), four_colors());
}

TEST(DecodedPng, IsRefusedWhereItIsDamagedOrTooLarge) {
  const std::string bytes = png_bytes(four_colors());
  EXPECT_THROW(render::decode_png(bytes, 3), render::Error);
  EXPECT_NO_THROW(render::decode_png(bytes, 4));
  EXPECT_THROW(render::decode_png(bytes.substr(0, bytes.size() / 2), kMostPixels), render::Error);
  EXPECT_THROW(render::decode_png("", kMostPixels), render::Error);
}

// The file has two pixels: red without opacity and blue.
TEST(DecodedPng, HasTheColorsOfTransparentPixels) {
  const std::string bytes = bytes_of(
      "89504e470d0a1a0a0000000d4948445200000002000000010806000000f4227f8a0000000f494441"
      "54789c63f8cf0002ffff03000afe02fe5f2d82350000000049454e44ae426082");
  const Image image = render::decode_png(bytes, kMostPixels);
  EXPECT_EQ(image.at(0, 0), kRed);
  EXPECT_EQ(image.at(1, 0), kBlue);
}

TEST(DecodedJpeg, HasItsColorOrGray) {
  const Image image = render::decode_jpeg(kJpeg, kMostPixels);
  EXPECT_EQ(image, render::filled_image(8, 8, image.at(0, 0)));
  // Decoders differ by the rounding of the cosine transform.
  EXPECT_LT((share(image.at(0, 0)) - share({202, 40, 61})).cwiseAbs().maxCoeff(), 2.5F / 255);
  EXPECT_EQ(render::decode_jpeg(kGrayJpeg, kMostPixels), render::filled_image(8, 8, {91, 91, 91}));
}

TEST(DecodedJpeg, IsRefusedWhereItIsDamagedEndsEarlyOrIsTooLarge) {
  EXPECT_THROW(render::decode_jpeg(kJpeg, 63), render::Error);
  EXPECT_THROW(render::decode_jpeg(kJpeg.substr(0, kJpeg.size() - 12), kMostPixels), render::Error);
  EXPECT_THROW(render::decode_jpeg(kJpeg.substr(0, 100), kMostPixels), render::Error);
  EXPECT_THROW(render::decode_jpeg("", kMostPixels), render::Error);
}

TEST(HalvedImage, HasTheMeansOfFourPixels) {
  const Image half = render::halved(four_colors());
  EXPECT_EQ(half, render::filled_image(1, 1, {86, 86, 86}));  // (255 + 90 + 2) / 4
  EXPECT_EQ(render::halved(render::filled_image(5, 3, kBlue)), render::filled_image(3, 2, kBlue));
}

TEST(TexelMeans, AreThoseOfThePixelsUnderATriangleAndRepeat) {
  const Image image = four_colors();
  const render::TexelMeans means(image);
  for (const float turn : {0.0F, 3.0F, -2.0F}) {
    EXPECT_LT((means.over(triangle_at(turn, turn)) - share(kBlue)).norm(), 1e-6F);
    EXPECT_LT((means.over(triangle_at(turn + 0.5F, turn)) - share(kGray)).norm(), 1e-6F);
    EXPECT_LT((means.over(triangle_at(turn, turn + 0.5F)) - share(kRed)).norm(), 1e-6F);
  }
  CornerCoordinates many;
  many << 0, 64, 0, 0, 0, 64;
  const Vector3f mean = (share(kRed) + share(kGreen) + share(kBlue) + share(kGray)) / 4;
  EXPECT_LT((means.over(many) - mean).norm(), 0.02F);
}

TEST(TintedTexel, IsAProductOfLightOrOfDisplayedValues) {
  const Vector3f half = Vector3f::Constant(0.5F), white = Vector3f::Ones();
  EXPECT_EQ(render::tinted(half, half, false), Vector3f::Constant(0.25F));
  // 0.5 as displayed is 0.21404 of the light, whose square is displayed as 0.23696.
  EXPECT_LT((render::tinted(half, half, true) - Vector3f::Constant(0.23696F)).norm(), 1e-4F);
  EXPECT_LT((render::tinted(half, white, true) - half).norm(), 1e-5F);
}

/// A box whose sides have x and z as texture coordinates; with a seam, where z is above 0 u is
/// larger by 10.
render::Paint textured_box(bool seam) {
  render::Paint paint{.surface_B = hydro::make_box({2, 2, 2}, 4), .colors = {}};
  const hydro::TriMesh& box = paint.surface_B;
  auto map = std::make_shared<render::TextureMap>();
  map->images = {std::make_shared<const Image>(four_colors())};
  map->of_face = Eigen::VectorXi::Zero(box.face_count());
  map->tints = Eigen::Matrix3Xf::Ones(3, box.face_count());
  map->coordinates.resize(2, 3 * box.face_count());
  for (Eigen::Index f = 0; f < box.face_count(); ++f) {
    const double z = box.vertices(Eigen::all, box.faces.col(f)).row(2).mean();
    for (int i = 0; i < 3; ++i) {
      const Vector3d v = box.vertices.col(box.faces(i, f));
      map->coordinates.col(3 * f + i) << static_cast<float>(v.x() + (seam && z > 0 ? 10 : 0)),
          static_cast<float>(v.z());
    }
  }
  paint.colors = Eigen::Matrix3Xf::Constant(3, box.face_count(), 0.25F);
  paint.textures = std::move(map);
  return paint;
}

const Vector3f kOwnColor(0.5F, 0.5F, 0.5F);

TEST(TexturedSkin, HasTheCoordinatesOfThePaintOnOtherTriangles) {
  const render::ShadedMesh skin = render::make_shaded_mesh(hydro::make_box({2, 2, 2}, 7));
  const render::PaintedSkin painted = render::painted_skin(skin, textured_box(false), kOwnColor);
  ASSERT_EQ(painted.parts.size(), 1U);
  EXPECT_EQ(painted.parts[0].count, skin.triangles.cols());
  ASSERT_EQ(painted.coordinates.cols(), painted.skin.vertices.cols());
  constexpr float kStep = 1.0F / 65536;
  for (Eigen::Index i = 0; i < painted.coordinates.cols(); ++i) {
    const Vector3d v = painted.skin.vertices.col(i);
    EXPECT_NEAR(painted.coordinates(0, i), v.x(), kStep);
    EXPECT_NEAR(painted.coordinates(1, i), v.z(), kStep);
  }
  EXPECT_EQ(painted.skin.vertices.cols(), skin.vertices.cols()) << "triangles share their corners";
}

TEST(TexturedSkin, HasTheMeanColorWhereATriangleCrossesASeam) {
  // Seven divisions have triangles on both sides of the middle height.
  const render::ShadedMesh skin = render::make_shaded_mesh(hydro::make_box({2, 2, 2}, 7));
  const render::PaintedSkin painted = render::painted_skin(skin, textured_box(true), kOwnColor);
  ASSERT_EQ(painted.parts.size(), 2U);
  EXPECT_EQ(painted.parts[0].texture, nullptr);
  EXPECT_EQ(painted.parts[0].count, 4 * 7 * 2) << "the middle row of four sides";
  EXPECT_NE(painted.parts[1].texture, nullptr);
  EXPECT_EQ(painted.parts[0].count + painted.parts[1].count, skin.triangles.cols());
  for (Eigen::Index f = 0; f < painted.parts[0].count; ++f)
    for (const int v : painted.skin.triangles.col(f))
      EXPECT_EQ(painted.colors.col(v), Vector3f::Constant(0.25F));
}

TEST(TexturedSkin, KeepsASeamBetweenTriangles) {
  const render::ShadedMesh skin = render::make_shaded_mesh(hydro::make_box({2, 2, 2}, 8));
  const render::PaintedSkin painted = render::painted_skin(skin, textured_box(true), kOwnColor);
  ASSERT_EQ(painted.parts.size(), 1U);
  for (Eigen::Index f = 0; f < painted.skin.triangles.cols(); ++f) {
    double z = 0;
    for (const int v : painted.skin.triangles.col(f)) z += painted.skin.vertices(2, v) / 3;
    for (const int v : painted.skin.triangles.col(f))
      EXPECT_NEAR(painted.coordinates(0, v), painted.skin.vertices(0, v) + (z > 0 ? 10 : 0), 1e-4);
  }
}

TEST(TexturedSkin, HasNoTextureOffTheSurface) {
  hydro::TriMesh cap;
  cap.vertices.resize(3, 3);
  cap.vertices << -1, 1, -1, -1, -1, 1, 3, 3, 3;  // Two above the box of half that height.
  cap.faces = Eigen::Vector3i(0, 1, 2);
  const render::PaintedSkin painted =
      render::painted_skin(render::make_shaded_mesh(cap), textured_box(false), kOwnColor);
  ASSERT_EQ(painted.parts.size(), 1U);
  EXPECT_EQ(painted.parts[0].texture, nullptr);
}

TEST(TexturedSkin, WithoutTexturesHasTheirMeans) {
  const render::ShadedMesh skin = render::make_shaded_mesh(hydro::make_box({2, 2, 2}, 2));
  const render::PaintedSkin painted =
      render::painted_skin(skin, render::without_textures(textured_box(false)), kOwnColor);
  EXPECT_TRUE(painted.parts.empty());
  EXPECT_EQ(painted.coordinates.size(), 0);
  EXPECT_EQ(painted.colors, Eigen::Matrix3Xf::Constant(3, painted.colors.cols(), 0.25F));
}

/// A ball with an image of one colour over it.
Image drawn_ball(Rgb texel, const Vector3f& tint, bool of_light) {
  pictures::Scene scene = pictures::ball_seen_level(0);
  scene.picture.sea.reset();
  render::BodyAppearance& ball = scene.picture.bodies[0];
  const Eigen::Index faces = ball.mesh_B.face_count();
  auto map = std::make_shared<render::TextureMap>();
  map->images = {std::make_shared<const Image>(render::filled_image(4, 2, texel))};
  map->of_face = Eigen::VectorXi::Zero(faces);
  map->coordinates = Eigen::Matrix2Xf::Constant(2, 3 * faces, 0.5F);
  map->tints = tint.replicate(1, faces);
  map->of_light = of_light;
  ball.paint = std::make_shared<render::Paint>(
      render::Paint{.surface_B = ball.mesh_B,
                    .colors = Eigen::Matrix3Xf::Constant(3, faces, -1),
                    .textures = std::move(map)});
  return pictures::draw(scene);
}

Image plain_ball(const Vector3f& color) {
  pictures::Scene scene = pictures::ball_seen_level(0);
  scene.picture.sea.reset();
  scene.picture.bodies[0].color = color.cast<double>();
  return pictures::draw(scene);
}

/// Largest difference of two pictures of one size [of 255].
int difference(const Image& a, const Image& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i)
    most = std::max(most, std::abs(a.rgb[i] - b.rgb[i]));
  return most;
}

TEST(TexturedBody, LooksLikeOneOfTheProductOfImageAndTint) {
  const Vector3f tint(1, 0.5F, 0.2F);
  const Rgb texel = {204, 102, 51};
  for (const bool of_light : {false, true}) {
    const Vector3f product = render::tinted(share(texel), tint, of_light);
    // The shader's powers of floats differ from the library's by less than a step.
    EXPECT_LE(difference(drawn_ball(texel, tint, of_light), plain_ball(product)), 1) << of_light;
  }
  EXPECT_GT(difference(drawn_ball(texel, tint, true), drawn_ball(texel, tint, false)), 5);
}

}  // namespace

#include "app/pictures/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "app/render/png.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class Textures : public testing::Test {
 protected:
  Textures() { fs::create_directories(folder_); }
  ~Textures() override { fs::remove_all(folder_); }

  fs::path png(int width, int height) const {
    render::write_png(render::filled_image(width, height, {10, 20, 30}), folder_ / "t.png");
    return folder_ / "t.png";
  }
  app::ReadTextures read(const assembly::TextureSource& source) const {
    return app::read_textures({source}, folder_ / "hull.glb");
  }

  const fs::path folder_ = fs::path(testing::TempDir()) /
                           (std::string("plimsoll_read_textures_") +
                            testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Textures, AreReadFromFilesAndFromBytes) {
  const fs::path file = png(3, 2);
  const std::string bytes = support::bytes_in(file);
  std::ofstream(folder_ / "hull.glb") << "its size sets limits";
  for (const assembly::TextureSource& source :
       {assembly::TextureSource{.name = "t.png", .file = file, .bytes = ""},
        assembly::TextureSource{.name = "number 1 in it", .file = {}, .bytes = bytes}}) {
    const app::ReadTextures textures = read(source);
    EXPECT_TRUE(textures.warnings.empty());
    ASSERT_TRUE(textures.images.at(0));
    EXPECT_EQ(*textures.images[0], render::filled_image(3, 2, {10, 20, 30}));
  }
}

TEST_F(Textures, AreHalvedUntilDevicesTakeThem) {
  const app::ReadTextures textures =
      read({.name = "t.png", .file = png(4 * app::kLongestTextureSide, 8), .bytes = ""});
  ASSERT_TRUE(textures.images.at(0));
  EXPECT_EQ(*textures.images[0], render::filled_image(app::kLongestTextureSide, 2, {10, 20, 30}));
}

TEST_F(Textures, ThatAreMissingOrNoImagesAreNamedInAWarning) {
  const app::ReadTextures missing = read({.name = "gone.png", .file = {}, .bytes = ""});
  EXPECT_FALSE(missing.images.at(0));
  EXPECT_THAT(missing.warnings,
              testing::ElementsAre(AllOf(HasSubstr("gone.png of hull.glb"), HasSubstr("no such"))));

  const app::ReadTextures odd = read({.name = "\xFF\n.png", .file = {}, .bytes = ""});
  EXPECT_THAT(odd.warnings, testing::ElementsAre(HasSubstr("\\xff\\n.png of hull.glb")));

  const fs::path file = png(64, 64);
  const std::string bytes = support::bytes_in(file);
  for (const auto& [content, words] :
       {std::pair(bytes.substr(0, bytes.size() / 2), "not a sound PNG"),
        std::pair(std::string("GIF89a"), "neither PNG nor JPEG"),
        std::pair(std::string("\xFF\xD8\xFF\xE0 no more"), "not a sound JPEG"),
        std::pair(std::string(), "neither PNG nor JPEG")}) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
    const app::ReadTextures broken = read({.name = "t.png", .file = file, .bytes = ""});
    EXPECT_FALSE(broken.images.at(0));
    EXPECT_THAT(broken.warnings,
                testing::ElementsAre(AllOf(HasSubstr("t.png of hull.glb"), HasSubstr(words))));
  }
}

}  // namespace

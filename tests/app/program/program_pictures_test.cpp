#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <assimp/Importer.hpp>
#include <nlohmann/json.hpp>

#include "app/render/png.h"
#include "tests/app/program/program.h"

/// What a scene's pictures show, in files that the program writes.

namespace {

using nlohmann::json;
using support::falling_box;
using support::Outcome;
using support::Workplace;

class ProgramPictures : public testing::Test {
 protected:
  /// Runs a scene into the folder `o`.
  void run(const std::string& scene, const std::vector<std::string>& sets = {}) {
    std::vector<std::string> words = {"run", scene, "--out", "o"};
    for (const std::string& set : sets) words.insert(words.end(), {"--set", set});
    const Outcome outcome = here.run(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  }
  std::string frame(const std::string& number) {
    return here.read("o/frames/frame_000" + number + ".png");
  }

  Workplace here;
};

TEST_F(ProgramPictures, OfAStillSceneDifferByTheTimeOverThemAlone) {
  here.write("still.yaml",
             "plimsoll: 1\nduration: 0.5\nstep: 0.1\ngravity: 0\nbodies:\n"
             "  - {name: box, box: {size: [1, 1, 1]}, density: 500}\n"
             "render: {size: [320, 240], every: 0.4, show: [centres]}\n");
  run("still.yaml");
  EXPECT_NE(frame("0"), frame("1"));
  const std::string with_letters = frame("0");
  run("still.yaml", {"render.overlay=false"});
  EXPECT_EQ(frame("0"), frame("1"));
  EXPECT_NE(frame("0"), with_letters);
}

// Its loads are computed where arrows show them, though no log asks for them.
TEST_F(ProgramPictures, OfABodyThatIsHeldShowItsPressuresAndForces) {
  here.write("pier.yaml",
             "plimsoll: 1\nduration: 0.4\nstep: 0.1\n"
             "water: {current: [1, 0, 0], surface: {waves: [{amplitude: 0.2, period: 4}]}}\n"
             "hydro: {added_mass: none}\nbodies:\n"
             "  - {name: pier, box: {size: [1, 1, 4]}, density: 500, lock: all}\n"
             "render: {size: [320, 240], every: 0.4, show: [forces, centres]}\n");
  run("pier.yaml");
  const std::string first = frame("0"), last = frame("1");
  run("pier.yaml", {"log.forces=true"});
  EXPECT_EQ(frame("0"), first);
  EXPECT_EQ(frame("1"), last);
  run("pier.yaml", {"render.show=[centres]"});
  EXPECT_NE(frame("0"), first) << "no arrow";
  const std::string colored = frame("1");
  run("pier.yaml", {"render.show=[centres]", "render.pressure=none"});
  EXPECT_NE(frame("1"), colored) << "no pressures";
}

TEST_F(ProgramPictures, WithoutPressuresHaveNoScale) {
  here.write("box.yaml", falling_box("0.4", "render: {size: [320, 240], every: 0.4}\n"));
  const auto pictures = [&] { return json::parse(here.read("o/summary.json"))["pictures"]; };
  run("box.yaml");
  EXPECT_TRUE(pictures().contains("pressure_max"));
  const std::string sheet = here.read("o/sheet.png");
  run("box.yaml", {"render.pressure=none"});
  EXPECT_FALSE(pictures().contains("pressure_max"));
  EXPECT_NE(here.read("o/sheet.png"), sheet);
}

TEST_F(ProgramPictures, HaveTheMaterialsOfAMeshFileWithoutPressuresAlone) {
  here.write("t.obj",
             "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\n"
             "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  here.write("t.yaml",
             "plimsoll: 1\nduration: 0.1\nstep: 0.1\nbodies:\n"
             "  - {name: t, mesh: {file: t.obj}, density: 500}\n"
             "render: {size: [64, 48]}\n");
  const auto frame_with = [&](const std::string& materials, const std::vector<std::string>& sets) {
    here.write("t.mtl", materials);
    run("t.yaml", sets);
    return frame("0");
  };
  const std::string red = "newmtl red\nKd 1 0 0\n", blue = "newmtl red\nKd 0 0 1\n";
  EXPECT_EQ(frame_with(red, {}), frame_with(blue, {}));
  const std::string none = "render.pressure=none", color = "bodies[0].color=[1, 0, 0]";
  EXPECT_NE(frame_with(red, {none}), frame_with(blue, {none}));
  EXPECT_EQ(frame_with(red, {none}), frame_with(blue, {none, color}));
}

/// A box whose side toward −y has an image of four colours twice beside each other, seen from
/// there.
class ProgramPicturesOfTextures : public ProgramPictures {
 protected:
  ProgramPicturesOfTextures() {
    here.write("t.obj",
               "mtllib t.mtl\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\n"
               "v 1 1 1\nv -1 1 1\nvt 0 0\nvt 2 0\nvt 2 1\nvt 0 1\nusemtl m\n"
               "f 1/1 2/2 6/3 5/4\nf 2/1 3/2 7/3 6/4\nf 3/1 4/2 8/3 7/4\nf 4/1 1/2 5/3 8/4\n"
               "f 5/1 6/2 7/3 8/4\nf 4/1 3/2 2/3 1/4\n");
    here.write("t.mtl", "newmtl m\nKd 1 1 1\nmap_Kd t.png\n");
    here.write("t.yaml",
               "plimsoll: 1\nduration: 0.1\nstep: 0.1\ngravity: 0\nbodies:\n"
               "  - {name: t, mesh: {file: t.obj}, density: 500}\n"
               "render: {size: [200, 200], overlay: false, pressure: none, camera: "
               "{from: [0, -9, 0], to: [0, 0, 0]}}\n");
  }
  void write_image() {
    render::Image image = render::filled_image(2, 2, kBlue);
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 2; ++x) {
        const render::Rgb& color = kImage[y][x];
        image.pixel(x, y)[0] = color.r;
        image.pixel(x, y)[1] = color.g;
        image.pixel(x, y)[2] = color.b;
      }
    render::write_png(image, here / "t.png");
  }
  render::Image first_frame() { return render::read_png(here / "o/frames/frame_0000.png"); }

  static constexpr render::Rgb kRed = {250, 0, 0}, kGreen = {0, 250, 0}, kBlue = {0, 0, 250},
                               kGray = {160, 160, 160};
  static constexpr render::Rgb kImage[2][2] = {{kRed, kGreen}, {kBlue, kGray}};
};

TEST_F(ProgramPicturesOfTextures, HaveItsColorsAtTheirPlaces) {
  write_image();
  run("t.yaml");
  const render::Image picture = first_frame();
  // At 8 m the picture is 2 · 8 · tan 17.5° high, so that the side takes 79 pixels: columns of the
  // image lie 20 pixels apart, rows 40, the middles of the four colours 10 and 20 from the edges.
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 4; ++column) {
      const render::Rgb found = picture.at(100 - 30 + 20 * column, 100 - 20 + 40 * row);
      const render::Rgb wanted = kImage[row][column % 2];
      const Eigen::Vector3d a(found.r, found.g, found.b), b(wanted.r, wanted.g, wanted.b);
      // The light differs over the side, the hue does not.
      EXPECT_GT(a.normalized().dot(b.normalized()), 0.98) << row << " " << column;
    }
}

TEST_F(ProgramPicturesOfTextures, AreReadForPicturesThatShowThemAlone) {
  here.write("t.png", "no image");
  const std::vector<std::string> to_o = {"run", "t.yaml", "--out", "o"};
  const auto outcome_with = [&](const std::string& option, const std::string& value) {
    std::vector<std::string> words = to_o;
    words.push_back(option);
    if (!value.empty()) words.push_back(value);
    return here.run(words);
  };
  const std::string warning = "t.yaml: warning: the texture t.png of t.obj: ";
  const Outcome shown = here.run(to_o);
  EXPECT_EQ(shown.code, 0);
  EXPECT_THAT(shown.err, testing::HasSubstr(warning + "neither PNG nor JPEG"));
  EXPECT_THAT(here.read("o/summary.json"), testing::HasSubstr("neither PNG nor JPEG"));
  const std::string with_broken = frame("0");
  EXPECT_THAT(outcome_with("--no-render", "").err, testing::Not(testing::HasSubstr("texture")));
  EXPECT_THAT(outcome_with("--set", "render.pressure={}").err,
              testing::Not(testing::HasSubstr("texture")));
  EXPECT_THAT(outcome_with("--set", "bodies[0].color=[1, 0, 0]").err,
              testing::Not(testing::HasSubstr("texture")));

  std::filesystem::remove(here / "t.png");
  EXPECT_THAT(here.run(to_o).err, testing::HasSubstr(warning + "there is no such file"));
  EXPECT_EQ(frame("0"), with_broken);
  here.write("t.mtl", "newmtl m\nKd 1 1 1\n");
  run("t.yaml");
  EXPECT_EQ(frame("0"), with_broken) << "the base colour";
}

TEST_F(ProgramPicturesOfTextures, AreExportedAsMeanColors) {
  render::write_png(render::filled_image(2, 2, {188, 0, 255}), here / "t.png");
  run("t.yaml");
  const Outcome exported = here.run({"export", "o", "o.glb", "--scene", "t.yaml"});
  ASSERT_EQ(exported.code, 0) << exported.err;
  Assimp::Importer importer;
  const aiScene* file = importer.ReadFile((here / "o.glb").string(), 0);
  ASSERT_TRUE(file && file->mNumMeshes > 0 && file->mMeshes[0]->HasVertexColors(0));
  for (unsigned i = 0; i < file->mMeshes[0]->mNumVertices; ++i) {
    const aiColor4D& color = file->mMeshes[0]->mColors[0][i];
    // Means of bytes are rounded. Half of the light is displayed as 188 of 255.
    EXPECT_NEAR(color.r, 0.5, 0.01);
    EXPECT_NEAR(color.g, 0, 1e-6);
    EXPECT_NEAR(color.b, 1, 1e-6);
  }
}

}  // namespace

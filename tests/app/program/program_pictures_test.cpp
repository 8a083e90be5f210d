#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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

}  // namespace

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/scene/reader.h"
#include "tests/support/files.h"

/// Includes, variables and repeated entries of scenes.

namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kHead = "plimsoll: 1\nduration: 1\n";
const std::string kBox = "box: {size: [1, 1, 1]}, density: 500";

scene::Scene short_scene(const std::string& text, const std::vector<std::string>& sets = {}) {
  std::vector<scene::Override> overrides;
  for (const std::string& set : sets) overrides.push_back(scene::parse_override(set));
  return scene::parse(kHead + text, "short.yaml", overrides);
}

std::string faults_in_short(const std::string& text, const std::vector<std::string>& sets = {}) {
  try {
    short_scene(text, sets);
    return "";
  } catch (const scene::InputError& error) {
    return error.what();
  }
}

TEST(SceneVariables, StandForNumbersAndTextsInValues) {
  const scene::Scene scene = short_scene(
      "variables: {side: 1.5, half: \"${side/2}\", kind: none, calm: true}\n"
      "bodies:\n"
      "  - name: ${kind}_${2*side}\n"
      "    box: {size: [\"${side}\", \"${half}\", \"${sqrt(side^2)}\"]}\n"
      "    density: ${1e3/3}\n"
      "    hydro: {added_mass: \"${kind}\"}\n"
      "    forces: [{force: [0, 0, 1], start: \"${half}\"}]\n"
      "log: {forces: \"${calm}\"}\n"
      "title: costs $${5}\n");
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.bodies[0].name, "none_3");
  EXPECT_EQ(std::get<scene::Box>(scene.bodies[0].shape).size, Eigen::Vector3d(1.5, 0.75, 1.5));
  EXPECT_EQ(scene.bodies[0].density, 1e3 / 3);  // to the last digit
  EXPECT_EQ(scene.bodies[0].hydro.added_mass.model, scene::AddedMass::Model::none);
  EXPECT_TRUE(scene.log_forces);
  EXPECT_EQ(scene.title, "costs ${5}");
}

TEST(SceneVariables, AreReplacedFromTheCommandLine) {
  const std::string text = "variables: {n: 2}\ngravity: ${n + 1}\n";
  EXPECT_EQ(short_scene(text).gravity, 3);
  EXPECT_EQ(short_scene(text, {"variables.n=8"}).gravity, 9);
  EXPECT_EQ(short_scene("gravity: ${n}\n", {"variables.n=8"}).gravity, 8);
}

TEST(SceneVariables, FaultsAreToldAtTheValueThatUsesThem) {
  const std::string text = "variables: {side: 1, kind: deep}\nwater: {density: \"${";
  EXPECT_EQ(faults_in_short(text + "sid}\"}"),
            "short.yaml:4:18: water.density: there is no variable sid; did you mean side?");
  EXPECT_EQ(faults_in_short(text + "2*kind}\"}"),
            "short.yaml:4:18: water.density: ${2*kind}: kind is the text deep, expected a number");
  EXPECT_THAT(faults_in_short(text + "2*}\"}"), HasSubstr("${2*}: ends too early"));
  EXPECT_THAT(faults_in_short(text + "1/0}\"}"), HasSubstr("${1/0}: is not finite"));
  EXPECT_THAT(faults_in_short(text + "side\"}"), HasSubstr("has a ${ without its }"));
  EXPECT_THAT(faults_in_short(text + "-side}\"}"),
              HasSubstr("found -1, expected a positive number"));
  EXPECT_EQ(faults_in_short("variables: {a: [1]}\n"),
            "short.yaml:3:16: variables.a: found a list of 1, expected a number or a text; anchors "
            "repeat anything else");
  EXPECT_THAT(faults_in_short("variables: {sin: 1}\n"), HasSubstr("sin is a name in formulas"));
  EXPECT_THAT(faults_in_short("variables: {2a: 1}\n"), HasSubstr("found the name 2a"));
}

TEST(SceneVariables, WithoutQuotesInBracketsAreExplained) {
  EXPECT_THAT(faults_in_short("water: {density: ${n}}\n"),
              HasSubstr("(between { } and [ ] a ${…} needs quotes)"));
}

TEST(SceneRepeat, MakesNumberedCopiesInAGrid) {
  const scene::Scene scene = short_scene(
      "bodies:\n"
      "  - {name: crate, " +
      kBox +
      ", position: [1, 0, 0],\n"
      "     repeat: {grid: [3, 2, 1], spacing: [2, 5, 1]}}\n"
      "  - {name: alone, " +
      kBox +
      "}\n"
      "joints:\n"
      "  - {repeat: {count: 2}, name: link, type: ball,\n"
      "     bodies: [\"crate_${i}\", \"crate_${i+1}\"], anchor: [\"${2*i + 2}\", 0, 0]}\n");
  ASSERT_EQ(scene.bodies.size(), 7u);
  EXPECT_EQ(scene.bodies[0].name, "crate_0");
  EXPECT_EQ(scene.bodies[4].name, "crate_4");
  EXPECT_EQ(scene.bodies[4].position, Eigen::Vector3d(3, 5, 0));
  EXPECT_EQ(scene.bodies[6].name, "alone");
  ASSERT_EQ(scene.joints.size(), 2u);
  EXPECT_EQ(scene.joints[1].name, "link_1");
  EXPECT_THAT(scene.joints[1].bodies, ElementsAre("crate_1", "crate_2"));
  EXPECT_EQ(scene.joints[1].anchor->x(), 4);
}

TEST(SceneRepeat, JitterIsBoundedAndRepeatsItselfWithItsSeed) {
  const auto places = [](const std::string& seed) {
    std::vector<Eigen::Vector3d> all;
    for (const scene::Body& body :
         short_scene("bodies:\n  - {name: \"b${i}\", " + kBox +
                     ", repeat: {count: 100, jitter: [2, 1, 0], seed: " + seed + "}}\n")
             .bodies)
      all.push_back(body.position);
    return all;
  };
  const std::vector<Eigen::Vector3d> once = places("7");
  EXPECT_EQ(once, places("7"));
  EXPECT_NE(once, places("8"));
  double largest = 0;
  for (const Eigen::Vector3d& place : once) {
    EXPECT_LE(std::abs(place.y()), 1);
    EXPECT_EQ(place.z(), 0);
    largest = std::max(largest, std::abs(place.x()));
  }
  EXPECT_LE(largest, 2);
  EXPECT_GT(largest, 1.9);
}

TEST(SceneRepeat, IsThereInEveryListOfMaps) {
  const scene::Scene scene = short_scene(
      "water: {surface: {waves: [{repeat: {count: 3}, amplitude: \"${0.1/(i+1)}\","
      " period: \"${4+i}\"}]}}\n");
  const auto& waves = std::get<std::vector<scene::Wave>>(scene.water->surface);
  ASSERT_EQ(waves.size(), 3u);
  EXPECT_EQ(waves[2].amplitude, 0.1 / 3);
}

TEST(SceneRepeat, AFaultOfAllCopiesIsToldOnce) {
  EXPECT_EQ(
      faults_in_short("bodies:\n  - {name: b, densty: 5, " + kBox + ", repeat: {count: 9}}\n"),
      "short.yaml:4:15: bodies[0].densty: unknown key; did you mean density?");
}

TEST(SceneRepeat, LongTextsOfManyCopiesAreAFaultBeforeTheyFillTheMemory) {
  const std::string mebibyte(1 << 20, 'a');
  EXPECT_THAT(faults_of("plimsoll: 1\nduration: 1\nbodies:\n  - {name: " + mebibyte +
                        ", box: {size: [1, 1, 1]}, density: 5, repeat: {count: 100000}}\n"),
              ElementsAre("1:1: with all copies there are more than 64 MiB of text"));
  EXPECT_THAT(faults_of("plimsoll: 1\nduration: 1\nvariables: {text: " + mebibyte +
                        "}\nbodies:\n  - {name: \"${text}${i}\", box: {size: [1, 1, 1]}, "
                        "density: 5, repeat: {count: 100000}}\n")
                  .front(),
              testing::EndsWith("with its variables the scene has more than 64 MiB of text"));
}

TEST(SceneRepeat, WhatIsNotSoundIsToldAtItsPlace) {
  const auto faults = [](const std::string& repeat) {
    return faults_in_short("bodies:\n  - {repeat: " + repeat + ", name: b, " + kBox + "}\n");
  };
  EXPECT_THAT(faults("{count: 0}"), HasSubstr("short.yaml:4:22: bodies[0].repeat.count: found 0"));
  EXPECT_THAT(faults("{count: 2, jiter: [1, 1, 1]}"), HasSubstr("did you mean jitter?"));
  EXPECT_THAT(faults("{}"), HasSubstr("expected exactly one of count and grid"));
  EXPECT_THAT(faults("5"), HasSubstr("found 5, expected a map with count or grid"));
  EXPECT_THAT(faults("{grid: [2, 2, 2]}"), HasSubstr("grid and spacing need each other"));
  EXPECT_THAT(faults("{grid: [1000, 1000, 1], spacing: [1, 1, 1]}"),
              HasSubstr("has 1000000 copies, expected at most 100000"));
}

TEST(SceneRepeat, CopiesAreKnownToTheCommandLineByTheirNames) {
  const std::string text = "bodies:\n  - {name: b, " + kBox + ", repeat: {count: 3}}\n";
  const scene::Scene scene =
      short_scene(text, {"bodies[b_1].density=7", "bodies[b].repeat.count=5"});
  ASSERT_EQ(scene.bodies.size(), 5u);
  EXPECT_EQ(scene.bodies[1].density, 7);
  EXPECT_EQ(scene.bodies[2].density, 500);
  EXPECT_THAT(faults_in_short(text, {"bodies[b_9].density=7"}),
              HasSubstr("--set bodies[b_9].density: bodies has no entry named b_9"));
}

TEST(SceneShortForms, TopLevelKeysThatBeginWithXAreNotRead) {
  EXPECT_EQ(short_scene("x-anything: {a: &b {gravity: 3}}\n<<: *b\n").gravity, 3);
  EXPECT_THAT(faults_in_short("y-anything: 3\n"), HasSubstr("unknown key"));
}

class SceneInclude : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_ / "sub"); }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  scene::Scene read(const std::string& text, const std::vector<std::string>& sets = {}) const {
    write("scene.yaml", kHead + text);
    std::vector<scene::Override> overrides;
    for (const std::string& set : sets) overrides.push_back(scene::parse_override(set));
    return scene::read(folder_ / "scene.yaml", overrides);
  }
  std::string fault(const std::string& text) const {
    try {
      read(text);
      return "";
    } catch (const scene::InputError& error) {
      return error.what();
    }
  }

  fs::path folder_ = fs::temp_directory_path() /
                     ("plimsoll_include_" +
                      std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(SceneInclude, LaterKeysGoOverEarlierOnes) {
  write("a.yaml", "gravity: 1\nwater: {density: 1000, depth: 5}\nbodies:\n  - {name: a, " + kBox +
                      ", position: [1, 2, 3]}\n");
  write("b.yaml", "gravity: 2\nwater: {density: 1025}\n");
  const scene::Scene scene = read("include: [a.yaml, b.yaml]\nstep: 0.5\nbodies:\n  - {name: b, " +
                                  kBox + "}\n  - {name: a, density: null, mass: 7}\n");
  EXPECT_EQ(scene.gravity, 2);
  EXPECT_EQ(scene.water->density, 1025);
  EXPECT_EQ(scene.water->depth, 5);
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[0].name, "a");
  EXPECT_EQ(scene.bodies[0].mass, 7);
  EXPECT_FALSE(scene.bodies[0].density);
  EXPECT_EQ(scene.bodies[0].position.y(), 2);  // a list of numbers is replaced or kept as a whole
  EXPECT_EQ(read("include: a.yaml\n", {"include=b.yaml"}).gravity, 2);
}

TEST_F(SceneInclude, PathsAreRelativeToTheFileThatHasThem) {
  write("sub/boat.yaml", "include: deep.yaml\nvariables: {n: 3}\n");
  write("sub/deep.yaml", "bodies:\n  - {name: hull, mesh: {file: hull.obj}, mass: \"${n}\"}\n");
  write("sub/hull.obj", "v 0 0 0\n");
  const scene::Scene scene = read("include: [sub/boat.yaml]\n");
  EXPECT_EQ(std::get<scene::Mesh>(scene.bodies[0].shape).file, folder_ / "sub/hull.obj");
  EXPECT_EQ(scene.bodies[0].mass, 3);
  EXPECT_THAT(scene::resolved_text(folder_ / "scene.yaml", {}), HasSubstr("file: sub/hull.obj"));
}

TEST_F(SceneInclude, FaultsAreLocatedInTheFileTheyComeFrom) {
  write("sub/boat.yaml", "water:\n  density: -1\n");
  EXPECT_EQ(fault("include: sub/boat.yaml\n"),
            (folder_ / "sub/boat.yaml").string() +
                ":2:12: water.density: found -1, expected a positive number [kg/m^3]");
  write("sub/boat.yaml", "water: [\n");
  EXPECT_THAT(fault("include: sub/boat.yaml\n"), HasSubstr("sub/boat.yaml:2:1: not valid YAML"));
}

TEST_F(SceneInclude, TheTextOfTheSceneNeedsNoOtherFile) {
  write("a.yaml", "variables: {n: 4}\nwater: {density: \"${1000 + n}\"}\n");
  const scene::Scene scene = read("include: a.yaml\ntitle: \"a: ${n}\"\n", {"variables.n=5"});
  fs::remove(folder_ / "a.yaml");
  const scene::Scene again =
      scene::parse(scene.text, scene.file, {scene::parse_override("variables.n=5")});
  EXPECT_EQ(again.water->density, 1005);
  EXPECT_EQ(again.title, "a: 5");
}

TEST_F(SceneInclude, ItselfOrWhatIsNotThereIsRefused) {
  EXPECT_THAT(fault("include: [none.yaml]\n"),
              HasSubstr("scene.yaml:3:11: include: found none.yaml, expected a file"));
  EXPECT_THAT(fault("include: scene.yaml\n"), HasSubstr("scene.yaml includes itself"));
  write("a.yaml", "include: b.yaml\n");
  write("b.yaml", "include: a.yaml\n");
  EXPECT_THAT(fault("include: a.yaml\n"),
              HasSubstr("b.yaml:1:10: include: a.yaml includes itself"));
  EXPECT_THAT(fault("include: {a: 1}\n"), HasSubstr("expected the path of a file"));
}

TEST_F(SceneInclude, TheResolvedTextIsTheSameScene) {
  write("a.yaml", "water: {density: 1000}\n");
  const scene::Scene scene = read(
      "include: a.yaml\nvariables: {k: \"yes: #5\"}\ntitle: ${k}\nbodies:\n  - {name: \"7\", " +
      kBox + ", repeat: {count: 2, jitter: [1, 1, 1]}}\n");
  const std::string text = scene::resolved_text(folder_ / "scene.yaml", {});
  const scene::Scene again = scene::parse(text, "again.yaml", {});
  EXPECT_EQ(again.title, "yes: #5");
  EXPECT_EQ(again.water->density, 1000);
  ASSERT_EQ(again.bodies.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again.bodies[i].name, scene.bodies[i].name);
    EXPECT_EQ(again.bodies[i].position, scene.bodies[i].position);
  }
}

}  // namespace

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/app/scene_text.h"

namespace {

using support::faults_of;
using support::faults_of_file;
using support::kSmallScene;
using testing::ElementsAre;

std::filesystem::path bad_scenes() {
  return std::filesystem::path(PLIMSOLL_SOURCE_DIR) / "tests/data/bad_scenes";
}

/// The names of the bad scenes, sorted.
std::vector<std::string> bad_scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(bad_scenes()))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The faults that a bad scene says it has, in the lines `# expect: …` at its head.
std::vector<std::string> expected_faults(const std::filesystem::path& file) {
  const std::string mark = "# expect: ";
  std::vector<std::string> faults;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line) && line.starts_with(mark);)
    faults.push_back(line.substr(mark.size()));
  return faults;
}

class BadScene : public testing::TestWithParam<std::string> {};

TEST_P(BadScene, HasExactlyTheFaultsThatItsHeadSays) {
  const std::filesystem::path file = bad_scenes() / (GetParam() + ".yaml");
  const std::vector<std::string> expected = expected_faults(file);
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(faults_of_file(file), expected);
}

INSTANTIATE_TEST_SUITE_P(Scenes, BadScene, testing::ValuesIn(bad_scene_names()),
                         [](const auto& scene) { return scene.param; });

TEST(SceneFaults, WhatHasOneFaultALineWithTheFile) {
  const auto file = support::write_scene("plimsoll: 1\nduration: -1\nstepp: 2\n");
  try {
    scene::read(file);
    FAIL() << "read";
  } catch (const scene::InputError& error) {
    EXPECT_EQ(error.what(), file.string() +
                                ":2:11: duration: found -1, expected a number >= 0 [s]\n" +
                                file.string() + ":3:1: stepp: unknown key; did you mean step?");
  }
}

TEST(SceneFaults, AFaultIsOneLineWhateverTheFileHolds) {
  EXPECT_THAT(
      faults_of(std::string(kSmallScene) + "joints: [{type: fixed, bodies: [a, \"b\\nc\"]}]\n"),
      ElementsAre("7:36: joints[0].bodies[1]: there is no body named b c"));
  EXPECT_THAT(faults_of("? |\n  a\n  b\n: 1\n").front(), testing::Not(testing::HasSubstr("\n")));
}

TEST(SceneFaults, AFaultHasNoEscapeForATerminal) {
  EXPECT_THAT(faults_of(std::string(kSmallScene) + "\"\\e]0;owned\\a\\e[31mred\": 1\n"),
              ElementsAre(testing::StartsWith("7:1: \\x1b]0;owned\\x07\\x1b[31mred: unknown key")));
}

TEST(SceneFaults, LongTextsThatAliasesRepeatAreAFaultBeforeTheyFillTheMemory) {
  const std::string mebibyte(1 << 20, 'a');
  std::string aliases;
  for (int i = 0; i < 65; ++i) aliases += i == 0 ? "*t" : ",*t";
  EXPECT_THAT(faults_of("x-text: &t " + mebibyte + "\nx-all: [" + aliases + "]\n"),
              ElementsAre("2:201: more than 64 MiB of text here"));
}

TEST(SceneFaults, MissingFileIsAFault) {
  EXPECT_THAT(faults_of_file("nowhere.yaml"), ElementsAre("there is no such file"));
}

TEST(SceneFaults, FolderIsAFault) {
  EXPECT_THAT(faults_of_file(bad_scenes()), ElementsAre("found a folder, expected a file"));
}

TEST(SceneFaults, EmptyFileIsAFault) {
  EXPECT_THAT(faults_of(""), ElementsAre("found no keys, expected a scene"));
}

TEST(SceneFaults, HugeFileIsAFault) {
  EXPECT_THAT(faults_of(std::string((8u << 20) + 1, '#')),
              ElementsAre("larger than 8 MiB, expected a scene in YAML"));
}

TEST(SceneFaults, ManySmallValuesAreAFaultBeforeTheyFillTheMemory) {
  std::string text = "bodies: [";
  for (int i = 0; i < 600'000; ++i) text += "1,";
  // The file, its key and the list count too, so 499 997 numbers fit; the next is at 10 + 2·499
  // 997.
  EXPECT_THAT(faults_of(text + "]"), ElementsAre("1:1000004: more than 500000 values here"));
}

TEST(SceneFaults, DeepNestingOfEveryKindIsAFault) {
  for (const std::string opening : {"[", "{", "- ", "? ", "{a: ", "[[],"}) {
    std::string text = "plimsoll: 1\nbodies:\n  ";
    for (int i = 0; i < 100'000; ++i) text += opening;
    EXPECT_EQ(faults_of(text).size(), 1) << opening;
  }
}

TEST(SceneFaults, FaultsFoundLaterStandAtTheNearestBlockInTheFile) {
  const scene::Scene scene = support::read_scene_text(kSmallScene, {"bodies[0].color=[0, 0, 0]"});
  scene::Faults faults;
  EXPECT_NO_THROW(faults.throw_if_any());
  faults.add(scene.places, "bodies[0].density", "second");
  faults.add(scene.places, "bodies[0].box.divisions", "first");
  faults.add(scene.places, "bodies[0].color[1]", "of the command line");
  faults.add(scene.places, "nowhere", "of the file");
  try {
    faults.throw_if_any();
    FAIL() << "no fault";
  } catch (const scene::InputError& error) {
    const std::string file = scene.file.string();
    EXPECT_EQ(error.what(), "--set bodies[0].color[1]: of the command line\n" + file +
                                ":1:1: nowhere: of the file\n" + file +
                                ":5:10: bodies[0].box.divisions: first\n" + file +
                                ":6:14: bodies[0].density: second");
  }
}

}  // namespace

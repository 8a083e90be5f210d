#include <gtest/gtest.h>

#include <random>

#include "tests/app/scene_text.h"
#include "tests/support/varied_scene.h"

namespace {

/// Reads; anything but a scene or an InputError ends the test.
void expect_scene_or_faults(const std::string& text) {
  try {
    const scene::Scene scene = support::read_scene_text(text);
    EXPECT_GE(scene.duration, 0) << text;
    EXPECT_GT(scene.step, 0) << text;
  } catch (const scene::InputError& error) {
    EXPECT_FALSE(error.faults().empty()) << text;
    EXPECT_NE(std::string(error.what()), "") << text;
  }
}

/// Changes one to four places of `text`: a byte, a removed piece, a doubled piece or a word of
/// YAML.
std::string mutated(std::string text, std::mt19937& engine) {
  static const std::vector<std::string> kWords = {
      "[", "]", "{", "}", ": ", "- ", "\n",    "  ", "&a",  "*a",   "<<", "~",   "\"",
      "'", "|", ">", "!", "#",  "%",  "---\n", "-",  "1e9", ".nan", "\t", "\xff"};
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(engine() % n); };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(12);
    switch (below(4)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      default:
        text.insert(at, kWords[below(kWords.size())]);
    }
    if (text.empty()) return "x";
  }
  return text;
}

TEST(SceneFuzz, TheSceneItselfIsRight) {
  EXPECT_EQ(support::faults_of(support::kVariedScene), std::vector<std::string>{});
}

TEST(SceneFuzz, EveryTruncationReadsOrHasFaults) {
  for (std::size_t length = 0; length < support::kVariedScene.size(); ++length)
    expect_scene_or_faults(support::kVariedScene.substr(0, length));
}

TEST(SceneFuzz, MutationsReadOrHaveFaults) {
  std::mt19937 engine(1);
  for (int i = 0; i < 4000; ++i) expect_scene_or_faults(mutated(support::kVariedScene, engine));
}

TEST(SceneFuzz, MutatedOverridesReadOrHaveFaults) {
  std::mt19937 engine(2);
  for (int i = 0; i < 2000; ++i) {
    const std::string argument = mutated("bodies[a].orientation.euler_deg=[1, 2, 3]", engine);
    try {
      support::read_scene_text(support::kVariedScene, {argument});
    } catch (const scene::InputError& error) {
      EXPECT_FALSE(error.faults().empty()) << argument;
    }
  }
}

}  // namespace

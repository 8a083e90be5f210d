#include <gtest/gtest.h>

#include <random>

#include "tests/app/scene_text.h"

namespace {

/// A valid scene with something of everything.
const std::string kScene =
    "plimsoll: 1\n"
    "title: \"Fuzz\"\n"
    "duration: 3.6  # s\n"
    "water:\n"
    "  current: [0, 0.5, 0]\n"
    "  surface: {waves: [{amplitude: 0.3, wavelength: 12, heading_deg: -30}]}\n"
    "air: {density: 1.2, wind: {speed: 9, heading_deg: 40, exponent: 0.2}}\n"
    "hydro: &none {lift: false, viscous_drag: thesis}\n"
    "bodies:\n"
    "  - name: a\n"
    "    box: {size: [1, 2, 3], divisions: 2}\n"
    "    mass: 5\n"
    "    inertia: [1, 1, 1, 0, 0, 0]\n"
    "    orientation: {euler_deg: [10, 20, 30]}\n"
    "    lock: [x, yaw]\n"
    "  - {name: b, sphere: {radius: 1}, density: 5e2, hydro: {<<: *none, buoyancy: true}}\n"
    "joints:\n"
    "  - {type: hinge, bodies: [a, b], anchor: [0, 0, 1], axis: [0, 1, 0]}\n"
    "render: {size: [320, 240], pressure: {min: 0, max: auto}}\n";

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
  EXPECT_EQ(support::faults_of(kScene), std::vector<std::string>{});
}

TEST(SceneFuzz, EveryTruncationReadsOrHasFaults) {
  for (std::size_t length = 0; length < kScene.size(); ++length)
    expect_scene_or_faults(kScene.substr(0, length));
}

TEST(SceneFuzz, MutationsReadOrHaveFaults) {
  std::mt19937 engine(1);
  for (int i = 0; i < 4000; ++i) expect_scene_or_faults(mutated(kScene, engine));
}

TEST(SceneFuzz, MutatedOverridesReadOrHaveFaults) {
  std::mt19937 engine(2);
  for (int i = 0; i < 2000; ++i) {
    const std::string argument = mutated("bodies[a].orientation.euler_deg=[1, 2, 3]", engine);
    try {
      support::read_scene_text(kScene, {argument});
    } catch (const scene::InputError& error) {
      EXPECT_FALSE(error.faults().empty()) << argument;
    }
  }
}

}  // namespace

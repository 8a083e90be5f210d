#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/assembly/build.h"
#include "app/scene/diagnostics.h"
#include "app/scene/reader.h"

namespace {

namespace fs = std::filesystem;

/// Scenes whose hollows are wrong in a way that only their meshes tell, sorted by name.
std::vector<fs::path> scenes_of_bad_hollows() {
  std::vector<fs::path> scenes;
  for (const auto& entry :
       fs::directory_iterator(fs::path(PLIMSOLL_SOURCE_DIR) / "tests/data/bad_hollows"))
    scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

class BadHollow : public testing::TestWithParam<fs::path> {};

TEST_P(BadHollow, HasExactlyTheFaultThatItsHeadSays) {
  const std::string mark = "# expect: ";
  std::ifstream stream(GetParam());
  std::string expected;
  std::getline(stream, expected);
  ASSERT_TRUE(expected.starts_with(mark));
  try {
    assembly::build_without_added_mass(scene::read(GetParam()));
    FAIL() << "was built";
  } catch (const scene::InputError& error) {
    EXPECT_EQ(error.what(), GetParam().string() + ":" + expected.substr(mark.size()));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BadHollow, testing::ValuesIn(scenes_of_bad_hollows()),
                         [](const auto& scene) { return scene.param.stem().string(); });

}  // namespace

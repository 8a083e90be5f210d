#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

/// @file
/// The scenes that come with the program. Test programs only.

namespace support {

inline const std::filesystem::path kScenes = std::filesystem::path(PLIMSOLL_SOURCE_DIR) / "scenes";

/// Names of the scenes relative to the folder of scenes, sorted.
inline std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kScenes))
    if (entry.path().extension() == ".yaml")
      names.push_back(std::filesystem::relative(entry.path(), kScenes).string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The name of a scene as one of a test.
inline std::string scene_test_name(const testing::TestParamInfo<std::string>& scene) {
  std::string name = scene.param;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

}  // namespace support

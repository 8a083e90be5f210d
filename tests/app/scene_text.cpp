#include "tests/app/scene_text.h"

#include <gtest/gtest.h>

#include <fstream>

namespace support {

namespace {

std::vector<scene::Override> parse_all(const std::vector<std::string>& arguments) {
  std::vector<scene::Override> overrides;
  for (const std::string& argument : arguments)
    overrides.push_back(scene::parse_override(argument));
  return overrides;
}

/// `FILE:2:11: …` → `2:11: …`, `FILE: …` → `…`
std::string without_file(const scene::Fault& fault, const std::filesystem::path& file) {
  const std::string text = scene::to_string(fault);
  const std::string name = file.string();
  if (text.compare(0, name.size(), name) != 0) return text;
  return text.substr(text.find_first_not_of(": ", name.size()));
}

}  // namespace

std::filesystem::path data_folder() {
  return std::filesystem::path(PLIMSOLL_SOURCE_DIR) / "tests/data/bad_scenes/files";
}

std::filesystem::path write_scene(const std::string& text) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path file =
      testing::TempDir() + test.test_suite_name() + "." + test.name() + ".yaml";
  std::filesystem::remove(file);  // some file systems write to disk when a file is overwritten
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

scene::Scene read_scene_text(const std::string& text, const std::vector<std::string>& overrides) {
  return scene::read(write_scene(text), parse_all(overrides));
}

std::vector<std::string> faults_of(const std::string& text,
                                   const std::vector<std::string>& overrides) {
  return faults_of_file(write_scene(text), parse_all(overrides));
}

std::vector<std::string> faults_of_file(const std::filesystem::path& file,
                                        const std::vector<scene::Override>& overrides) {
  std::vector<std::string> faults;
  try {
    scene::read(file, overrides);
  } catch (const scene::InputError& error) {
    for (const scene::Fault& fault : error.faults()) faults.push_back(without_file(fault, file));
  }
  return faults;
}

}  // namespace support

#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/scene/diagnostics.h"

namespace support {

/// Tests of a function that reads a file: each test has a file of its own.
/// @tparam kRead   The function, of the file's path.
template <auto kRead>
class FileReaderTest : public testing::Test {
 protected:
  ~FileReaderTest() override { std::filesystem::remove(file_); }

  auto read(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
    return kRead(file_);
  }
  /// The fault of a file with this text, without the file's name.
  std::string fault(const std::string& text) const {
    try {
      read(text);
    } catch (const scene::InputError& error) {
      return std::string(error.what()).substr(file_.string().size());
    }
    return "none";
  }

 private:
  static std::string name() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    return std::string(test->test_suite_name()) + "_" + test->name();
  }

  std::filesystem::path file_ = std::filesystem::path(testing::TempDir()) / name();
};

}  // namespace support

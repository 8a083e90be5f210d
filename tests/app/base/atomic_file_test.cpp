#include "app/base/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <stdexcept>
#include <thread>

#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using support::bytes_in;
using support::files_in;
using testing::ElementsAre;
using testing::HasSubstr;

class FileWrittenWhole : public testing::Test {
 protected:
  FileWrittenWhole() {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~FileWrittenWhole() override {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }

  static std::string test_name() {
    return testing::UnitTest::GetInstance()->current_test_info()->name();
  }

  fs::path folder = fs::path(testing::TempDir()) / ("plimsoll_whole_" + test_name());
};

/// The process's umask, put back at the end.
class Umask {
 public:
  explicit Umask(mode_t mask) : before_(::umask(mask)) {}
  ~Umask() { ::umask(before_); }
  Umask(const Umask&) = delete;
  Umask& operator=(const Umask&) = delete;

 private:
  mode_t before_;
};

/// The process's folder, put back at the end.
class WorkingFolder {
 public:
  explicit WorkingFolder(const fs::path& folder) : before_(fs::current_path()) {
    fs::current_path(folder);
  }
  ~WorkingFolder() { fs::current_path(before_); }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

 private:
  fs::path before_;
};

TEST_F(FileWrittenWhole, ReplacesWhatWasThereAndLeavesNoPart) {
  app::write_whole(folder / "a.csv", "longer than the next\n");
  app::write_whole(folder / "a.csv", std::string("b\0c\n", 4));
  EXPECT_EQ(bytes_in(folder / "a.csv"), std::string("b\0c\n", 4));
  EXPECT_THAT(files_in(folder), ElementsAre("a.csv"));
}

TEST_F(FileWrittenWhole, MakesTheFoldersAboveIt) {
  app::write_whole(folder / "x/y/a.csv", "a\n");
  EXPECT_EQ(bytes_in(folder / "x/y/a.csv"), "a\n");
}

TEST_F(FileWrittenWhole, HasTheRightsThatTheUmaskLeaves) {
  for (const mode_t mask : {0022U, 0077U, 0002U}) {
    const Umask umask(mask);
    app::write_whole(folder / "a.csv", "a\n");
    EXPECT_EQ(fs::status(folder / "a.csv").permissions(), fs::perms(0666U & ~mask));
  }
}

TEST_F(FileWrittenWhole, NeedsNoFolderInItsName) {
  const WorkingFolder here(folder);
  app::write_whole("a.csv", "a\n");
  EXPECT_EQ(bytes_in(folder / "a.csv"), "a\n");
  EXPECT_THAT(files_in(folder), ElementsAre("a.csv"));
}

TEST_F(FileWrittenWhole, IsThatOfOneOfTwoWhoWriteAtOnce) {
  constexpr int kTimes = 20;
  const std::string a(100'000, 'a'), b(200'000, 'b');
  const auto write = [&](const std::string& bytes) {
    for (int i = 0; i < kTimes; ++i) app::write_whole(folder / "a.csv", bytes);
  };
  std::thread other(write, b);
  for (int i = 0; i < kTimes; ++i) {
    app::write_whole(folder / "a.csv", a);
    const std::string read = bytes_in(folder / "a.csv");
    EXPECT_TRUE(read == a || read == b) << read.size();
  }
  other.join();
  EXPECT_THAT(files_in(folder), ElementsAre("a.csv"));
}

TEST_F(FileWrittenWhole, RemovesTheTemporaryFilesOfTheDeadOnly) {
  for (const char* left : {"b.csv.part-1-0", "c.txt.part-1-0", "d.csv.part-mine", "part-1-0"})
    std::ofstream(folder / left) << "x";
  app::PartFile alive(folder / "e.csv");
  app::write_whole(folder / "a.csv", "a\n");
  const std::string name = fs::path(alive.name()).filename().string();
  EXPECT_THAT(files_in(folder),
              ElementsAre("a.csv", "c.txt.part-1-0", "d.csv.part-mine", name, "part-1-0"));
  app::remove_left_parts(folder);
  EXPECT_THAT(files_in(folder), ElementsAre("a.csv", "d.csv.part-mine", name, "part-1-0"));
  alive.write("e\n");
  alive.rename();
  EXPECT_EQ(bytes_in(folder / "e.csv"), "e\n");
}

/// The fault of writing a file.
std::string write_fault(const fs::path& file) {
  try {
    app::write_whole(file, "a\n");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST_F(FileWrittenWhole, IsNamedWhereItCannotBe) {
  app::write_whole(folder / "file", "a\n");
  EXPECT_THAT(write_fault(folder / "file/a.csv"), HasSubstr("file/a.csv cannot be written: "));
  fs::create_directory(folder / "a.csv");
  EXPECT_EQ(write_fault(folder / "a.csv"),
            (folder / "a.csv").string() + " cannot be written: Is a directory");
  EXPECT_THAT(files_in(folder), ElementsAre("a.csv", "file"));
  // Who may write anywhere is stopped by the kernel's own files alone.
  EXPECT_THAT(write_fault("/proc/a.csv"), HasSubstr("/proc/a.csv cannot be written: "));
}

}  // namespace

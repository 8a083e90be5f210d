#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "app/logs/hdf5_file.h"
#include "app/logs/hdf5_reader.h"
#include "app/scene/diagnostics.h"
#include "tests/support/repeats.h"

/// What a killed program leaves of an HDF5 file, and how another one goes on.

namespace {

namespace fs = std::filesystem;

/// Series of two numbers a row: enough of them that the structure of the file has several blocks.
const int kManySeries = 20;

app::Hdf5Series numbered_series(int i) {
  return {.name = "s" + std::to_string(i), .units = "1", .columns = {"a", "b"}, .shape = {2}};
}

/// Writes a row after the other, flushes after each, and says each time how many there are.
[[noreturn]] void write_for_ever(const fs::path& path, int told) {
  app::Hdf5Writer file(path);
  for (int i = 0; i < kManySeries; ++i) file.add_series(numbered_series(i), {16, 2});
  for (std::uint64_t rows = 1;; ++rows) {
    const std::vector<double> row = {static_cast<double>(rows), -static_cast<double>(rows)};
    for (std::size_t i = 0; i < kManySeries; ++i) file.append(i, row);
    file.flush();
    if (::write(told, &rows, sizeof rows) != sizeof rows) ::_exit(1);
  }
}

TEST(Hdf5Extended, GoesOnAfterTheSameNumbersOnly) {
  if (!app::why_no_hdf5().empty()) GTEST_SKIP() << app::why_no_hdf5();
  const fs::path path = fs::temp_directory_path() / ("hash" + std::to_string(::getpid()) + ".h5");
  const std::vector<double> rows = {1, 2, 3, 4, 5, 6};
  std::uint64_t two = 0, three = 0;
  {
    app::Hdf5Writer file(path);
    file.add_series(numbered_series(0), {16, 2});
    file.append(0, std::span(rows).first(4));
    two = file.hash_of(0);
    file.append(0, std::span(rows).subspan(4));
    three = file.hash_of(0);
    file.close();
  }
  using Mode = app::Hdf5Writer::Mode;
  // The library takes what it has open of a file for its content.
  const fs::path copy = path.string() + "-copy";
  fs::copy_file(path, copy);
  EXPECT_THROW(app::Hdf5Writer(copy, Mode::extend).find_series(numbered_series(0), 3, two),
               scene::InputError);
  {
    app::Hdf5Writer file(path, Mode::extend);
    file.find_series(numbered_series(0), 2, two);
    file.append(0, std::vector<double>{5, 6});
    EXPECT_EQ(file.hash_of(0), three);
    file.append(0, std::vector<double>{7, 8});
    file.close();
  }
  EXPECT_EQ(app::Hdf5Reader(path, {"s0"}).numbers("s0", {2}),
            (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
  fs::remove(path);
  fs::remove(copy);
}

TEST(Hdf5Killed, AtAnyMomentHasTheRowsOfTheLastFlush) {
  if (!app::why_no_hdf5().empty()) GTEST_SKIP() << app::why_no_hdf5();
  const fs::path path = fs::temp_directory_path() / ("killed" + std::to_string(::getpid()) + ".h5");
  std::vector<std::string> names;
  for (int i = 0; i < kManySeries; ++i) names.push_back(numbered_series(i).name);
  std::mt19937 random(7);
  for (int kill = 0; kill < support::repeats(20); ++kill) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t writer = ::fork();
    if (writer == 0) write_for_ever(path, ends[1]);
    ::close(ends[1]);
    std::uint64_t rows = 0;
    const std::uint64_t wanted = 1 + random() % 60;
    while (rows < wanted && ::read(ends[0], &rows, sizeof rows) == sizeof rows) {
    }
    ::usleep(static_cast<useconds_t>(random() % 5000));
    ::kill(writer, SIGKILL);
    int status = 0;
    ::waitpid(writer, &status, 0);
    std::uint64_t last = 0;
    while (::read(ends[0], &last, sizeof last) == sizeof last) rows = last;
    ::close(ends[0]);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    ASSERT_GE(rows, wanted);
    const app::Hdf5Reader file(path, names);
    for (int i = 0; i < kManySeries; ++i) {
      const std::vector<double> read = file.numbers(numbered_series(i).name, {2});
      ASSERT_GE(read.size(), 2 * rows);
      for (std::size_t k = 0; k < 2 * rows; ++k)
        ASSERT_EQ(read[k], (k % 2 ? -1 : 1) * static_cast<double>(k / 2 + 1));
    }
  }
  fs::remove(path);
}

}  // namespace

#include "app/run/run_need.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/assembly/build.h"
#include "app/logs/hdf5_file.h"
#include "app/run/log_subject.h"
#include "app/run/run.h"

namespace {

namespace fs = std::filesystem;

constexpr const char* kScene =
    "plimsoll: 1\nduration: 3\nstep: 0.01\nwater: {}\n"
    "hydro: {added_mass: none, lift: 0.01}\n"
    "log: {forces: true}\nbodies:\n"
    "  - {name: first, box: {size: [1, 1, 1]}, density: 500, angular_velocity: [0.1, 0.2, 0.3]}\n"
    "  - {name: second, box: {size: [1, 1, 1]}, density: 700, position: [3, 0, 0]}\n"
    "ropes: [{name: r, bodies: [first, second], points: [[0, 0, 0], [0, 0, 0]], length: 2,\n"
    "  stiffness: 1000}]\n";

/// Returns the size of the logs in a folder [bytes].
double logs_in(const fs::path& folder) {
  double size = 0;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".csv" || entry.path().extension() == ".h5")
      size += static_cast<double>(entry.file_size());
  return size;
}

TEST(RunNeed, OfALogIsItsSizeToAFactorOfTwo) {
  const fs::path out = fs::path(testing::TempDir()) / "run_need";
  fs::create_directories(out);
  const fs::path file = out / "scene.yaml";
  std::ofstream(file) << kScene;
  const scene::Scene scene = scene::read(file);
  const app::LogSubject subject =
      app::log_subject(scene, assembly::build_without_added_mass(scene));
  for (const app::LogFormat format : {app::LogFormat::csv, app::LogFormat::hdf5}) {
    if (format == app::LogFormat::hdf5 && !app::why_no_hdf5().empty()) continue;
    app::run({.scene = file, .out = out, .format = format, .threads = 1, .quiet = true});
    const double estimate = app::log_bytes(subject, app::logged_times(scene), format);
    EXPECT_GT(logs_in(out), estimate / 2);
    EXPECT_LT(logs_in(out), estimate * 2);
  }
  fs::remove_all(out);
}

TEST(RunNeed, ALogThatDoesNotFitOnTheDiskIsAWarning) {
  EXPECT_FALSE(app::log_warning(1e9, 2e9));
  EXPECT_FALSE(app::log_warning(1e9, std::nullopt));
  EXPECT_THAT(app::log_warning(2.4e11, 1.4e10).value_or(""),
              testing::HasSubstr("comes to about 240 GB, and the disk has 14 GB free"));
}

TEST(RunNeed, GrowsWithTheRowsOfTheLog) {
  scene::Scene scene;
  scene.duration = 100;
  scene.step = 0.01;
  EXPECT_EQ(app::logged_times(scene), 1 + 10'000);
  scene.log_every = 1;
  EXPECT_EQ(app::logged_times(scene), 1 + 100);
  app::LogSubject subject{.bodies = {"a"}};
  const double one = app::log_bytes(subject, 1e9, app::LogFormat::csv);
  subject.bodies.emplace_back("b");
  EXPECT_EQ(app::log_bytes(subject, 1e9, app::LogFormat::csv), 2 * one);
  EXPECT_GT(one, 1e11);
}

}  // namespace

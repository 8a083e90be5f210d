#include "app/logs/force_csv.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/scene/diagnostics.h"

namespace {

/// A log with one row of ones that lacks a number of columns at the end, in a file of this test:
/// others run at the same time.
std::filesystem::path log_without(std::size_t lacking) {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto file = std::filesystem::path(testing::TempDir()) / ("force_csv_" + test + ".csv");
  std::string header = app::force_header(), row = "0.5,buoy";
  for (std::size_t i = 0; i < lacking; ++i) header.resize(header.rfind(','));
  for (std::size_t i = lacking; i < app::force_columns().size(); ++i) row += ",1";
  std::ofstream(file) << header << "\n" << row << "\n";
  return file;
}

TEST(ForceCsv, ReadsALogOfAnOlderVersionThatLacksTheLastColumns) {
  for (const std::size_t lacking : {std::size_t{0}, std::size_t{7}}) {
    const app::ForceTrack track = app::read_force_csv(log_without(lacking)).at("buoy");
    ASSERT_EQ(track.columns.size(), app::force_columns().size());
    for (std::size_t i = 0; i < track.columns.size(); ++i)
      EXPECT_EQ(track.columns[i],
                std::vector<double>{i < track.columns.size() - lacking ? 1.0 : 0.0});
  }
}

TEST(ForceCsv, RefusesAnotherHeader) {
  const auto file = log_without(0);
  std::ofstream(file) << "time,body,buoyancy_fx,lift_fx\n0,buoy,1,2\n";
  EXPECT_THROW(app::read_force_csv(file), scene::InputError);
}

}  // namespace

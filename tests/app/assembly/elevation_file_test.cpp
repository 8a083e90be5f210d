#include "app/assembly/elevation_file.h"

#include "tests/app/assembly/file_reader_test.h"

namespace {

using ElevationFile = support::FileReaderTest<assembly::read_elevation>;

/// A record at these times.
std::string record_at(const std::vector<double>& times) {
  std::string text = "time,elevation\n";
  for (const double time : times) text += std::to_string(time) + ",1\n";
  return text;
}

TEST_F(ElevationFile, TimesMayHaveFewDigits) {
  const auto record = read(
      "# time: s\ntime,elevation\n10.00,1\n10.03,2\n10.07,3\n10.10,4\n10.13,5\n10.17,6\n10.20,7\n"
      "10.23,8\n10.27,9\n10.30,10\n");
  EXPECT_EQ(record.start, 10);
  EXPECT_NEAR(record.interval, 1.0 / 30, 1e-12);
  EXPECT_EQ(record.elevations.size(), 10u);
  EXPECT_EQ(record.elevations.back(), 10);
}

TEST_F(ElevationFile, AFaultHasItsPlace) {
  EXPECT_EQ(fault("t,eta\n"),
            ":1:6: found 't' in the header, expected the columns time [s] and elevation [m]");
  EXPECT_EQ(fault("time\n"), ": expected the columns time [s] and elevation [m]");
  EXPECT_EQ(fault(record_at({0, 1, 2})), ": found 3 rows, expected at least 8");
  EXPECT_EQ(fault(record_at({0, 1, 2, 3, 3, 4, 5, 6, 7})),
            ":6:1: found the time 3 s after 3 s, expected ascending ones");
  EXPECT_EQ(fault(record_at({0, 1, 2, 3, 5, 6, 7, 8, 9})),
            ":6:1: found the time 5 s after 3 s, a gap: the mean interval is 1.125 s, and the "
            "elevations must be at equal ones");
  EXPECT_EQ(fault(record_at({0, 1, 2, 3, 4, 5.3, 6, 7, 8})),
            ":7:1: found the time 5.3 s, expected 5 s: the elevations must be at equal intervals, "
            "here of 1 s");
}

}  // namespace

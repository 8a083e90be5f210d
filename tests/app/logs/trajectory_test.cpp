#include "app/logs/trajectory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "app/base/output_error.h"
#include "app/logs/read_log.h"
#include "app/logs/trajectory_csv.h"
#include "app/scene/diagnostics.h"
#include "tests/app/program/program.h"
#include "tests/support/files.h"
#include "tests/support/random_pose.h"

namespace {

namespace fs = std::filesystem;
using app::read_trajectory;
using app::Trajectory;
using app::TrajectoryWriter;
using hydro::BodyState;
using scene::InputError;
using support::kTrajectoryHeader;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kRow = ",0,0,0,1,0,0,0,0,0,0,0,0,0\n";  // after the time and the name

class TrajectoryFile : public testing::Test {
 protected:
  ~TrajectoryFile() override { fs::remove(file_); }

  const fs::path& file() const { return file_; }
  const fs::path& holding(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
    return file_;
  }
  std::string text() const { return support::bytes_in(file_); }
  /// The fault of a file with this text, without the file's name.
  std::string fault(const std::string& text) const {
    try {
      read_trajectory(holding(text));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file_.string().size());
    }
    return "none";
  }

 private:
  fs::path file_ = fs::path(testing::TempDir()) /
                   (std::string("trajectory_") +
                    testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv");
};

TEST_F(TrajectoryFile, StartsWithTheHeaderThatScriptsRelyOn) {
  TrajectoryWriter(file(), {"a"}).add(0, {BodyState{}});
  EXPECT_EQ(text(), kTrajectoryHeader + "0,a" + kRow);
}

TEST_F(TrajectoryFile, GivesBackTheSameNumbers) {
  support::Random random(1);
  std::vector<double> times;
  std::vector<std::vector<BodyState>> states;
  {
    TrajectoryWriter writer(file(), {"a", "b"});
    for (int i = 0; i < 200; ++i) {
      const double size = std::pow(10, random.uniform(-300, 300));
      states.push_back({random.state(size, 1 / size), random.state(1, 1)});
      times.push_back(i / 60.0);
      writer.add(times.back(), states.back());
    }
  }
  const Trajectory read = read_trajectory(file());
  EXPECT_THAT(read.names, ElementsAre("a", "b"));
  for (std::size_t body = 0; body < 2; ++body) {
    const app::BodyTrack& track = read.tracks.at(read.names[body]);
    ASSERT_EQ(track.times, times);
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(track.states[i], states[i][body]);
  }
}

TEST_F(TrajectoryFile, KeepsTheLeastAndTheLargestNumbersAndMinusZero) {
  BodyState state;
  state.position = {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(),
                    -0.0};
  TrajectoryWriter(file(), {"a"}).add(0, {state});
  const BodyState read = read_trajectory(file()).tracks.at("a").states[0];
  EXPECT_EQ(read.position, state.position);
  EXPECT_TRUE(std::signbit(read.position.z()));
}

TEST_F(TrajectoryFile, IsCompleteAfterEveryRow) {
  TrajectoryWriter writer(file(), {"a"});
  for (int i = 0; i < 3; ++i) {
    writer.add(i, {BodyState{}});
    EXPECT_EQ(read_trajectory(file()).tracks.at("a").times.size(), static_cast<std::size_t>(i + 1));
  }
}

TEST_F(TrajectoryFile, OfAScenesOwnNamesKeepsThem) {
  const std::vector<std::string> names = {"Blåhaj the 鯊", " a;b ", "../x"};
  TrajectoryWriter(file(), names).add(0, std::vector<BodyState>(3));
  EXPECT_EQ(read_trajectory(file()).names, names);
}

TEST_F(TrajectoryFile, LosesOnlyALastLineThatWasCutOff) {
  const std::string whole = kTrajectoryHeader + "0,a" + kRow + "1,a" + kRow;
  const std::string next = "2,a" + kRow;
  for (std::size_t length = 0; length < next.size(); ++length)
    EXPECT_THAT(read_trajectory(holding(whole + next.substr(0, length))).tracks.at("a").times,
                ElementsAre(0, 1))
        << length;
  EXPECT_THAT(read_trajectory(holding(whole + next)).tracks.at("a").times, ElementsAre(0, 1, 2));
}

TEST_F(TrajectoryFile, MayHaveTheLineEndsOfOtherSystems) {
  std::string text = kTrajectoryHeader + "0,a" + kRow + "1,a" + kRow;
  for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 2))
    text.insert(i, 1, '\r');
  const Trajectory read = read_trajectory(holding(text));
  EXPECT_THAT(read.tracks.at("a").times, ElementsAre(0, 1));
}

TEST_F(TrajectoryFile, WithAnotherHeaderIsRefused) {
  const std::string expected = ":1:1: expected the header " + kTrajectoryHeader;
  EXPECT_EQ(fault("t,body,x\n0,a,0\n") + "\n", expected);
  EXPECT_EQ(fault("0,a" + kRow) + "\n", expected);
  EXPECT_EQ(fault(kTrajectoryHeader.substr(1) + "0,a" + kRow) + "\n", expected);
}

TEST_F(TrajectoryFile, WithoutRowsIsRefused) {
  EXPECT_EQ(fault(kTrajectoryHeader), ": has no rows");
  EXPECT_EQ(fault(kTrajectoryHeader + "0,a,0"), ": has no rows");
  EXPECT_EQ(fault(""), ": has no rows");
}

TEST_F(TrajectoryFile, NamesTheLineWithAWrongNumberOfFields) {
  const std::string good = kTrajectoryHeader + "0,a" + kRow;
  EXPECT_EQ(fault(good + "1,a,0\n"), ":3:1: found 3 fields, expected 15");
  EXPECT_EQ(fault(good + "1,a,0" + kRow), ":3:1: found 16 fields, expected 15");
  EXPECT_EQ(fault(good + "\n" + good), ":3:1: found 1 fields, expected 15");
}

TEST_F(TrajectoryFile, NamesTheLineOfWhatIsNoFiniteNumber) {
  for (const std::string word : {"", "abc", "1.5x", " 1", "nan", "inf", "-inf", "1e999", "0x10"}) {
    const std::string expected = ":2:1: found \"" + word + "\", expected a finite number";
    EXPECT_EQ(fault(kTrajectoryHeader + word + ",a" + kRow), expected);
    EXPECT_EQ(fault(kTrajectoryHeader + "0,a," + word + kRow.substr(2)), expected);
  }
}

TEST_F(TrajectoryFile, NamesTheLineOfATimeThatDoesNotAscend) {
  EXPECT_EQ(fault(kTrajectoryHeader + "0,a" + kRow + "0,b" + kRow + "1,a" + kRow + "0.5,a" + kRow),
            ":5:1: time 0.5 of body a does not come after 1");
  EXPECT_EQ(fault(kTrajectoryHeader + "0,a" + kRow + "0,a" + kRow),
            ":3:1: time 0 of body a does not come after 0");
}

TEST_F(TrajectoryFile, NamesTheLineOfAQuaternionThatIsNoRotation) {
  EXPECT_EQ(fault(kTrajectoryHeader + "0,a,0,0,0,0,0,0,0,0,0,0,0,0,0\n"),
            ":2:1: the quaternion has length 0, expected 1");
  EXPECT_EQ(fault(kTrajectoryHeader + "0,a,0,0,0,0.7,0.7,0,0,0,0,0,0,0,0\n"),
            ":2:1: the quaternion has length 0.989949, expected 1");
  EXPECT_EQ(fault(kTrajectoryHeader + "0,a,0,0,0,0.71,0.71,0,0,0,0,0,0,0,0\n"), "none");
}

TEST_F(TrajectoryFile, ThatIsNoFileIsRefused) {
  EXPECT_THROW(read_trajectory(testing::TempDir()), InputError);
  EXPECT_THROW(read_trajectory(file() / "nowhere"), InputError);
  EXPECT_THROW(TrajectoryWriter(testing::TempDir(), {"a"}), InputError);
}

TEST_F(TrajectoryFile, OnAFullDiskIsAnErrorAtTheFirstRowLost) {
  TrajectoryWriter writer("/dev/full", {"a"});
  try {
    writer.add(0, {BodyState{}});
    FAIL() << "written";
  } catch (const app::OutputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/dev/full: cannot be written: No space left"));
  }
}

}  // namespace

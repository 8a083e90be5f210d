#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/program/page.h"
#include "tests/app/program/program.h"

/// The data that `plimsoll compare --html` puts into its page, and what it says when it cannot.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::Outcome;
using support::packed_numbers;
using support::Workplace;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// `time,body,x` rows of bodies at y = z = 0, upright.
std::string trajectory(const std::vector<std::string>& rows) {
  std::string text = support::kTrajectoryHeader;
  for (const std::string& row : rows) text += row + ",0,0,1,0,0,0,0,0,0,0,0,0\n";
  return text;
}

class ProgramComparison : public testing::Test {
 protected:
  ProgramComparison() { support::lay_out_page(here, "comparison.html"); }

  Outcome compare(const std::string& arguments) const {
    return here.shell("bin/plimsoll compare " + arguments);
  }

  /// The data in the page of a comparison, which ends with a code.
  json data(const std::string& arguments, int code) const {
    const Outcome outcome = compare(arguments + " --html c.html");
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith("c.html: 0.0 MB"));
    return support::data_in_page(here.read("c.html"));
  }

  Workplace here;
};

TEST_F(ProgramComparison, HasTheVerdictAndTheTable) {
  here.write("a.csv", trajectory({"0,p,0", "1,p,0", "2,p,0", "0,q,0", "2,q,0"}));
  here.write("b.csv", trajectory({"0,p,0", "1,p,0.25", "2,p,0.5", "0,q,0", "2,q,0"}));
  const json page = data("a.csv b.csv --tol position=0.1", 1);
  EXPECT_EQ(page["a"], "a.csv");
  EXPECT_EQ(page["b"], "b.csv");
  EXPECT_EQ(page["same"], false);
  ASSERT_EQ(page["bodies"].size(), 2u);
  EXPECT_EQ(page["bodies"][0]["name"], "p");
  EXPECT_EQ(page["bodies"][0]["same"], false);
  EXPECT_EQ(page["bodies"][1]["same"], true);
  const json& position = page["bodies"][0]["differences"][0];
  EXPECT_EQ(position["largest"], 0.5);
  EXPECT_EQ(position["at"], 2);
  EXPECT_EQ(position["tolerance"], 0.1);
  EXPECT_EQ(position["first_beyond"], 1);
  EXPECT_EQ(position["verdict"], "exceeds it from 1 s");
  const json& turned = page["bodies"][0]["differences"][1];
  EXPECT_TRUE(turned["tolerance"].is_null());
  EXPECT_TRUE(turned["first_beyond"].is_null());
  EXPECT_EQ(data("a.csv a.csv", 0)["same"], true);
}

TEST_F(ProgramComparison, HasEachLogAtItsOwnTimesAndTheDifferences) {
  here.write("a.csv", trajectory({"0,p,1", "1,p,2", "2,p,4"}));
  here.write("b.csv", trajectory({"0,p,1", "2,p,4.5", "3,p,7"}));
  const json body = data("a.csv b.csv", 1)["bodies"][0];
  EXPECT_EQ(body["note"], "2 times compared, 0 rows only in a.csv, 1 only in b.csv");
  EXPECT_THAT(packed_numbers<double>(body["a"]["times"]), ElementsAre(0, 1, 2));
  EXPECT_THAT(packed_numbers<double>(body["b"]["times"]), ElementsAre(0, 2, 3));
  EXPECT_THAT(packed_numbers<double>(body["over"]["times"]), ElementsAre(0, 2));
  EXPECT_EQ(body["b"]["columns"][0]["base"], 1);
  EXPECT_THAT(packed_numbers<float>(body["b"]["columns"][0]["data"]), ElementsAre(0, 3.5, 6));
  EXPECT_THAT(packed_numbers<float>(body["over"]["columns"][0]["data"]), ElementsAre(0, 0.5));
  EXPECT_EQ(body["over"]["columns"][1], 0);  // never turned
}

TEST_F(ProgramComparison, DrawsAnglesBesideEachOtherAcrossAHalfTurn) {
  // A quarter of a degree to either side of a yaw of 180 degrees.
  const std::string yaw = "0,0,0.0021816616,0,0,1,0,0,0,0,0,0\n";
  const std::string other = "0,0,-0.0021816616,0,0,1,0,0,0,0,0,0\n";
  here.write("a.csv", support::kTrajectoryHeader + "0,p,0," + yaw);
  here.write("b.csv", support::kTrajectoryHeader + "0,p,0," + other);
  const json body = data("a.csv b.csv", 1)["bodies"][0];
  constexpr double kRounding = 1e-5;  // [deg], of the quaternion's digits
  EXPECT_NEAR(body["a"]["columns"][5].get<double>(), 179.75, kRounding);
  EXPECT_NEAR(body["b"]["columns"][5].get<double>(), 180.25, kRounding);
}

TEST_F(ProgramComparison, HasBodiesThatAreOnlyInOneLog) {
  here.write("a.csv", trajectory({"0,p,0", "0,q</script>,0"}));
  here.write("b.csv", trajectory({"0,p,0", "0,r,0"}));
  const json bodies = data("a.csv b.csv", 1)["bodies"];
  ASSERT_EQ(bodies.size(), 3u);
  EXPECT_EQ(bodies[1]["name"], "q</script>");
  EXPECT_EQ(bodies[1]["note"], "only in a.csv");
  EXPECT_FALSE(bodies[1].contains("b") || bodies[1].contains("differences"));
  EXPECT_FALSE(bodies[2].contains("a"));
}

TEST_F(ProgramComparison, PrintsTheSameWithAndWithoutAPage) {
  here.write("a.csv", trajectory({"0,p,0"}));
  here.write("b.csv", trajectory({"0,p,1"}));
  EXPECT_EQ(compare("a.csv b.csv --html c.html").out, compare("a.csv b.csv").out);
  EXPECT_EQ(compare("a.csv b.csv --json --html c.html").out, compare("a.csv b.csv --json").out);
}

TEST_F(ProgramComparison, SaysHowToGetAPageThatWasNotBuiltBeforeItPrints) {
  here.write("a.csv", trajectory({"0,p,0"}));
  fs::remove(here / "share/plimsoll/report/comparison.html");
  const Outcome outcome = compare("a.csv a.csv --html c.html");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("for which npm is needed; run tools/report, or install npm "
                                     "and build the target report_page"));
  EXPECT_FALSE(fs::exists(here / "c.html"));
  EXPECT_EQ(compare("a.csv a.csv").code, 0);
}

TEST_F(ProgramComparison, WritesNoPageOfLogsThatAreBroken) {
  here.write("a.csv", trajectory({"0,p,0"}));
  EXPECT_EQ(compare("a.csv none.csv --html c.html").code, 2);
  EXPECT_FALSE(fs::exists(here / "c.html"));
}

}  // namespace

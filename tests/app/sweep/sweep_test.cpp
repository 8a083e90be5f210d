#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <thread>

#include "app/base/file_lock.h"
#include "app/scene/diagnostics.h"
#include "app/sweep/ranks.h"
#include "app/sweep/sweep_outcome.h"
#include "app/sweep/sweep_parameters.h"
#include "app/sweep/sweep_slurm.h"
#include "app/sweep/sweep_survey.h"

/// What a sweep is made of, without running anything.

namespace {

/// A file of the test that runs, beside which others may.
std::filesystem::path own_file(const std::string& extension) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(testing::TempDir()) /
         (std::string(test.test_suite_name()) + "." + test.name() + extension);
}

namespace fs = std::filesystem;
using app::parse_sweep_parameter;
using app::SweepParameter;
using app::SweepPoint;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::vector<std::string> values_of(const std::string& values) {
  return parse_sweep_parameter("key=" + values).values;
}

std::string fault_of(const std::string& argument) {
  try {
    app::grid({parse_sweep_parameter(argument)});
  } catch (const scene::InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(SweepParameters, RangesIncludeTheLastValueDespiteRounding) {
  EXPECT_THAT(values_of("0:1:0.1"),
              ElementsAre("0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"));
  EXPECT_THAT(values_of("200:1000:100"), SizeIs(9));
  EXPECT_THAT(values_of("200:1000:300"), ElementsAre("200", "500", "800"));
  EXPECT_THAT(values_of("10:0:-2.5"), ElementsAre("10", "7.5", "5", "2.5", "0"));
  EXPECT_THAT(values_of("-0.2:0.2:0.2"), ElementsAre("-0.2", "0", "0.2"));
  EXPECT_THAT(values_of("1e-3:3e-3:1e-3"), ElementsAre("0.001", "0.002", "0.003"));
  EXPECT_THAT(values_of("1e3:2e3:5e2"), ElementsAre("1000", "1500", "2000"));
  EXPECT_THAT(values_of("5:5:1"), ElementsAre("5"));
}

TEST(SweepParameters, StepsSmallerThanFifteenPlacesAreKeptToo) {
  const std::vector<std::string> values = values_of("0:3e-20:1e-20");
  ASSERT_THAT(values, SizeIs(4));
  EXPECT_DOUBLE_EQ(std::strtod(values[2].c_str(), nullptr), 2e-20);
}

TEST(SweepParameters, ListsAreSplitAtTheirOwnCommasOnly) {
  EXPECT_THAT(values_of("0.1, 0.2"), ElementsAre("0.1", "0.2"));
  EXPECT_THAT(values_of("[0, 0, 1],[1, 0, 1]"), ElementsAre("[0, 0, 1]", "[1, 0, 1]"));
  EXPECT_THAT(values_of("{waves: [{amplitude: 1}]},flat"),
              ElementsAre("{waves: [{amplitude: 1}]}", "flat"));
  EXPECT_THAT(values_of(R"("a,b",'c,''d',"e\",f")"),
              ElementsAre(R"("a,b")", "'c,''d'", R"("e\",f")"));
  EXPECT_THAT(values_of("ode"), ElementsAre("ode"));
  EXPECT_THAT(values_of("a:b"), ElementsAre("a:b"));
}

TEST(SweepParameters, TheKeyMayHoldANameWithAnEqualsSign) {
  EXPECT_EQ(parse_sweep_parameter("bodies[a=b].density=1,2").key_path, "bodies[a=b].density");
}

TEST(SweepParameters, FaultsSayWhatIsRight) {
  EXPECT_THAT(fault_of("density"), HasSubstr("found density, expected KEY.PATH=FIRST:LAST:STEP"));
  EXPECT_THAT(fault_of(""), HasSubstr("found nothing, expected KEY.PATH="));
  EXPECT_THAT(fault_of("a=1,,2"), HasSubstr("a: found 1,,2, expected a value before and after"));
  EXPECT_THAT(fault_of("a="), HasSubstr("a: found nothing, expected a value"));
  EXPECT_THAT(fault_of("a=1:2:0"), HasSubstr("a: found 1:2:0, expected FIRST:LAST:STEP"));
  EXPECT_THAT(fault_of("a=1:2:-1"), HasSubstr("a: found 1:2:-1, expected FIRST:LAST:STEP"));
  EXPECT_THAT(fault_of("a=0:1:1e-9"), HasSubstr("in fewer than 1000000"));
  EXPECT_THAT(fault_of("a=1:2"), HasSubstr("a: found a range without steps"));
}

TEST(SweepParameters, TheLastParameterOfAGridChangesFirst) {
  const std::vector<SweepPoint> points =
      app::grid({parse_sweep_parameter("a=1:2:1"), parse_sweep_parameter("b=x"),
                 parse_sweep_parameter("c=p,q,r")});
  ASSERT_THAT(points, SizeIs(6));
  EXPECT_THAT(points[0], ElementsAre("1", "x", "p"));
  EXPECT_THAT(points[1], ElementsAre("1", "x", "q"));
  EXPECT_THAT(points[5], ElementsAre("2", "x", "r"));
}

TEST(SweepParameters, AGridOfTooManyRunsIsRefused) {
  const SweepParameter parameter = parse_sweep_parameter("a=1:2000:1");
  EXPECT_THROW(app::grid({parameter, parameter}), scene::InputError);
}

TEST(LatinHypercube, HasOneSampleInEachPartOfARange) {
  for (const std::size_t samples : {1u, 7u, 500u}) {
    const auto points = app::latin_hypercube(
        {parse_sweep_parameter("a=-3:5"), parse_sweep_parameter("b=2:1")}, samples, 42);
    ASSERT_THAT(points, SizeIs(samples));
    std::set<long> a, b;
    const auto n = static_cast<double>(samples);
    for (const SweepPoint& point : points) {
      a.insert(std::lround(std::floor((std::strtod(point[0].c_str(), nullptr) + 3) / 8 * n)));
      b.insert(std::lround(std::floor((2 - std::strtod(point[1].c_str(), nullptr)) * n)));
    }
    for (const std::set<long>& parts : {a, b}) {
      EXPECT_THAT(parts, SizeIs(samples));
      EXPECT_EQ(*parts.begin(), 0);
      EXPECT_EQ(*parts.rbegin(), static_cast<long>(samples) - 1);
    }
  }
}

TEST(LatinHypercube, TakesGivenValuesEquallyOften) {
  const auto points = app::latin_hypercube(
      {parse_sweep_parameter("a=0:1:0.5"), parse_sweep_parameter("b=x,y")}, 20, 3);
  std::map<std::string, int> a, b;
  for (const SweepPoint& point : points) {
    ++a[point[0]];
    ++b[point[1]];
  }
  EXPECT_THAT(a, SizeIs(3));
  for (const auto& [value, count] : a) EXPECT_TRUE(count == 6 || count == 7) << value;
  EXPECT_EQ(b["x"], 10);
  EXPECT_EQ(b["y"], 10);
}

// The numbers are those of a second implementation, in Python, of the published engine.
TEST(LatinHypercube, IsTheSameOnEveryMachine) {
  const auto points = app::latin_hypercube(
      {parse_sweep_parameter("a=200:1000"), parse_sweep_parameter("b=a,b")}, 4, 1);
  EXPECT_THAT(
      points,
      ElementsAre(ElementsAre("404.2048456833454", "b"), ElementsAre("670.179622756584", "a"),
                  ElementsAre("982.2716095822353", "b"), ElementsAre("294.1504264980465", "a")));
  EXPECT_NE(app::latin_hypercube({parse_sweep_parameter("a=200:1000")}, 4, 2)[0][0], points[0][0]);
}

/// Half a turn of the body's z axis by way of the horizontal, while it rises and falls.
app::BodyTrack rolling_track() {
  app::BodyTrack track;
  for (const double quarter : {0.0, 1.0, 0.5}) {
    hydro::BodyState state;
    state.position = {1, 2, 3 + quarter};
    state.orientation = Eigen::AngleAxisd(quarter * M_PI / 2, Eigen::Vector3d::UnitX());
    state.linear_velocity = {0, 0, 4 * quarter};
    state.angular_velocity = {quarter, 0, 0};
    track.times.push_back(static_cast<double>(track.times.size()) * 0.5);
    track.states.push_back(state);
  }
  return track;
}

double value_of(const app::BodyOutcome& outcome, const std::string& column) {
  for (std::size_t i = 0; i < app::kBodyColumns.size(); ++i)
    if (app::kBodyColumns[i] == column) return outcome.values[i];
  ADD_FAILURE() << "no column " << column;
  return 0;
}

TEST(SweepOutcome, HasTheLastAndTheExtremeValuesOfATrack) {
  const app::BodyOutcome outcome = app::body_outcome("a", rolling_track());
  EXPECT_EQ(value_of(outcome, "z"), 3.5);
  EXPECT_EQ(value_of(outcome, "vz"), 2);
  EXPECT_EQ(value_of(outcome, "wx"), 0.5);
  EXPECT_EQ(value_of(outcome, "z_min"), 3);
  EXPECT_EQ(value_of(outcome, "z_max"), 4);
  EXPECT_EQ(value_of(outcome, "speed_max"), 4);
  EXPECT_EQ(value_of(outcome, "angular_speed_max"), 1);
  EXPECT_EQ(value_of(outcome, "acceleration_max"), 8);
  constexpr double kAngleRoundOff = 1e-12;
  EXPECT_NEAR(value_of(outcome, "tilt_deg"), 45, kAngleRoundOff);
  EXPECT_NEAR(value_of(outcome, "tilt_max_deg"), 90, kAngleRoundOff);
}

TEST(SweepOutcome, IsReadBackToTheSameNumbers) {
  const fs::path file = own_file(".json");
  const app::RunOutcome outcome = {
      3, 1.0 / 3, 0.1, "a, \"b\"\nc", {app::body_outcome("a", rolling_track())}};
  app::write_outcome(outcome, file);
  const auto read = app::read_outcome(file);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->code, outcome.code);
  EXPECT_EQ(read->simulated, outcome.simulated);
  EXPECT_EQ(read->wall, outcome.wall);
  EXPECT_EQ(read->message, outcome.message);
  ASSERT_THAT(read->bodies, SizeIs(1));
  EXPECT_EQ(read->bodies[0].values, outcome.bodies[0].values);
  fs::resize_file(file, fs::file_size(file) / 2);
  EXPECT_FALSE(app::read_outcome(file));
  fs::remove(file);
  EXPECT_FALSE(app::read_outcome(file));
}

TEST(SweepOutcome, TheTableHasARowARunThatIsDone) {
  const std::vector<SweepParameter> parameters = {
      parse_sweep_parameter("size=[1, 2],[2, 3],[3, 4]")};
  const app::RunOutcome failed = {2, {}, 0.25, "no \"size\"\nat all", {}};
  const app::BodyOutcome body = app::body_outcome("b", rolling_track());
  const app::RunOutcome done = {0, 2, 1, "", {body}};
  const std::string table =
      app::table_of(parameters, app::grid(parameters), {"b"}, {failed, std::nullopt, done});
  EXPECT_THAT(table, testing::StartsWith("run,size,exit_code,simulated_seconds,wall_seconds,b.x,"));
  EXPECT_THAT(table,
              HasSubstr(",b.tilt_max_deg,message\n0000,\"[1, 2]\",2,,0.250,,,,,,,,,,,,,,,,,"
                        ",,,,\"no \"\"size\"\" at all\"\n0002,\"[3, 4]\",0,2,1.000,1,2,3.5,"));
}

TEST(SweepOutcome, HasTheStrokeAndPowerOfJoints) {
  const fs::path folder = own_file("");
  fs::create_directories(folder);
  std::ofstream(folder / "summary.json")
      << R"({"ended": "completed", "simulated_seconds": 2, "joints": {"pto":)"
         R"( {"position_error_max": 9, "stroke": 1.5, "power_mean": 20, "damper":)"
         R"( {"power_mean": 30}}, "eye": {"position_error_max": 9}}})";
  const app::RunOutcome outcome = app::collect_outcome(folder, folder / "messages.txt", 0, 1);
  app::write_outcome(outcome, folder / "outcome.json");
  const auto read = app::read_outcome(folder / "outcome.json");
  ASSERT_TRUE(read);
  const std::vector<SweepParameter> parameters = {parse_sweep_parameter("size=1,2")};
  const app::RunOutcome failed = {2, {}, 0.25, "no", {}};
  EXPECT_EQ(app::table_of(parameters, app::grid(parameters), {}, {failed, *read}),
            "run,size,exit_code,simulated_seconds,wall_seconds,message,joints.pto.stroke,"
            "joints.pto.power_mean\n0000,1,2,,0.250,no,,\n0001,2,0,2,1.000,,1.5,20\n");
  fs::remove_all(folder);
}

/// A sweep of a box beside a body that is varied.
class Survey : public testing::Test {
 protected:
  Survey() {
    std::ofstream(file)
        << "plimsoll: 1\nduration: 1\nwater: {}\nbodies:\n"
           "  - {name: a, box: {size: [1, 1, 1]}, density: 500}\n"
           "  - {name: b, sphere: {radius: 1}, density: 500, position: [5, 0, 0]}\n";
  }
  ~Survey() override { fs::remove(file); }

  app::SweepSurvey of(const std::vector<std::string>& varied) const {
    app::SweepPlan plan = {.scene = file, .overrides = {}, .parameters = {}, .points = {}};
    for (const std::string& one : varied) plan.parameters.push_back(parse_sweep_parameter(one));
    plan.points = app::grid(plan.parameters);
    return app::survey(plan);
  }

  const fs::path file = own_file(".yaml");
};

TEST_F(Survey, PutsTheFirstRunOfEachMeshFirst) {
  const std::string density = "bodies[1].density=100,200,300";
  EXPECT_THAT(of({density}).order, ElementsAre(0, 1, 2));
  EXPECT_THAT(of({"bodies[1].sphere.radius=1,2", density}).order, ElementsAre(0, 3, 1, 2, 4, 5));
  EXPECT_THAT(of({density, "bodies[1].sphere.radius=1,2"}).order, ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(of({"bodies[1].hydro.added_mass=none,deep", density}).order,
              ElementsAre(0, 3, 1, 2, 4, 5));
}

TEST_F(Survey, HasTheBodiesOfAllRuns) {
  EXPECT_THAT(of({"bodies[b].name=b,c"}).bodies, ElementsAre("a", "b", "c"));
}

TEST_F(Survey, RefusesAValueThatIsWrongInAllRunsButNoCombination) {
  EXPECT_NO_THROW(of({"gravity=9.8,0", "bodies[0].start=given,equilibrium"}));
  EXPECT_THROW(of({"gravity=9.8,0", "bodies[0].start=given,floating"}), scene::InputError);
}

TEST(SlurmScript, QuotesWhatAShellWouldTakeApart) {
  EXPECT_EQ(app::shell_words({"a", "b c", "d'e", "", "f[0]=1"}), R"(a 'b c' 'd'\''e' '' 'f[0]=1')");
}

TEST(SlurmScript, HasATaskARunAndSoManyAtATime) {
  app::SweepOptions options = {.scene = "a b.yaml", .out = "o", .sets = {}, .varied = {"k=1,2"}};
  options.samples = 5;
  EXPECT_THAT(app::slurm_script(options, 5), HasSubstr("\n#SBATCH --array=0-4\n"));
  EXPECT_THAT(app::slurm_script(options, 5), HasSubstr("\n#SBATCH --job-name=a_b\n"));
  options.jobs = 3;
  const std::string script = app::slurm_script(options, 5);
  EXPECT_THAT(script, HasSubstr("\n#SBATCH --array=0-4%3\n"));
  EXPECT_THAT(script,
              HasSubstr(" sweep 'a b.yaml' --vary 'k=1,2' --samples 5 --seed 1 --out o)\n"));
}

TEST(Ranks, AreReadFromTheLaunchersVariables) {
  EXPECT_FALSE(app::launched_rank());
  ::setenv("SLURM_PROCID", "0", 1);
  ::setenv("SLURM_NTASKS", "4", 1);  // as in a batch script, which runs once
  EXPECT_FALSE(app::launched_rank());
  ::setenv("SLURM_STEP_NUM_TASKS", "1", 1);
  EXPECT_FALSE(app::launched_rank());
  ::setenv("SLURM_STEP_NUM_TASKS", "4", 1);
  EXPECT_EQ(app::launched_rank()->size, 4u);
  ::setenv("OMPI_COMM_WORLD_RANK", "2", 1);
  ::setenv("OMPI_COMM_WORLD_SIZE", "3", 1);
  EXPECT_EQ(app::launched_rank()->number, 2u);
  EXPECT_EQ(app::launched_rank()->size, 3u);
  for (const char* name : {"SLURM_PROCID", "SLURM_NTASKS", "SLURM_STEP_NUM_TASKS",
                           "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"})
    ::unsetenv(name);
}

TEST(FileLock, OneAtATimeHasItAndItsFileGoes) {
  const std::string folder = "plimsoll_lock_" + std::to_string(::getpid());
  const fs::path file = fs::path(testing::TempDir()) / folder / "a.lock";
  constexpr int kTimes = 200;
  int count = 0;  // no atomic: the lock guards it
  const auto work = [&] {
    for (int i = 0; i < kTimes; ++i) {
      const app::FileLock lock(file);
      const int before = count;
      std::this_thread::yield();
      count = before + 1;
    }
  };
  std::thread other(work);
  work();
  other.join();
  EXPECT_EQ(count, 2 * kTimes);
  EXPECT_FALSE(fs::exists(file));
  fs::remove_all(file.parent_path());
}

TEST(FileLock, LetsAllPassWhereNoFileCanBe) {
  const app::FileLock none("");
  const app::FileLock first("/proc/no/such/lock");
  const app::FileLock second("/proc/no/such/lock");
  EXPECT_FALSE(second.waited());
}

}  // namespace

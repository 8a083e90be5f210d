#include "tests/stress/watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/stress/matrix.h"
#include "tests/stress/outcome.h"
#include "tests/stress/pool.h"
#include "tests/stress/results.h"

namespace {

using stress::Key;
using stress::Outcome;
using stress::RunName;
using stress::Scenario;
using stress::Watch;
using testing::HasSubstr;

/// Returns the fault that the watch finds within the run's steps; empty if none.
std::string fault_of(const Scenario& watched, const engine::SimulationSpec& simulated) {
  Watch watch(watched);
  engine::Simulation simulation(simulated);
  for (long i = 0; i < watched.steps; ++i) {
    try {
      simulation.step();
    } catch (const engine::SimulationError& error) {
      return error.what();
    }
    if (const auto fault = watch.look(simulation)) return *fault;
  }
  return "";
}

Scenario floating_cube() {
  return stress::make_scenario(stress::parse_run("speed=1 added=none steps=60"));
}

TEST(StressWatch, FindsNothingInAFallIntoTheWater) {
  const Scenario scenario = floating_cube();
  ASSERT_TRUE(scenario.passive);
  EXPECT_EQ(fault_of(scenario, scenario.spec), "");
}

TEST(StressWatch, SeesThatThePlainMethodGainsEnergyFromStiffDrag) {
  Scenario scenario = stress::make_scenario(
      stress::parse_run("density=0.01 speed=30 coefs=x100 step=1/20 start=deep added=none"));
  scenario.spec.integrator.method = engine::Integrator::Method::ode;
  EXPECT_NE(fault_of(scenario, scenario.spec), "");
}

TEST(StressWatch, SeesAHiddenForceByTheEnergyItGives) {
  const Scenario scenario = floating_cube();
  engine::SimulationSpec pushed = scenario.spec;
  const double weight = pushed.bodies[0].mass * pushed.gravity;
  pushed.bodies[0].loads.push_back({.force = {0.2 * weight, 0, 0}, .start = 0.5});
  EXPECT_THAT(fault_of(scenario, pushed), HasSubstr("energy rose"));
}

/// The spring that is watched has its ends at rest; the one that pulls is a tenth shorter.
TEST(StressWatch, SeesALineThatGivesWhatItHasNotTaken) {
  const Scenario scenario =
      stress::make_scenario(stress::parse_run("with=spring coefs=none added=none start=deep"));
  EXPECT_EQ(fault_of(scenario, scenario.spec), "");
  engine::SimulationSpec tightened = scenario.spec;
  tightened.lines[0].length *= 0.9;
  EXPECT_THAT(fault_of(scenario, tightened), HasSubstr("energy rose"));
}

TEST(StressWatch, SeesABodyThatGoesFartherThanItsEnergyCarriesIt) {
  Scenario scenario = floating_cube();
  scenario.passive = false;
  scenario.steps = 600;
  engine::SimulationSpec pushed = scenario.spec;
  const double weight = pushed.bodies[0].mass * pushed.gravity;
  pushed.bodies[0].loads.push_back({.force = {30 * weight, 0, 0}});
  EXPECT_THAT(fault_of(scenario, pushed), HasSubstr("got"));
  pushed.bodies[0].loads.back().force = {0, 0, 30 * weight};
  EXPECT_THAT(fault_of(scenario, pushed), HasSubstr("rose"));
}

/// A cube that floats, and is pushed by a force that the watch does not know from 0.5 s on.
Scenario pushed_cube(const std::string& more, double weights) {
  Scenario scenario =
      stress::make_scenario(stress::parse_run("speed=1 added=none steps=60 " + more));
  const double weight = scenario.spec.bodies[0].mass * scenario.spec.gravity;
  scenario.spec.bodies[0].loads.push_back({.force = {weights * weight, 0, 0}, .start = 0.5});
  return scenario;
}

TEST(StressWatch, JudgesNoEnergyOutsideTheEnvelope) {
  EXPECT_THAT(stress::run_through(pushed_cube("", 0.2)).fault, HasSubstr("energy rose"));
  const Outcome outside = stress::run_through(pushed_cube("size=0.004", 0.2));
  EXPECT_EQ(outside.fault, "");
  EXPECT_FALSE(outside.inside);
  EXPECT_FALSE(outside.judged);
  EXPECT_FALSE(outside.stopped);
}

TEST(StressWatch, TakesAWordOfTheEngineAsAStopOutsideTheEnvelopeAlone) {
  EXPECT_NE(stress::run_through(pushed_cube("", 1e12)).fault, "");
  const Outcome outside = stress::run_through(pushed_cube("size=0.004", 1e12));
  EXPECT_EQ(outside.fault, "");
  EXPECT_TRUE(outside.stopped);
}

TEST(StressRuns, AreRepeatedByTheirName) {
  for (const RunName& run : stress::whole_matrix()) {
    ASSERT_EQ(stress::parse_run(run.text()), run) << run.text();
  }
}

TEST(StressRuns, AreAllDifferentAndSomeThousands) {
  std::set<std::string> names;
  for (const RunName& run : stress::whole_matrix())
    EXPECT_TRUE(names.insert(run.text()).second) << run.text();
  EXPECT_GE(names.size(), 2000U);
  const std::vector<RunName> some = stress::subset();
  EXPECT_GE(some.size(), 180U);
  EXPECT_LE(some.size(), 260U);
  for (const RunName& run : some) EXPECT_TRUE(names.contains(run.text())) << run.text();
}

TEST(StressRuns, HaveEveryValueOfEveryParameterInTheSubset) {
  const std::vector<RunName> runs = stress::subset();
  for (const stress::Dimension& dimension : stress::dimensions())
    for (const std::string& value : dimension.values)
      EXPECT_TRUE(std::any_of(runs.begin(), runs.end(),
                              [&](const RunName& run) { return run[dimension.key] == value; }))
          << dimension.name << '=' << value;
}

TEST(StressRuns, RefuseNamesThatMeanNothing) {
  EXPECT_THROW(stress::parse_run("colour=red"), std::invalid_argument);
  EXPECT_THROW(stress::parse_run("size"), std::invalid_argument);
  EXPECT_THROW(stress::parse_run("size=big").number(Key::size), std::invalid_argument);
  for (const char* text : {"shape=pig", "water=dry", "with=friends", "coefs=x7", "added=much",
                           "entry=up", "start=here", "pose=proud"})
    EXPECT_NE(stress::run_through(stress::parse_run(text)).fault, "") << text;
}

TEST(StressOutcome, ComesBackFromALine) {
  const Outcome outcome{.fault = "step 7: it fell, and so on",
                        .steps = 7,
                        .inside = true,
                        .judged = true,
                        .stopped = true,
                        .rise = 1.25e-3,
                        .substeps = 64,
                        .sweeps = 12,
                        .unconverged = 2,
                        .clamped = 1,
                        .seconds = 0.5,
                        .digest = 0xfedcba9876543210};
  const Outcome back = stress::outcome_from_csv(stress::to_csv(outcome));
  EXPECT_EQ(stress::to_csv(back), stress::to_csv(outcome));
  EXPECT_EQ(back.fault, "step 7: it fell; and so on");
}

TEST(StressPool, DoesEveryRunOnceInProcessesOfTheirOwn) {
  std::vector<RunName> runs;
  for (const char* steps : {"1", "2", "3", "4", "5"})
    runs.push_back(RunName().with(Key::added, "none").with(Key::steps, steps));
  std::set<long> done;
  stress::do_all(runs, 2, [&](const RunName& run, const Outcome& outcome) {
    EXPECT_EQ(outcome.fault, "");
    EXPECT_EQ(static_cast<double>(outcome.steps), run.number(Key::steps));
    done.insert(outcome.steps);
  });
  EXPECT_EQ(done.size(), runs.size());
}

TEST(StressResults, RunsInsideAndOutsideTheEnvelopeAreCountedApart) {
  const RunName run;
  const Outcome in{.inside = true}, in_failed{.fault = "it fell", .inside = true};
  const Outcome out, out_stopped{.stopped = true};
  EXPECT_EQ(
      stress::envelope_line({{run, in}, {run, in_failed}, {run, out}, {run, out_stopped}}),
      "inside the operating envelope: 2 runs, 1 failed; outside: 2 runs, 0 failed, 1 stopped");
}

TEST(StressRuns, AreMostlyInsideTheEnvelope) {
  long inside = 0, runs = 0;
  for (const RunName& run : stress::subset()) {
    // The others take seconds to solve for, and matter here for their numbers alone.
    const std::string& added = run[Key::added];
    if (added == "waves" || added == "deep" || added == "simulated") continue;
    ++runs;
    inside += stress::make_scenario(run).inside;
  }
  EXPECT_GE(inside, 0.6 * static_cast<double>(runs));
}

TEST(StressResults, AFailureComesWithTheCommandThatRepeatsIt) {
  const RunName run = stress::parse_run("shape=plate");
  Outcome outcome;
  EXPECT_EQ(stress::failures({{run, outcome}}, "program"), "");
  outcome.fault = "step 1: bad";
  EXPECT_THAT(stress::failures({{run, outcome}}, "program"),
              HasSubstr("program --run '" + run.text() + "'"));
}

}  // namespace

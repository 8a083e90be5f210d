#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/app/program/program.h"

/// `plimsoll analyse`, of logs whose numbers are known and of a run.

namespace {

using nlohmann::json;
using std::numbers::pi;
using support::Outcome;
using support::Workplace;
using testing::HasSubstr;
using testing::StartsWith;

class ProgramAnalysis : public testing::Test {
 protected:
  /// Writes a run of one body that heaves.
  template <class Heave>
  void write_heave(int rows, double interval, const Heave& heave) const {
    std::filesystem::create_directories(here / "run");
    std::string text = support::kTrajectoryHeader;
    for (int i = 0; i < rows; ++i) {
      const double t = i * interval;
      text +=
          std::to_string(t) + ",buoy,0,0," + std::to_string(heave(t)) + ",1,0,0,0,0,0,0,0,0,0\n";
    }
    here.write("run/trajectory.csv", text);
  }

  /// The analysis of a motion in what --json prints.
  static json signal(const std::string& out, const std::string& name) {
    const json all = json::parse(out);
    for (const json& one : all["signals"])
      if (one["signal"] == name) return one;
    return nullptr;
  }

  /// Expects a response of the body to be this at all frequencies where the wave has energy.
  static void expect_response(const json& response, double amplitude, double phase_deg,
                              double tolerance) {
    const std::vector<double> wave = response["wave_density"];
    const double most = *std::ranges::max_element(wave);
    int seen = 0;
    for (std::size_t k = 0; k < wave.size(); ++k) {
      if (wave[k] < 0.3 * most) continue;
      ++seen;
      EXPECT_NEAR(response["amplitude"][k].get<double>(), amplitude, tolerance * amplitude);
      EXPECT_NEAR(response["phase_deg"][k].get<double>(), phase_deg, tolerance * 180 / pi);
      EXPECT_GT(response["coherence"][k].get<double>(), 0.98);
    }
    EXPECT_GT(seen, 2);
  }

  Workplace here;
};

TEST_F(ProgramAnalysis, FitsADecay) {
  write_heave(800, 0.05,
              [](double t) { return 0.5 + std::exp(-0.05 * t) * std::cos(2 * pi * t / 4); });
  const Outcome outcome = here.run({"analyse", "run"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("run: 800 rows from 0 to 39.95 s\n"));
  EXPECT_THAT(outcome.out, HasSubstr("decay of buoy heave to 0.4996 m: period 3.999 s, linear "
                                     "damping 3.18 % of the critical (p1 0.1 1/s)"));
  const json heave = signal(here.run({"analyse", "run/trajectory.csv", "--json"}).out, "heave");
  EXPECT_NEAR(heave["decay"]["linear"].get<double>(), 0.1, 1e-3);
  EXPECT_NEAR(heave["decay"]["cycles"][2]["decrement"].get<double>(), 0.2, 1e-3);
  EXPECT_NEAR(heave["spectrum"]["peak_period"].get<double>(), 4, 0.5);  // Segments are short.
}

TEST_F(ProgramAnalysis, TakesTheRowsOfAWindow) {
  write_heave(100, 0.1, [](double t) { return t; });
  const json heave =
      signal(here.run({"analyse", "run", "--from", "2", "--to", "4", "--json"}).out, "heave");
  EXPECT_EQ(heave["rows"], 21);
  EXPECT_NEAR(heave["statistics"]["mean"].get<double>(), 3, 1e-9);
  EXPECT_NEAR(heave["statistics"]["drift"].get<double>(), 1, 1e-9);
  EXPECT_EQ(heave["statistics"]["max"], 4);
}

TEST_F(ProgramAnalysis, GivesTheResponseToTheWaveAtAProbe) {
  // A wave of many frequencies; the body heaves by 1.5 of it, a quarter period ahead.
  const auto sum = [](double t, double lead) {
    double z = 0;
    for (int k = 0; k < 60; ++k)
      z += 0.05 * std::cos(2 * pi * (0.08 + 0.002 * k) * t + 2.4 * k * k + lead);
    return z;
  };
  write_heave(4000, 0.25, [&](double t) { return 1.5 * sum(t, pi / 2); });
  std::string probes = "time,probe,elevation,x,y,z,vx,vy,vz,ax,ay,az\n";
  for (int i = 0; i < 4000; ++i)
    probes +=
        std::to_string(i * 0.25) + ",gauge," + std::to_string(sum(i * 0.25, 0)) + ",0,0,0,,,,,,\n";
  here.write("run/probes.csv", probes);
  const Outcome outcome = here.run({"analyse", "run", "--wave", "gauge", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  expect_response(signal(outcome.out, "heave")["response"], 1.5, 90, 0.05);
  EXPECT_THAT(here.run({"analyse", "run", "--wave", "gage"}).err,
              StartsWith("--wave: there is no probe gage; did you mean gauge?"));
  EXPECT_THAT(here.run({"analyse", "run", "--wave", "gauge"}).out,
              HasSubstr("buoy: response to the wave at gauge, with phase lead"));
}

TEST_F(ProgramAnalysis, OfASmallRaftInAnIrregularSeaIsTheWaveItself) {
  here.write(
      "raft.yaml",
      "plimsoll: 1\nduration: 400\nstep: 0.1\nwater: {surface: {spectrum: {type: jonswap, "
      "significant_height: 1, peak_period: 9, seed: 2, heading_deg: 0, components: 80}}}\n"
      "hydro: {added_mass: none, radiation: none}\n"
      "bodies: [{name: raft, box: {size: [0.4, 0.4, 0.2]}, density: 500, position: [5, 0, 0]}]\n"
      "log: {every: 0.5}\n");
  const Outcome run = here.run({"run", "raft.yaml", "--quiet", "--out", "run"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Outcome outcome = here.run({"analyse", "run", "--json"});
  EXPECT_EQ(json::parse(outcome.out)["wave"], "the wave at its mean place");
  expect_response(signal(outcome.out, "heave")["response"], 1, 0, 0.05);
}

TEST_F(ProgramAnalysis, WrongInputIsCodeTwo) {
  write_heave(100, 0.1, [](double t) { return std::sin(t); });
  for (const std::string options :
       {"--from 5 --to 4", "--from 50", "--segment 0.1", "--segment 1000", "--wave gauge"})
    EXPECT_EQ(here.shell("$PLIMSOLL analyse run " + options).code, 2) << options;
  EXPECT_THAT(here.run({"analyse", "run", "--from", "50"}).err,
              StartsWith("run: has no rows of body buoy in that time, expected two or more"));
  EXPECT_EQ(here.run({"analyse", "none"}).code, 2);
}

}  // namespace

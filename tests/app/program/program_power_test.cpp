#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/program/program.h"

/// The power of the drives of joints, in summary.json and in the table of a sweep.

namespace {

using nlohmann::json;
using support::Outcome;
using support::Workplace;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kMass = 1000, kDamping = 1500, kForce = 2000;
constexpr double kOmega = 2 * M_PI / 4;  ///< Of the period of 4 s [rad/s].
constexpr int kPeriods = 5;
/// Amplitude of the steady velocity of m v' + c v = F sin ωt [m/s].
const double kSpeed = kForce / std::hypot(kDamping, kMass* kOmega);
/// ½ c (ωX)² [W]
const double kPower = 0.5 * kDamping * kSpeed * kSpeed;
/// Errors of second order in ωh for h = 0.01 s.
const double kSecondOrder = std::pow(kOmega * 0.01, 2);

/// A float on a slider in weightless space that starts on its steady orbit v = V sin(ωt − φ).
std::string floater(double step, const std::string& more) {
  const double phase = std::atan2(kMass * kOmega, kDamping);
  std::ostringstream text;
  text.precision(17);
  text << "plimsoll: 1\nduration: " << 4 * kPeriods << "\nstep: " << step
       << "\ngravity: 0\nlog: {forces: true}\nbodies:\n"
       << "  - name: float\n    box: {size: [1, 1, 1]}\n    mass: " << kMass
       << "\n    linear_velocity: [0, 0, " << -kSpeed * std::sin(phase) << "]\n";
  return text.str() + more;
}

class ProgramPower : public testing::Test {
 protected:
  json joint(const std::string& text) const {
    here.write("wec.yaml", text);
    const Outcome outcome = here.run({"run", "wec.yaml", "--out", "o"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(here.read("o/summary.json"))["joints"]["pto"];
  }

  /// Energy that what acts along the joint absorbs, by its log [J].
  double logged_energy() const {
    std::istringstream rows(here.read("o/joints.csv"));
    std::string line;
    std::getline(rows, line);
    double energy = 0, before = 0, power_before = 0;
    for (bool first = true; std::getline(rows, line); first = false) {
      std::vector<std::string> cells;
      std::istringstream stream(line);
      for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
      const double time = std::stod(cells[0]), power = -std::stod(cells[3]) * std::stod(cells[10]);
      if (!first) energy += (time - before) * (power + power_before) / 2;
      before = time;
      power_before = power;
    }
    return energy;
  }

  Workplace here;
};

// A damper lags by half a step, a load being that of the velocity before it: an error of first
// order, which the difference of two steps takes away.
double without_lag(double of_step, double of_half_a_step) { return 2 * of_half_a_step - of_step; }

TEST_F(ProgramPower, OfALinearDamperThatASinusoidalForceDrivesIsThatOfTheClosedForm) {
  const std::string rest =
      "    forces: [{force: [0, 0, 2000], sine: {frequency_hz: 0.25}}]\n"
      "joints:\n  - {name: pto, type: slider, bodies: [world, float], axis: [0, 0, 1],\n"
      "     damping: 1500}\n";
  const json coarse = joint(floater(0.01, rest)), fine = joint(floater(0.005, rest));
  const std::vector<std::pair<std::string, double>> expected = {
      {"power_mean", kPower},
      {"power_max", 2 * kPower},
      {"effort_rms", kDamping * kSpeed / std::sqrt(2)},
      {"effort_max", kDamping * kSpeed},
      {"stroke", 2 * kSpeed / kOmega}};
  for (const auto& [key, value] : expected) {
    EXPECT_NEAR(without_lag(coarse[key], fine[key]) / value, 1, kSecondOrder) << key;
    EXPECT_NEAR(fine[key].get<double>() / value, 1, 0.005) << key;  // c h/(2 m) of the mass, 0.4 %
  }
  EXPECT_EQ(fine["damper"]["power_mean"], fine["power_mean"]);
  EXPECT_FALSE(fine.contains("motor"));
  EXPECT_FALSE(fine.contains("spring"));
  EXPECT_LT(fine["position_error_max"].get<double>(), 1e-9) << "what it had before is still there";
  EXPECT_NEAR(logged_energy() / (fine["power_mean"].get<double>() * 4 * kPeriods), 1, 1e-9);
}

TEST_F(ProgramPower, OfAMotorThatDrivesIsWhatTheDamperTakes) {
  const json pto = joint(
      floater(0.005,
              "joints:\n  - {name: pto, type: slider, bodies: [world, float], axis: [0, 0, 1],\n"
              "     damping: 1500, motor: {force: 0}}\n"
              "controls:\n  - {set: \"joints[pto].motor.force\","
              " formula: \"2000*sin(2*pi*t/4)\"}\n"));
  const double taken = pto["damper"]["power_mean"];
  EXPECT_NEAR(taken / kPower, 1, 0.005);
  EXPECT_NEAR(pto["motor"]["power_mean"].get<double>() / taken, -1, kSecondOrder);
  EXPECT_NEAR(pto["power_mean"].get<double>() / taken, 0, kSecondOrder);
  EXPECT_NEAR(pto["motor"]["effort_rms"].get<double>() / (kForce / std::sqrt(2)), 1, kSecondOrder);
  EXPECT_NEAR(pto["motor"]["effort_max"].get<double>() / kForce, 1, kSecondOrder);
}

TEST_F(ProgramPower, OfAMotorThatHoldsASpeedAgainstADamperIsWhatTheDamperTakes) {
  // Found with the forces of joints, where the motor's effort is a part of the solver's.
  here.write("wec.yaml",
             "plimsoll: 1\nduration: 2\nstep: 0.01\ngravity: 0\nbodies:\n"
             "  - {name: float, box: {size: [1, 1, 1]}, mass: 1000, linear_velocity: [0, 0, 0.5]}\n"
             "joints:\n  - {name: pto, type: slider, bodies: [world, float], axis: [0, 0, 1],\n"
             "     damping: 1500, motor: {speed: 0.5}}\n");
  ASSERT_EQ(here.run({"run", "wec.yaml", "--out", "o"}).code, 0);
  const json pto = json::parse(here.read("o/summary.json"))["joints"]["pto"];
  EXPECT_NEAR(pto["damper"]["power_mean"].get<double>(), 1500 * 0.25, 1e-3);
  EXPECT_NEAR(pto["motor"]["power_mean"].get<double>(), -1500 * 0.25, 1e-3);
  EXPECT_NEAR(pto["stroke"].get<double>(), 1, 1e-6);
}

TEST_F(ProgramPower, StandsInTheTableOfASweepOfSeaStates) {
  here.write("wec.yaml",
             "plimsoll: 1\nduration: 4\nstep: 0.05\n"
             "water: {surface: {spectrum: {type: jonswap, significant_height: 1, peak_period: 5,\n"
             "  components: 20}}}\nhydro: {added_mass: none, radiation: none}\nbodies:\n"
             "  - {name: float, box: {size: [4, 4, 2]}, mass: 16000}\n"
             "joints:\n  - {name: pto, type: slider, bodies: [world, float], axis: [0, 0, 1],\n"
             "     damping: 1e4}\n");
  const Outcome outcome = here.run({"sweep", "wec.yaml", "--out", "matrix", "-j", "1", "--vary",
                                    "water.surface.spectrum.significant_height=1,2", "--vary",
                                    "water.surface.spectrum.peak_period=5,7"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream rows(here.read("matrix/sweep.csv"));
  std::string header, row;
  std::getline(rows, header);
  EXPECT_THAT(header, StartsWith("run,water.surface.spectrum.significant_height,"));
  EXPECT_THAT(header, testing::EndsWith(",message,joints.pto.stroke,joints.pto.power_mean,"
                                        "joints.pto.power_max,joints.pto.effort_rms,"
                                        "joints.pto.effort_max"));
  int count = 0;
  for (; std::getline(rows, row); ++count) {
    const json summary =
        json::parse(here.read("matrix/runs/" + row.substr(0, 4) + "/summary.json"));
    EXPECT_THAT(row, HasSubstr(',' + summary["joints"]["pto"]["power_mean"].dump() + ','));
    EXPECT_GT(summary["joints"]["pto"]["power_mean"], 0);
  }
  EXPECT_EQ(count, 4);
}

}  // namespace

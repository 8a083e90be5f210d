#include <filesystem>
#include <fstream>
#include <numbers>

#include "engine/rig/moordyn/moordyn_system.h"
#include "hydro/lines/catenary.h"
#include "tests/engine/prelude.h"
#include "tests/support/files.h"

/// Lines by MoorDyn against catenaries, and on bodies. Skipped in a build without MoorDyn.

namespace {

namespace fs = std::filesystem;
using engine::LineReading;
using engine::LineSpec;
using engine::MoorDynFault;
using engine::MoorDynSpec;
using engine::MoorDynSystem;
using engine::SimulationError;
using engine::SimulationState;

constexpr double kWater = 1025;     // [kg/m^3]
constexpr double kDepth = 50;       // [m]
constexpr double kDiameter = 0.05;  // Of the chain [m].
constexpr double kChain = 60;       // [kg/m]
constexpr double kStiffness = 1e7;  // EA [N]

/// Of the chain in water [N/m].
double weight() {
  return kGravity * (kChain - kWater * std::numbers::pi / 4 * kDiameter * kDiameter);
}

/// A file of one chain from an anchor to a point that moves.
std::string chain_file(const Vector3d& anchor, const Vector3d& fairlead, double length,
                       int segments, const std::string& options = "") {
  std::ostringstream text;
  text << "--- LINE TYPES ---\n"
          "Name Diam Mass EA BA EI Cd Ca CdAx CaAx\n"
          "(-) (m) (kg/m) (N) (N-s) (N-m2) (-) (-) (-) (-)\n"
       << "chain " << kDiameter << ' ' << kChain << ' ' << kStiffness
       << " -0.8 0 1.2 1.0 0.05 0\n"
          "--- POINTS ---\n"
          "ID Type X Y Z M V CdA Ca\n"
          "(-) (-) (m) (m) (m) (kg) (m3) (m2) (-)\n"
       << "1 Fixed " << anchor.transpose() << " 0 0 0 0\n"
       << "2 Coupled " << fairlead.transpose()
       << " 0 0 0 0\n"
          "--- LINES ---\n"
          "ID Type A B Length Segments Outputs\n"
          "(-) (-) (-) (-) (m) (-) (-)\n"
       << "1 chain 1 2 " << length << ' ' << segments
       << " -\n"
          "--- OPTIONS ---\n"
          "0.02 cfl\n"
       << options;
  return text.str();
}

hydro::Sea still_water(double level = 0) {
  return {.density = kWater, .gravity = kGravity, .level = level, .depth = kDepth};
}

class MoorDynLines : public testing::Test {
 protected:
  void SetUp() override {
    if (!engine::why_no_moordyn().empty()) GTEST_SKIP() << engine::why_no_moordyn();
  }
};
class MoorDynMotion : public MoorDynLines {};

/// The line at rest between an anchor and a fairlead.
LineReading at_rest(const Vector3d& anchor, const Vector3d& fairlead, double length, int segments,
                    double level) {
  const hydro::Sea sea = still_water(level);
  MoorDynSystem system("chain.txt",
                       chain_file(anchor - Vector3d(0, 0, level), {0, 0, 0}, length, segments),
                       {.gravity = kGravity, .sea = &sea});
  system.start({fairlead});
  return system.readings().at(0);
}

TEST_F(MoorDynLines, HangAsCatenariesDo) {
  const Vector3d anchor{-40, 30, 7}, fairlead{0, 0, -1};  // 50 m apart; nothing rests
  const hydro::CatenarySolution exact = hydro::solve_catenary(
      {.length = 58, .weight = weight(), .stiffness = kStiffness}, 50, -8, false);
  for (const auto& [segments, error] : {std::pair(10, 1e-2), std::pair(40, 2e-3)}) {
    const LineReading line = at_rest(anchor, fairlead, 58, segments, 20);
    EXPECT_NEAR(line.tension / exact.tension(), 1, tolerance(error)) << segments;
    EXPECT_NEAR(line.force_W.head<2>().norm() / exact.horizontal, 1, tolerance(error)) << segments;
    EXPECT_GT(line.force_W.head<2>().normalized().dot(Eigen::Vector2d(-0.8, 0.6)), 1 - 1e-6);
    EXPECT_NEAR(-line.force_W.z() / exact.vertical, 1, tolerance(error)) << segments;
    EXPECT_LT((line.first_W - fairlead).norm(), tolerance(1e-9));
    EXPECT_LT((line.second_W - anchor).norm(), tolerance(1e-9));
    EXPECT_EQ(line.length, 58);
  }
}

TEST_F(MoorDynLines, RestOnTheBottomAsCatenariesDo) {
  const Vector3d anchor{-100, 0, -kDepth}, fairlead{0, 0, -1};
  const hydro::CatenarySolution exact = hydro::solve_catenary(
      {.length = 130, .weight = weight(), .stiffness = kStiffness}, 100, kDepth - 1, true);
  ASSERT_GT(exact.resting, 20);
  const LineReading line = at_rest(anchor, fairlead, 130, 65, 0);
  EXPECT_NEAR(line.tension / exact.tension(), 1, tolerance(5e-3));
  EXPECT_NEAR(line.force_W.x() / exact.horizontal, -1, tolerance(5e-3));
}

TEST_F(MoorDynLines, LeaveNoFilesAndSayNothing) {
  const fs::path before = fs::current_path(), here = fs::path(testing::TempDir()) / "moordyn_files";
  fs::create_directories(here);
  fs::current_path(here);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const hydro::Sea sea = still_water();
  {
    MoorDynSystem system(
        here / "chain.txt",
        chain_file({-60, 0, -kDepth}, {0, 0, 0}, 90, 5, "2 writeLog\n0 disableOutput\n"),
        {.gravity = kGravity, .sea = &sea});
    system.start({Vector3d::Zero()});
    system.step({{}}, {{.place = {0.1, 0, 0}}}, 0, 0.1);
    EXPECT_THROW(MoorDynSystem("wrong.txt", "--- LINES ---\n", {.gravity = kGravity}),
                 MoorDynFault);
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(support::files_in(here).empty());
  fs::current_path(before);
}

TEST_F(MoorDynLines, ThatCannotBeReadAreRefusedInMoorDynsWords) {
  const auto fault_of = [](const std::string& text) -> std::string {
    try {
      MoorDynSystem system("lines.txt", text, {.gravity = kGravity});
    } catch (const MoorDynFault& fault) {
      return fault.what();
    }
    return "";
  };
  std::string text = chain_file({-60, 0, -kDepth}, {0, 0, 0}, 90, 5);
  EXPECT_EQ(fault_of(text), "");
  text.replace(text.find("1 chain 1 2"), 7, "1 cable");
  EXPECT_NE(fault_of(text).find("cable"), std::string::npos) << fault_of(text);
  EXPECT_EQ(fault_of(chain_file({}, {}, 90, 5, "--- FAILURE ---\n")),
            "it has a section of failures, which is not supported");
  text = chain_file({}, {}, 90, 5);
  text.replace(text.find("Coupled"), 7, "Free");
  EXPECT_EQ(fault_of(text), "it has no coupled point, expected one or more");
}

/// A buoy on one chain, by MoorDyn or by a catenary.
SimulationSpec moored(bool by_moordyn, double step, int segments = 40) {
  BodySpec buoy = support::sphere_body("buoy", 1.5, 400, {0, 0, 0.2});
  buoy.wet = true;
  SimulationSpec spec = support::dry_world({buoy}, step);
  spec.sea = still_water();
  const Vector3d anchor{-70, 0, -kDepth};
  constexpr double kLength = 95;
  if (by_moordyn) {
    spec.moordyn = MoorDynSpec{.file = "chain.txt",
                               .text = chain_file(anchor, {0, 0, -1.5}, kLength, segments),
                               .points = {{.body = 0, .at = {0, 0, -1.5}}},
                               .lines = {{.number = 1, .length = kLength}}};
  } else {
    spec.lines = {{.name = "chain",
                   .kind = LineSpec::Kind::mooring,
                   .first = {0, {0, 0, -1.5}},
                   .second = {kWorld, anchor},
                   .length = kLength,
                   .stiffness = kStiffness,
                   .weight = weight()}};
  }
  return spec;
}

LineReading line_of(const Simulation& simulation) {
  const engine::RigReadings readings = simulation.rig();
  return simulation.spec().moordyn ? readings.moordyn.at(0) : readings.lines.at(0);
}

/// Height of a heaving buoy and what its line does, means over 30 s.
struct MeanHeave {
  double height = 0, tension = 0, pull = 0;
};
MeanHeave mean_heave(bool by_moordyn) {
  SimulationSpec spec = moored(by_moordyn, 0.02);
  spec.bodies[0].locked = {true, true, false, true, true, true};
  spec.bodies[0].initial.position.z() = -0.4;
  Simulation simulation = support::after(std::move(spec), support::steps_in(70, 0.02));
  MeanHeave mean;
  constexpr int kSteps = 1500;
  for (int i = 0; i < kSteps; ++i) {
    simulation.step();
    mean.height += simulation.states()[0].position.z() / kSteps;
    mean.tension += line_of(simulation).tension / kSteps;
    mean.pull += line_of(simulation).force_W.x() / kSteps;
  }
  return mean;
}

TEST_F(MoorDynMotion, ABuoySinksAsDeepAsUnderACatenary) {
  // A heave of 1 cm is left, which the catenary does not damp.
  const MeanHeave by_moordyn = mean_heave(true), by_catenary = mean_heave(false);
  EXPECT_NEAR(by_moordyn.height, by_catenary.height, tolerance(1e-3));
  EXPECT_NEAR(by_moordyn.tension / by_catenary.tension, 1, tolerance(2e-3));
  EXPECT_NEAR(by_moordyn.pull / by_catenary.pull, 1, tolerance(2e-3));
}

TEST_F(MoorDynMotion, ALightBuoyOnAHeavyChainIsStable) {
  SimulationSpec spec = moored(true, 1.0 / 60, 10);
  spec.bodies[0].mass /= 20;  // 280 kg; h Z/m is 1.4
  spec.bodies[0].inertia_B /= 20;
  Simulation simulation(std::move(spec));
  for (int i = 0; i < 600; ++i) {
    simulation.step();
    ASSERT_LT(simulation.states()[0].linear_velocity.norm(), 6) << i;
  }
}

/// Place of the buoy two seconds after it was let fall and pulled aside.
Vector3d pulled(double step) {
  SimulationSpec spec = moored(true, step, 10);
  spec.bodies[0].loads = {{.force = {4e3, 2e3, 0}}};
  spec.moordyn->text += "0.000625 dtM\n";
  return support::after(std::move(spec), support::steps_in(2, step)).states()[0].position;
}

TEST_F(MoorDynMotion, IsOfSecondOrderInTheStep) {
  const Vector3d exact = pulled(0.00125);
  const double coarse = (pulled(0.04) - exact).norm(), fine = (pulled(0.01) - exact).norm();
  EXPECT_LT(coarse, tolerance(5e-3));
  EXPECT_LT(fine, coarse / 8);  // it is 16
}

TEST_F(MoorDynMotion, GoesOnFromASavedState) {
  SimulationSpec spec = moored(true, 0.02, 20);
  spec.bodies[0].initial.linear_velocity = {1, 0.5, 0};
  Simulation whole = support::after(spec, 60);
  const std::string bytes = whole.state().to_bytes();
  for (int i = 0; i < 60; ++i) whole.step();
  Simulation resumed(spec);
  resumed.restore(SimulationState::from_bytes(bytes));
  EXPECT_EQ(resumed.state().to_bytes(), bytes);
  for (int i = 0; i < 60; ++i) resumed.step();
  EXPECT_LT(distance(resumed.states()[0], whole.states()[0]), tolerance(1e-9));
  EXPECT_NEAR(line_of(resumed).tension / line_of(whole).tension, 1, tolerance(1e-9));
  resumed.reset();
  EXPECT_EQ(resumed.states()[0].position, spec.bodies[0].initial.position);
}

TEST_F(MoorDynMotion, StateOfOtherLinesIsRefused) {
  Simulation simulation(moored(true, 0.02, 10));
  EXPECT_THROW(simulation.restore(Simulation(moored(true, 0.02, 12)).state()),
               std::invalid_argument);
  EXPECT_THROW(simulation.restore(Simulation(moored(false, 0.02)).state()), std::invalid_argument);
}

TEST_F(MoorDynMotion, LinesFeelTheCurrentOfTheSceneIfTheirFileSaysSo) {
  const auto pull = [](const std::string& options) {
    SimulationSpec spec = moored(true, 0.02, 10);
    spec.sea->current = {0, 1.5, 0};
    spec.bodies[0].locked = {true, true, true, true, true, true};
    spec.moordyn->text += options;
    return line_of(support::after(std::move(spec), 500)).force_W;
  };
  EXPECT_NEAR(pull("").y(), 0, tolerance(1));
  EXPECT_GT(pull("1 WaveKin\n").y(), 1000);
}

TEST_F(MoorDynMotion, LinesThatLoseTheirStateStopTheSimulation) {
  SimulationSpec spec = moored(true, 0.02, 10);
  Simulation simulation(spec);
  simulation.step();
  BodyState far = simulation.states()[0];
  far.position.x() += 1e6;
  simulation.set_motion(0, far);
  EXPECT_THROW(for (int i = 0; i < 200; ++i) simulation.step(), SimulationError);
}

}  // namespace

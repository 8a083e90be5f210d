#include "app/pictures/rig_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "app/logs/rig_log.h"
#include "app/pictures/rigging.h"
#include "app/report/page_data.h"
#include "hydro/mesh/primitives.h"
#include "tests/app/program/page.h"
#include "tests/support/tolerance.h"

/// Lines and machines as their logs have them, and what a report's replay gets of them.

namespace {

namespace fs = std::filesystem;
using engine::LineSpec;

const double kLogRoundOff = support::tolerance(1e-12);

/// One body with a rope to the world, a propeller and a rudder, and two logged times.
class LoggedRig : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    engine::BodySpec body;
    body.name = "tug";
    body.mesh_B = hydro::make_box({2, 1, 1});
    run_.path = folder_;
    engine::SimulationSpec& spec = run_.built.spec;
    spec.bodies = {body};
    spec.set_points = {{.name = "speed", .initial = 2}, {.name = "azimuth"}, {.name = "angle"}};
    spec.lines = {{.name = "tow",
                   .kind = LineSpec::Kind::rope,
                   .first = {.body = 0, .at = {1, 0, 0}},
                   .second = {.body = engine::kWorld, .at = {5, 0, 0}},
                   .length = 6,
                   .stiffness = 1e4}};
    engine::PropellerSpec propeller;
    propeller.name = "main";
    propeller.azimuth = 1;
    propeller.right_handed = false;
    spec.propellers = {propeller};
    engine::FoilSpec rudder;
    rudder.name = "rudder";
    rudder.angle = 2;
    spec.foils = {rudder};
    run_.scene.bodies.resize(1);
    run_.scene.bodies[0].name = "tug";
    run_.trajectory.names = {"tug"};
    run_.trajectory.tracks["tug"] = {.times = {0, 0.5}, .states = {{}, {}}};
    run_.rows = 2;
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Writes the logs of a rope that shortens and breaks, and of machines that are set.
  void write_logs() {
    app::RigLog log(run_.built.spec, false);
    std::vector<app::TableWriter> writers;
    for (const app::LogTable& table : log.tables()) writers.emplace_back(folder_, table);
    for (const int row : {0, 1}) {
      engine::RigReadings readings;
      readings.lines = {{.tension = 100.0 + row, .length = 6.0 - row, .broken = row == 1}};
      readings.propellers = {{.speed = 1.0 + row, .azimuth = 0.1 * row}};
      readings.foils = {{.angle = 0.2 * row}};
      readings.set_points = {1.0 + row, 0.1 * row, 0.2 * row};
      const auto numbers = log.numbers(readings, {hydro::BodyState{}});
      for (std::size_t i = 0; i < writers.size(); ++i) writers[i].add(0.5 * row, numbers[i]);
    }
  }

  app::RigHistory history() const { return {run_.built.spec, folder_ / "trajectory.csv"}; }

  fs::path folder_ = fs::temp_directory_path() /
                     ("plimsoll_rig_" +
                      std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  app::LoggedRun run_;
};

TEST_F(LoggedRig, WithoutLogsIsAsAtRest) {
  const std::vector<hydro::BodyState> states(1);
  EXPECT_EQ(history().at(0.5, states), app::rig_at_rest(run_.built.spec, states, 0.5));
}

TEST_F(LoggedRig, IsAsItsLogsSay) {
  write_logs();
  const std::vector<hydro::BodyState> states(1);
  const app::DrawnRig first = history().at(0.4, states), second = history().at(0.5, states);
  EXPECT_EQ(first.lines[0], (app::DrawnLine{.tension = 100, .length = 6, .broken = false}));
  EXPECT_EQ(second.lines[0], (app::DrawnLine{.tension = 101, .length = 5, .broken = true}));
  EXPECT_EQ(first.propellers[0].turn, 0);
  // The shaft makes 1.5 turns a second on average over half a second.
  EXPECT_NEAR(second.propellers[0].turn, 1.5 * M_PI, kLogRoundOff);
  EXPECT_NEAR(second.propellers[0].azimuth, 0.1, kLogRoundOff);
  EXPECT_NEAR(second.foil_angles[0], 0.2, kLogRoundOff);
}

TEST_F(LoggedRig, IsInTheReport) {
  write_logs();
  const Eigen::Vector3d origin(10, 0, -1);
  const nlohmann::ordered_json page = app::page_rigging(run_, origin, {});
  ASSERT_EQ(page["lines"].size(), 1u);
  const auto& line = page["lines"][0];
  EXPECT_EQ(line["name"], "tow");
  EXPECT_EQ(line["ends"][0]["body"], 0);
  EXPECT_EQ(line["ends"][1]["body"], -1);
  EXPECT_EQ(line["ends"][1]["at"], (nlohmann::ordered_json{-5.0, 0.0, 1.0}));
  EXPECT_EQ(line["tension"]["base"], 100);
  EXPECT_EQ(support::packed_numbers<float>(line["broken"]["data"]), (std::vector<float>{0, 1}));
  EXPECT_EQ(page["tensions"]["top"], 120);
  // Of the rope, 6 m and then 5 m over 4 m, the middle hangs below the chord.
  const std::vector<float> shape = support::packed_numbers<float>(line["shape"]);
  const std::size_t inner = page["points"].get<std::size_t>() - 2;
  ASSERT_EQ(shape.size(), 2 * 3 * inner);
  const float early = shape[3 * (inner / 2) + 2], late = shape[3 * (inner + inner / 2) + 2];
  EXPECT_LT(early, late);
  EXPECT_LT(late, -1);
  // A propeller, a rudder and the end of the rope.
  ASSERT_EQ(page["parts"].size(), 3u);
  const auto& turns = page["parts"][0]["turns"];
  ASSERT_EQ(turns.size(), 2u);
  const std::vector<float> turn = support::packed_numbers<float>(turns[1]["angle"]["data"]);
  EXPECT_NEAR(turn.at(1), -1.5 * M_PI, 1e-5);  // The propeller is left-handed.
  EXPECT_EQ(page["parts"][1]["turns"].size(), 1u);
  EXPECT_EQ(page["parts"][2]["turns"].size(), 0u);
}

/// Three times of a mooring of two segments with inertia, which breaks at the last.
class LoggedLineWithInertia : public LoggedRig {
 protected:
  void SetUp() override {
    LoggedRig::SetUp();
    engine::SimulationSpec& spec = run_.built.spec;
    spec.lines.push_back({.name = "7",
                          .kind = LineSpec::Kind::mooring,
                          .first = {.body = 0, .at = {1, 0, 0}},
                          .second = {.body = engine::kWorld, .at = {8, 0, -5}},
                          .length = 9,
                          .stiffness = 1e6,
                          .inertia = engine::LineInertia{.segments = 2, .mass = 10},
                          .weight = 80});
    run_.trajectory.tracks["tug"] = {.times = {0, 0.5, 1}, .states = {{}, {}, {}}};
    run_.rows = 3;
    app::RigLog log(spec, false);
    std::vector<app::TableWriter> writers;
    for (const app::LogTable& table : log.tables()) writers.emplace_back(folder_, table);
    for (const int row : {0, 1, 2}) {
      engine::RigReadings readings;
      readings.lines.resize(1);
      if (row < 2)
        readings.lines.push_back({.tension = 1000.0 * (row + 1),
                                  .length = 9,
                                  .nodes_W = {{1, 0, 0}, {4, 0, -3.0 - row}, {8, 0, -5}}});
      else
        readings.lines.push_back({.length = 9, .broken = true});
      readings.propellers.resize(1);
      readings.foils.resize(1);
      readings.set_points = {0, 0, 0};
      const auto numbers = log.numbers(readings, {hydro::BodyState{}});
      ASSERT_EQ(numbers.size(), writers.size());
      for (std::size_t i = 0; i < writers.size(); ++i) writers[i].add(0.5 * row, numbers[i]);
    }
  }
};

TEST_F(LoggedLineWithInertia, HasItsNodesUntilItBreaks) {
  const std::vector<hydro::BodyState> states(1);
  const app::DrawnRig first = history().at(0.4, states), second = history().at(0.5, states);
  EXPECT_TRUE(first.lines[0].nodes_W.empty());
  EXPECT_EQ(first.lines[1],
            (app::DrawnLine{
                .tension = 1000, .length = 9, .nodes_W = {{1, 0, 0}, {4, 0, -3}, {8, 0, -5}}}));
  ASSERT_EQ(second.lines[1].nodes_W.size(), 3u);
  EXPECT_EQ(second.lines[1].nodes_W[1], Eigen::Vector3d(4, 0, -4));
  const app::DrawnRig half = app::between(first, second, 0.5);
  EXPECT_EQ(half.lines[1].nodes_W[1], Eigen::Vector3d(4, 0, -3.5));
  EXPECT_EQ(half.lines[1].tension, 1500);
  app::DrawnRig unknown = first;
  unknown.lines[1].nodes_W.clear();
  EXPECT_TRUE(app::between(unknown, second, 0.5).lines[1].nodes_W.empty());
  const app::DrawnRig last = history().at(1, states);
  EXPECT_EQ(last.lines[1], (app::DrawnLine{.length = 9, .broken = true}));
  EXPECT_EQ(app::between(second, last, 0.5).lines[1],
            (app::DrawnLine{.tension = 1000, .length = 9, .broken = true}));
}

TEST_F(LoggedLineWithInertia, IsDrawnAtRestWhereItsNodesWereNotLogged) {
  fs::remove(folder_ / app::line_nodes_layout().file);
  const std::vector<hydro::BodyState> states(1);
  const app::DrawnRig rig = history().at(0.5, states);
  EXPECT_EQ(rig.lines[1], (app::DrawnLine{.tension = 2000, .length = 9}));
  const app::GroundHeight ground(run_.built.spec.ground);
  EXPECT_GT(app::shape_of(run_.built.spec.lines[1], rig.lines[1], states, ground, 0).cols(), 3);
}

TEST_F(LoggedLineWithInertia, IsDrawnThroughItsNodesInTheColourOfItsTension) {
  app::RigPictures pictures(run_.built.spec, false);
  const app::Shot shot = {.states = std::vector<hydro::BodyState>(1),
                          .rig = history().at(0.5, std::vector<hydro::BodyState>(1))};
  EXPECT_TRUE(pictures.has_lines());
  pictures.include(shot);
  const render::Rigging rigging = pictures.of(shot);
  ASSERT_EQ(rigging.tubes.size(), 2u);  // The rope is the first.
  EXPECT_EQ(rigging.tubes[1].points_W.cols(), 3);
  EXPECT_EQ(rigging.tubes[1].points_W.col(1), Eigen::Vector3d(4, 0, -4));
  EXPECT_EQ(rigging.tubes[1].color, app::tension_color(1));
}

TEST_F(LoggedLineWithInertia, IsInTheReport) {
  const nlohmann::ordered_json page = app::page_rigging(run_, Eigen::Vector3d(0, 0, -1), {});
  ASSERT_EQ(page["lines"].size(), 2u);
  EXPECT_TRUE(page["lines"][0].contains("shape"));
  EXPECT_FALSE(page["lines"][0].contains("path"));
  const auto& line = page["lines"][1];
  EXPECT_EQ(line["name"], "7");
  EXPECT_FALSE(line.contains("shape"));
  const std::vector<float> path = support::packed_numbers<float>(line["path"]);
  const std::size_t points = page["points"].get<std::size_t>(), row = 3 * points;
  ASSERT_EQ(path.size(), 3 * row);
  EXPECT_EQ(path[2], 1);             // z of the first end above the origin
  EXPECT_EQ(path[2 * row - 1], -4);  // that of the second end, later
  for (std::size_t i = 0; i < row; ++i) EXPECT_EQ(path[2 * row + i], path[row + i]);
  EXPECT_EQ(support::packed_numbers<float>(line["broken"]["data"]), (std::vector<float>{0, 0, 1}));
  EXPECT_EQ(page["tensions"]["top"], 2000);
}

TEST_F(LoggedLineWithInertia, HasAShapeInTheReportWhereItsNodesWereNotLogged) {
  fs::remove(folder_ / app::line_nodes_layout().file);
  const nlohmann::ordered_json page = app::page_rigging(run_, Eigen::Vector3d::Zero(), {});
  EXPECT_FALSE(page["lines"][1].contains("path"));
  EXPECT_FALSE(page["lines"][1]["shape"].is_null());
}

TEST_F(LoggedRig, IsNotInTheReportOfARunThatHasNone) {
  run_.built.spec.lines.clear();
  run_.built.spec.propellers.clear();
  run_.built.spec.foils.clear();
  EXPECT_TRUE(app::page_rigging(run_, Eigen::Vector3d::Zero(), {}).is_null());
}

}  // namespace

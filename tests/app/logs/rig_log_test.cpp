#include "app/logs/rig_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "app/logs/hdf5_file.h"
#include "app/logs/make_log.h"
#include "app/logs/read_log.h"
#include "app/logs/run_files.h"
#include "app/run/rig_totals.h"
#include "app/scene/diagnostics.h"
#include "tests/support/files.h"

/// The tables of lines, joints, machines and controls, from readings that no engine has computed.

namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;

class RigLog : public testing::Test {
 protected:
  RigLog()
      : folder(fs::path(testing::TempDir()) /
               (std::string("plimsoll_rig_log_") +
                testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    describe();
    read();
  }
  ~RigLog() override { fs::remove_all(folder); }

  void describe() {
    spec.bodies = {{.name = "tug"}};
    spec.lines = {{.name = "tow", .kind = engine::LineSpec::Kind::rope},
                  {.name = "bow", .kind = engine::LineSpec::Kind::mooring}};
    spec.joints = {{.name = "crank", .type = engine::JointSpec::Type::hinge},
                   {.name = "ring", .type = engine::JointSpec::Type::ball}};
    spec.propellers.resize(1);
    spec.propellers[0].name = "main";
    spec.propellers[0].axis_B = Vector3d::UnitX();
    spec.propellers[0].pivot_B = Vector3d::UnitZ();
    spec.foils.resize(2);
    spec.foils[0].name = "aft";
    spec.foils[1].name = "lug";
    spec.foils[1].fluid = engine::FoilSpec::Fluid::air;
    spec.set_points = {{.name = "ropes[tow].length"}, {.name = "propellers[main].speed_rps"}};
    spec.controls = {{.set = 1}};
  }

  /// Numbers without a short decimal, so that a loss of digits shows.
  void read() {
    readings.lines = {{.tension = 1e4 / 3, .distance = 12.1, .length = 12, .taut = true},
                      {.tension = 7, .broken = true, .resting = 20.0 / 7}};
    readings.lines[0].first_W = {1, 2, 3};
    readings.lines[0].second_W = {4, 5, 6};
    readings.lines[0].force_W = {-0.0, 1.0 / 3, 9};
    readings.joints = {{.coordinate = 0.1, .speed = 0.2, .effort = 0.3}, {}};
    readings.joints[0].force_W = {1, 0, 0};
    readings.joints[1].moment_W = {0, 2, 0};
    readings.propellers = {{.speed = 3,
                            .azimuth = std::numbers::pi / 2,
                            .thrust = 100,
                            .torque = 5,
                            .advance = 0.4,
                            .wetted = 0.75}};
    readings.foils = {{.angle = 0.5, .attack = -0.25, .speed = 2}, {.speed = 8}};
    readings.set_points = {12, 3};
    states = {hydro::BodyState{}};
    states[0].orientation = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX());
  }

  /// Writes two times of the tables, in either format.
  void write(app::LogFormat format) {
    const app::RigLog log(spec, true);
    const app::LogSubject subject{.bodies = {"tug"}, .tables = log.tables()};
    const auto file = app::make_log(format, subject, folder);
    for (const double time : {0.0, 0.1})
      file->add({.time = time,
                 .states = states,
                 .forces = {},
                 .interiors = {},
                 .tables = log.numbers(readings, states)});
    file->finish();
  }

  std::string text_of(const std::string& name) const { return support::bytes_in(folder / name); }

  fs::path folder;
  engine::SimulationSpec spec;
  engine::RigReadings readings;
  std::vector<hydro::BodyState> states;
};

TEST_F(RigLog, HasTheTablesThatTheSimulationHasRowsFor) {
  EXPECT_EQ(app::RigLog(spec, true).tables().size(), 4u);
  EXPECT_EQ(app::RigLog(spec, false).tables().size(), 3u);
  const engine::SimulationSpec nothing;
  EXPECT_TRUE(app::RigLog(nothing, true).empty());
  EXPECT_TRUE(app::RigLog(nothing, true).tables().empty());
  EXPECT_FALSE(app::RigLog(spec, false).empty());
  const std::vector<app::LogTable> tables = app::RigLog(spec, true).tables();
  EXPECT_THAT(tables[0].names, ElementsAre("ropes[tow]", "moorings[bow]"));
  EXPECT_THAT(tables[1].names, ElementsAre("crank", "ring"));
  EXPECT_THAT(tables[2].names, ElementsAre("propellers[main]", "rudders[aft]", "sails[lug]"));
  EXPECT_THAT(tables[3].names, ElementsAre("propellers[main].speed_rps"));
  const auto numbers = app::RigLog(spec, true).numbers(readings, states);
  ASSERT_EQ(numbers.size(), tables.size());
  for (std::size_t i = 0; i < tables.size(); ++i)
    EXPECT_EQ(numbers[i].size(), tables[i].layout.width() * tables[i].names.size());
}

TEST_F(RigLog, LeavesEmptyWhatAThingDoesNotHave) {
  write(app::LogFormat::csv);
  EXPECT_THAT(text_of("lines.csv"),
              testing::StartsWith(
                  "time,line,tension,distance,length,taut,broken,x1,y1,z1,x2,y2,z2,fx,fy,fz,"
                  "resting\n0,ropes[tow],3333.3333333333335,12.1,12,1,0,1,2,3,4,5,6,0,"
                  "0.3333333333333333,9,\n0,moorings[bow],7,"));
  EXPECT_THAT(text_of("joints.csv"),
              HasSubstr("0,crank,0.1,0.2,1,0,0,0,0,0,0.3\n0,ring,,,0,0,0,0,2,0,\n"));
  EXPECT_THAT(text_of("machines.csv"),
              testing::StartsWith("time,machine,setting,angle_deg,thrust,torque,advance,wetted,"
                                  "attack_deg,flow,fx,fy,fz\n0,propellers[main],3,90,100,5,0.4,"
                                  "0.75,,,"));
  EXPECT_THAT(text_of("machines.csv"), HasSubstr("0,sails[lug],,0,,,,,0,8,0,0,0\n"));
  EXPECT_EQ(text_of("controls.csv"),
            "time,set_point,value\n0,propellers[main].speed_rps,3\n"
            "0.1,propellers[main].speed_rps,3\n");
}

TEST_F(RigLog, HasTheNodesOfLinesWithInertiaUntilTheyBreak) {
  spec.lines[0].inertia = engine::LineInertia{.segments = 1};
  spec.lines[1].inertia = engine::LineInertia{.segments = 2};
  readings.lines[0].nodes_W = {{1, 2, 3}, {4, 5, 1.0 / 3}};
  const std::vector<app::LogTable> tables = app::RigLog(spec, true).tables();
  ASSERT_EQ(tables.size(), 5u);
  EXPECT_THAT(tables[1].names, ElementsAre("ropes[tow].0", "ropes[tow].1", "moorings[bow].0",
                                           "moorings[bow].1", "moorings[bow].2"));
  write(app::LogFormat::csv);
  EXPECT_THAT(text_of("line_nodes.csv"),
              testing::StartsWith("time,line_node,x,y,z\n0,ropes[tow].0,1,2,3\n"
                                  "0,ropes[tow].1,4,5,0.3333333333333333\n"
                                  "0,moorings[bow].0,,,\n0,moorings[bow].1,,,\n"
                                  "0,moorings[bow].2,,,\n0.1,ropes[tow].0,1,2,3\n"));
  EXPECT_THAT(text_of("lines.csv"), HasSubstr(",2.857142857142857\n"));
}

// The azimuth turns the thrust from x to y of the body, whose y axis points up.
TEST_F(RigLog, TheForceOfAPropellerIsItsThrustInTheWorld) {
  write(app::LogFormat::csv);
  const app::TableLayout layout = app::machines_layout();
  const app::TableRows table = app::read_table_csv(folder / layout.file, layout);
  const app::TableTrack& track = table.tracks.at("propellers[main]");
  const double round_off = 1e-13;  // of 100 N
  EXPECT_NEAR(track.columns[layout.column("fx")][0], 0, round_off);
  EXPECT_NEAR(track.columns[layout.column("fy")][0], 0, round_off);
  EXPECT_NEAR(track.columns[layout.column("fz")][0], 100, round_off);
}

TEST_F(RigLog, IsReadBackToTheSameNumbersInEitherFormat) {
  spec.lines[0].inertia = spec.lines[1].inertia = engine::LineInertia{.segments = 1};
  readings.lines[0].nodes_W = {{1, 2, 3}, {4, 5, 1.0 / 3}};
  for (const app::LogFormat format : {app::LogFormat::csv, app::LogFormat::hdf5}) {
    if (format == app::LogFormat::hdf5 && !app::why_no_hdf5().empty()) continue;
    write(format);
    const std::vector<app::LogTable> tables = app::RigLog(spec, true).tables();
    const auto numbers = app::RigLog(spec, true).numbers(readings, states);
    for (std::size_t i = 0; i < tables.size(); ++i) {
      const auto table = app::read_table(app::trajectory_of(folder), tables[i].layout);
      ASSERT_TRUE(table) << tables[i].layout.file;
      EXPECT_EQ(table->names, tables[i].names);
      auto expected = numbers[i].begin();
      for (const std::string& name : table->names) {
        const app::TableTrack& track = table->tracks.at(name);
        EXPECT_THAT(track.times, ElementsAre(0.0, 0.1));
        for (const std::vector<double>& column : track.columns) {
          ASSERT_EQ(column.size(), 2u);
          EXPECT_TRUE(column[1] == *expected || (std::isnan(column[1]) && std::isnan(*expected)));
          ++expected;
        }
      }
    }
    EXPECT_FALSE(app::read_table(app::trajectory_of(folder), app::all_table_layouts().front()));
  }
}

TEST_F(RigLog, LeavesNoTableOfAnEarlierRun) {
  write(app::LogFormat::csv);
  EXPECT_TRUE(fs::exists(folder / "joints.csv"));
  app::make_log(app::LogFormat::csv, {.bodies = {"tug"}}, folder)->finish();
  EXPECT_THAT(support::files_in(folder), ElementsAre("trajectory.csv"));
}

TEST_F(RigLog, ATableIsContinuedFromItsSavedLength) {
  const app::RigLog log(spec, true);
  const app::LogSubject subject{.bodies = {"tug"}, .tables = log.tables()};
  const auto numbers = log.numbers(readings, states);
  const auto add = [&](app::Log& file, double time) {
    file.add({.time = time, .states = states, .forces = {}, .interiors = {}, .tables = numbers});
  };
  write(app::LogFormat::csv);
  const std::string whole = text_of("machines.csv");
  app::LogPosition position;
  {
    const auto file = app::make_log(app::LogFormat::csv, subject, folder);
    add(*file, 0);
    position = file->save();
    add(*file, 77);  // it is lost
  }
  const auto file = app::make_log(app::LogFormat::csv, subject, folder, position);
  add(*file, 0.1);
  file->finish();
  EXPECT_EQ(text_of("machines.csv"), whole);
}

TEST_F(RigLog, AFaultOfATableNamesItsLine) {
  const app::TableLayout layout = app::controls_layout();
  const auto fault = [&](const std::string& text) {
    std::ofstream(folder / layout.file) << text;
    try {
      app::read_table_csv(folder / layout.file, layout);
    } catch (const scene::InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(fault("time,set_point,value\n0,a,1\n0,b,1\n0.5,a,\n"), "none");
  EXPECT_THAT(fault("time,value\n"), HasSubstr(":1:1: expected the header time,set_point,value"));
  EXPECT_THAT(fault("time,set_point,value\n0,a,1\n0,a,1\n"),
              HasSubstr(":3:1: found time 0 after 0, expected ascending times of set_point a"));
  EXPECT_THAT(fault("time,set_point,value\n0,a,1,2\n"), HasSubstr(":2:1: found 4 fields"));
  EXPECT_THAT(fault("time,set_point,value\n0,a,x\n"), HasSubstr(":2:1: found \"x\""));
}

TEST_F(RigLog, TotalsGoOnFromTheirStateAsIfNotInterrupted) {
  app::RigTotals whole, first, second;
  for (int i = 0; i < 9; ++i) {
    readings.lines[0].tension = std::sin(i);
    readings.lines[1].broken = i > 6;
    readings.propellers[0].torque = std::cos(i);
    readings.joints[0].coordinate = std::sin(i);
    readings.joints[0].motor = i;
    whole.add(0.1 * i, spec, readings);
    (i < 4 ? first : second).add(0.1 * i, spec, readings);
    if (i == 3) second.restore(nlohmann::ordered_json::parse(first.state().dump()));
  }
  EXPECT_EQ(second.state(), whole.state());
  const nlohmann::ordered_json lines = whole.lines(spec);
  EXPECT_EQ(lines["ropes[tow]"]["tension_max"], std::sin(8));
  EXPECT_EQ(lines["ropes[tow]"]["at"], 0.8);
  EXPECT_TRUE(lines["ropes[tow]"]["broken_at"].is_null());
  EXPECT_EQ(lines["moorings[bow]"]["broken_at"], 0.1 * 7);
  ASSERT_EQ(whole.joint(spec, 0).size(), 1u) << "a joint without a drive has a stroke alone";
  EXPECT_NEAR(whole.joint(spec, 0)["stroke"].get<double>(), std::sin(8) - std::sin(5), 1e-13);
  EXPECT_TRUE(whole.joint(spec, 1).empty()) << "a ball joint has no coordinate";
  double torque = 0;
  for (int i = 0; i < 9; ++i) torque += std::cos(i) / 9;
  EXPECT_NEAR(whole.machines(spec)["propellers[main]"]["power_mean"].get<double>(),
              2 * std::numbers::pi * 3 * torque, 1e-13);
}

TEST_F(RigLog, TotalsHaveTheWorkOfEachPartOfADrive) {
  // A hinge that turns on at 2 rad/s, over half a turn, with a damper of 3 N m s, a spring of
  // 5 N m/rad at rest where it starts, and a motor that drives with 7 N m.
  spec.joints[0].drive = {.motor = engine::JointMotor{}, .stiffness = 5, .damping = 3};
  app::RigTotals totals;
  for (int i = 0; i <= 10; ++i) {
    const double q = 0.4 * i;
    readings.joints[0] = {.coordinate = std::remainder(q, 2 * std::numbers::pi),
                          .speed = 2,
                          .damper = -6,
                          .spring = -5 * q,
                          .motor = 7};
    totals.add(0.2 * i, spec, readings);
  }
  const nlohmann::ordered_json joint = totals.joint(spec, 0);
  const auto near = [](const nlohmann::ordered_json& part, double mean, double most, double rms,
                       double effort) {
    EXPECT_NEAR(part["power_mean"].get<double>(), mean, 1e-12);
    EXPECT_NEAR(part["power_max"].get<double>(), most, 1e-12);
    EXPECT_NEAR(part["effort_rms"].get<double>(), rms, 1e-12);
    EXPECT_NEAR(part["effort_max"].get<double>(), effort, 1e-12);
  };
  EXPECT_NEAR(joint["stroke"].get<double>(), 4, 1e-12) << "counted on over half a turn";
  near(joint["damper"], 12, 12, 6, 6);
  near(joint["motor"], -14, -14, 7, 7);
  near(joint["spring"], 5 * 4 * 4 / 2.0 / 2, 5 * 3.8 * 2, std::sqrt(134.0), 20);
  EXPECT_NEAR(joint["power_mean"].get<double>(), 12 - 14 + 20, 1e-12);
  EXPECT_NEAR(joint["power_max"].get<double>(), 12 - 14 + 38, 1e-12);
}

}  // namespace

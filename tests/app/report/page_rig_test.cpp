#include "app/report/page_rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "app/logs/rig_log.h"

namespace {

using testing::ElementsAre;

/// A run of two times with a rope between two bodies that breaks, a hinge to the world that turns,
/// a sail and a control. Every other number is 0.
app::LoggedRun logged_run() {
  app::LoggedRun run;
  engine::SimulationSpec& spec = run.built.spec;
  spec.bodies = {{.name = "a"}, {.name = "b"}};
  spec.lines = {{.name = "r",
                 .kind = engine::LineSpec::Kind::rope,
                 .first = {.body = 1},
                 .second = {.body = 0}}};
  spec.joints = {{.name = "h", .type = engine::JointSpec::Type::hinge, .second = 1}};
  spec.foils.resize(1);
  spec.foils[0].name = "s";
  spec.foils[0].fluid = engine::FoilSpec::Fluid::air;
  spec.set_points = {{.name = "sails[s].angle_deg"}};
  spec.controls = {{.set = 0}};
  engine::RigReadings readings{.lines = {{.tension = 9}},
                               .joints = {{.coordinate = std::numbers::pi / 6}},
                               .propellers = {},
                               .foils = {{.angle = std::numbers::pi / 4}},
                               .set_points = {45}};
  readings.foils[0].force_W = {2, 3, 6};
  const app::RigLog log(spec, true);
  const std::vector<hydro::BodyState> states(2);
  for (const app::LogTable& table : log.tables())
    run.tables.push_back({.layout = table.layout, .names = table.names, .tracks = {}});
  for (const double time : {0.0, 0.5}) {
    readings.lines[0].broken = time > 0;
    const auto numbers = log.numbers(readings, states);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      app::TableTrack& track = run.tables[i].tracks[run.tables[i].names[0]];
      track.times.push_back(time);
      track.columns.resize(numbers[i].size());
      for (std::size_t k = 0; k < numbers[i].size(); ++k) track.columns[k].push_back(numbers[i][k]);
    }
  }
  run.rows = 2;
  return run;
}

TEST(ReportRig, HasColumnsBodiesAndBreaksOfEverythingThatWasLogged) {
  const app::LoggedRun run = logged_run();
  const nlohmann::ordered_json page = app::page_rig(run, app::Thinning(run.rows, 16));
  const nlohmann::ordered_json& line = page["lines"][0];
  EXPECT_EQ(line["name"], "ropes[r]");
  EXPECT_THAT(line["bodies"].get<std::vector<int>>(), ElementsAre(1, 0));
  EXPECT_EQ(line["broken_at"], 0.5);
  EXPECT_EQ(line["columns"]["tension"], 9);
  EXPECT_FALSE(line["columns"].contains("resting"));
  const nlohmann::ordered_json& joint = page["joints"][0];
  EXPECT_EQ(joint["type"], "hinge");
  EXPECT_THAT(joint["bodies"].get<std::vector<int>>(), ElementsAre(1));
  EXPECT_NEAR(joint["columns"]["coordinate"].get<double>(), 30, 1e-13);
  const nlohmann::ordered_json& foil = page["foils"][0];
  EXPECT_EQ(foil["fluid"], "air");
  EXPECT_NEAR(foil["columns"]["angle"].get<double>(), 45, 1e-13);
  EXPECT_EQ(foil["columns"]["force"], 7);
  EXPECT_TRUE(page["propellers"].empty());
  EXPECT_EQ(page["controls"][0]["name"], "sails[s].angle_deg");
  EXPECT_EQ(page["controls"][0]["columns"]["value"], 45);
}

// The page's limit on numbers counts them.
TEST(ReportRig, CountsTheColumnsThatItHas) {
  const app::LoggedRun run = logged_run();
  const nlohmann::ordered_json page = app::page_rig(run, app::Thinning(run.rows, 16));
  std::size_t columns = 0;
  for (const auto& things : page)
    for (const auto& thing : things) columns += thing["columns"].size();
  EXPECT_EQ(app::rig_columns(run), columns);
  EXPECT_EQ(columns, 3u + 5u + 4u + 1u);
}

TEST(ReportRig, IsEmptyWithoutTables) {
  const app::LoggedRun run;
  for (const auto& things : app::page_rig(run, app::Thinning(1, 16))) EXPECT_TRUE(things.empty());
  EXPECT_EQ(app::rig_columns(run), 0u);
}

}  // namespace

#include "app/run/constraint_errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "hydro/mesh/primitives.h"

namespace {

using app::RunErrors;
using engine::Pair;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Json = nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180;

/// A crate of 1 m and a beam of 4 m.
engine::SimulationSpec crate_and_beam() {
  return {.bodies = {{.name = "crate", .mesh_B = hydro::make_box({1, 1, 1})},
                     {.name = "beam", .mesh_B = hydro::make_box({4, 0.2, 0.2})}}};
}

TEST(ConstraintErrors, AreToldOfOverlapsByTheirShareOfTheSmallerBody) {
  const engine::SimulationSpec spec = crate_and_beam();
  RunErrors errors;
  EXPECT_THAT(app::error_lines(spec, errors), IsEmpty());
  EXPECT_EQ(app::overlaps_summary(spec, errors.constraints),
            Json::parse(R"({"pairs": 0, "largest": []})"));
  errors.constraints.overlaps = {{Pair(engine::kWorld, 1), {.value = 0.03, .time = 2}},
                                 {Pair(0, 1), {.value = 0.009, .time = 1}}};
  EXPECT_THAT(app::error_warnings(spec, errors), IsEmpty());
  EXPECT_THAT(app::error_lines(spec, errors),
              ElementsAre("  largest overlaps: beam and crate 0.009 m at 1 s; beam and ground 0.03 "
                          "m at 2 s"));
  const Json told = app::overlaps_summary(spec, errors.constraints);
  EXPECT_EQ(told["pairs"], 2);
  EXPECT_EQ(told["largest"][0]["bodies"], Json({"beam", "crate"}));
  EXPECT_EQ(told["largest"][1]["bodies"], Json({"beam", "ground"}));
  EXPECT_EQ(told["largest"][1]["depth"], 0.03);
  EXPECT_EQ(told["largest"][1]["at"], 2);
  EXPECT_EQ(told["largest"][1]["share_of_size"], 0.03 / 4);
  errors.constraints.overlaps[Pair(engine::kWorld, 0)] = {.value = 0.27, .time = 2.5};
  errors.constraints.overlaps[Pair(0, 1)].value = 0.02;
  EXPECT_THAT(app::error_warnings(spec, errors),
              ElementsAre(HasSubstr("crate and ground overlapped by 0.27 m at 2.5 s, 27 % of the "
                                    "smaller one's size (and 1 other pair by more than 1 %): ")));
}

TEST(ConstraintErrors, AreSummedUpOfTheTenLargestOverlapsAndOfAllThatAreNotable) {
  engine::SimulationSpec spec;
  RunErrors errors;
  for (int i = 0; i < 40; ++i) {
    spec.bodies.push_back({.name = "b" + std::to_string(i), .mesh_B = hydro::make_box({1, 1, 1})});
    errors.constraints.overlaps[Pair(engine::kWorld, i)] = {.value = 1e-3, .time = 1};
  }
  const auto told = [&] {
    const Json summary = app::overlaps_summary(spec, errors.constraints);
    EXPECT_EQ(summary["pairs"], 40);
    return summary["largest"].size();
  };
  EXPECT_EQ(told(), 10u);
  for (int i = 7; i < 30; ++i) errors.constraints.overlaps[Pair(engine::kWorld, i)].value = 0.02;
  EXPECT_EQ(told(), 23u);
  EXPECT_THAT(app::error_lines(spec, errors),
              ElementsAre("  largest overlaps: b7 and ground 0.02 m at 1 s; b8 and ground 0.02 m "
                          "at 1 s; b9 and ground 0.02 m at 1 s; and 37 more"));
}

TEST(ConstraintErrors, AreToldOfJointsInMetresAndDegrees) {
  engine::SimulationSpec spec = crate_and_beam();
  spec.joints = {{.name = "pin", .type = engine::JointSpec::Type::hinge, .first = 0, .second = 1},
                 {.name = "eye", .first = 1, .second = engine::kWorld}};
  RunErrors errors;
  errors.constraints.joints = {
      {.separation = {.value = 2e-3, .time = 3}, .turn = {.value = 0.5 * kDegree, .time = 4}},
      {.separation = {.value = 0.03, .time = 5}, .turn = {}}};
  EXPECT_EQ(app::joints_summary(spec, errors.constraints)["eye"],
            Json::parse(R"({"position_error_max": 0.03, "position_error_at": 5.0})"));
  const Json pin = app::joints_summary(spec, errors.constraints)["pin"];
  EXPECT_EQ(pin["position_error_max"], 2e-3);
  EXPECT_EQ(pin["position_error_at"], 3);
  EXPECT_DOUBLE_EQ(pin["angle_error_max_deg"].get<double>(), 0.5);
  EXPECT_EQ(pin["angle_error_at"], 4);
  // 3 cm are less than a hundredth of the beam, 0.5° less than 0.01 rad.
  EXPECT_THAT(app::error_warnings(spec, errors), IsEmpty());
  errors.constraints.joints[0].turn = {.value = 1.5 * kDegree, .time = 6};
  EXPECT_THAT(app::error_warnings(spec, errors),
              ElementsAre(HasSubstr("joint 'pin' came apart by 0.002 m and 1.5° at 6 s, 2.62 % ")));
  errors.constraints.joints[1].separation.value = 0.2;
  EXPECT_THAT(app::error_warnings(spec, errors),
              ElementsAre(HasSubstr("joint 'eye' came apart by 0.2 m at 5 s, 5 % of the smaller "
                                    "body's size (and 1 other joint by more than 1 %): ")));
  EXPECT_THAT(app::error_lines(spec, errors),
              ElementsAre("  largest errors of joints: eye 0.2 m at 5 s; pin 0.002 m and 1.5° at "
                          "6 s"));
}

TEST(ConstraintErrors, AreToldOfWorkThatTheLimiterTook) {
  const engine::SimulationSpec spec = crate_and_beam();
  RunErrors errors;
  errors.works = {{.weight = 999, .brake = -1}, {.weight = 5}};
  errors.counts = {{.substeps = 9, .clamped = 9}, {}};
  EXPECT_THAT(app::error_warnings(spec, errors), IsEmpty());
  EXPECT_THAT(app::error_lines(spec, errors),
              ElementsAre("  slowed by the energy limiter: crate by 0.1 % of the work on it"));
  errors.works[0].brake = -111;
  EXPECT_THAT(app::error_warnings(spec, errors),
              ElementsAre(HasSubstr("body 'crate' was slowed by 10 % of the work on it to keep it "
                                    "from gaining energy: ")));
}

TEST(ConstraintErrors, AreToldOfSubstepsThatTheLimiterSlowedWhereNoWorkIsRecorded) {
  const engine::SimulationSpec spec = crate_and_beam();
  RunErrors errors;
  errors.counts = {{.substeps = 300, .clamped = 2}, {.substeps = 40}};
  EXPECT_THAT(app::error_warnings(spec, errors), IsEmpty());
  EXPECT_THAT(app::error_lines(spec, errors),
              ElementsAre("  slowed by the energy limiter: crate in 2 of its 300 substeps"));
  errors.counts[0].clamped = errors.counts[1].clamped = 4;
  EXPECT_THAT(
      app::error_warnings(spec, errors),
      ElementsAre(HasSubstr("body 'beam' was slowed in 4 of its 40 substeps to keep it from "
                            "gaining energy (and 1 other body by more than 1 %): ")));
}

}  // namespace

#include "app/run/motion_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "hydro/airy_waves.h"
#include "hydro/mesh/primitives.h"
#include "hydro/water/hull_sources.h"

namespace {

using app::MotionWatch;
using Eigen::Vector3d;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kGravity = 9.80665, kStep = 0.1;

/// A hull of 4 m, whose Froude number at 1 m/s is 0.16, that floats at rest.
assembly::BuiltScene hull(bool radiates) {
  const hydro::TriMesh box = hydro::make_box({4, 1, 1});
  engine::BodySpec body{.name = "hull", .mesh_B = box, .mass = 2000};
  if (radiates) {
    hydro::RadiationData data;
    data.frequencies = {1};
    data.added_mass = {hydro::Matrix6d::Identity()};
    data.damping = {hydro::Matrix6d::Zero()};
    data.infinite_added_mass = hydro::Matrix6d::Identity();
    body.radiation = std::make_shared<const hydro::FloatingBody>(box, data);
  }
  assembly::BuiltScene built;
  built.spec = {.step = kStep, .gravity = kGravity, .sea = hydro::Sea{.gravity = kGravity}};
  built.spec.bodies = {body};
  return built;
}

/// A hull that a load drives.
assembly::BuiltScene driven_hull() {
  assembly::BuiltScene built = hull(false);
  built.spec.bodies[0].loads = {{.force = {100, 0, 0}}};
  return built;
}

/// Warnings of a minute with velocities along x, at a height of the hull's middle over the water.
std::vector<std::string> warnings_of(MotionWatch& watch, const std::function<double(double)>& speed,
                                     double height = 0) {
  std::vector<std::string> all;
  for (int i = 1; i <= 600; ++i) {
    hydro::BodyState state{.position = {0, 0, height}};
    state.linear_velocity.x() = speed(i * kStep);
    for (const std::string& warning : watch.after_step(i * kStep, {state})) all.push_back(warning);
  }
  return all;
}

std::vector<std::string> warnings_of(const assembly::BuiltScene& built,
                                     const std::function<double(double)>& speed,
                                     double height = 0) {
  MotionWatch watch(built);
  return warnings_of(watch, speed, height);
}

double ahead(double time) { return std::min(0.05 * time, 1.5); }

TEST(MotionWatch, TellsOnceWhereABodyWithRadiationGoesTooFast) {
  const assembly::BuiltScene built = hull(true);
  EXPECT_THAT(warnings_of(built, ahead),
              ElementsAre(AllOf(HasSubstr("body 'hull' goes through the water at 0.63 m/s at "),
                                HasSubstr(" a Froude number above 0.1, and its waves"))));
  EXPECT_THAT(warnings_of(built, [](double time) { return 0.4 * ahead(time); }), IsEmpty());
  EXPECT_THAT(warnings_of(hull(false), ahead), IsEmpty());
}

TEST(MotionWatch, LeavesTheSpeedOfASlenderHullToSimulatedWater) {
  assembly::BuiltScene built = hull(true);
  built.spec.bodies[0].loads = {{.force = {100, 0, 0}}};
  built.spec.bodies[0].sources = std::make_shared<const hydro::HullSources>();
  EXPECT_THAT(warnings_of(built, ahead), IsEmpty());
  built.spec.sea->surface = hydro::WaveSurface{{hydro::deep_water_wave(0.01, 4, 0, 0, kGravity)}};
  EXPECT_THAT(warnings_of(built, ahead), ElementsAre(HasSubstr("heave and pitch in waves")));
  built.spec.bodies[0].mesh_B = hydro::make_box({4, 2, 1});
  EXPECT_THAT(warnings_of(built, ahead), ElementsAre(HasSubstr("waves of a thin ship for it")));
}

TEST(MotionWatch, CountsTheSpeedInTheWater) {
  assembly::BuiltScene built = hull(true);
  built.spec.sea->current = {1.5, 0, 0};
  built.spec.bodies[0].initial.linear_velocity = {1.5, 0, 0};
  EXPECT_THAT(warnings_of(built, [](double) { return 1.5; }), IsEmpty());
  EXPECT_EQ(warnings_of(built, [](double) { return 0.0; }).size(), 1u);
}

TEST(MotionWatch, LeavesAStartWithForwardSpeedToTheWarningsOfTheScene) {
  assembly::BuiltScene built = hull(true);
  built.spec.bodies[0].initial.linear_velocity = {1, 0, 0};
  EXPECT_THAT(warnings_of(built, [](double) { return 1.0; }), IsEmpty());
}

TEST(MotionWatch, DoesNotTakeAnOscillationForForwardSpeed) {
  assembly::BuiltScene built = hull(true);
  built.spec.sea->surface =
      hydro::WaveSurface{{hydro::deep_water_wave(2, 100, 0, 0, kGravity)}};  // a period of 8 s
  const double omega = std::sqrt(2 * M_PI * kGravity / 100);
  EXPECT_THAT(warnings_of(built, [&](double time) { return 2 * omega * std::sin(omega * time); }),
              IsEmpty());
}

TEST(MotionWatch, TellsADrivenHullInTheSurfaceThatNoResistanceOfWavesIsComputed) {
  EXPECT_THAT(warnings_of(driven_hull(), ahead),
              ElementsAre(AllOf(HasSubstr("at 1.3 m/s at "), HasSubstr("above 0.2: the resistance "
                                                                       "by the waves"))));
  EXPECT_THAT(warnings_of(driven_hull(), ahead, -2), IsEmpty());  // under water
  EXPECT_THAT(warnings_of(driven_hull(), ahead, 2), IsEmpty());
  EXPECT_THAT(warnings_of(driven_hull(), [](double t) { return ahead(t) / 2; }), IsEmpty());
  assembly::BuiltScene heavy = driven_hull();
  heavy.spec.bodies[0].mass = 5000;
  EXPECT_THAT(warnings_of(heavy, ahead), IsEmpty());
}

TEST(MotionWatch, KnowsTheResistanceThatAHullHas) {
  assembly::BuiltScene built = driven_hull();
  built.spec.bodies[0].resistance = std::make_shared<const hydro::Resistance>(
      hydro::Resistance{.curve = {{1}, {10}}, .volume = 2});
  EXPECT_THAT(warnings_of(built, ahead), IsEmpty());
}

TEST(MotionWatch, TellsThatPlaningIsNotComputed) {
  // The volume afloat is 2 m³, so the number is 1.2 at 4.2 m/s.
  const auto fast = [](double time) { return std::min(0.2 * time, 4.5); };
  EXPECT_THAT(warnings_of(driven_hull(), fast),
              ElementsAre(HasSubstr("above 0.2"),
                          AllOf(HasSubstr("at 4.2 m/s at "),
                                HasSubstr("a volume Froude number above 1.2, at which hulls "))));
  EXPECT_EQ(warnings_of(driven_hull(), [&](double t) { return 0.9 * fast(t); }).size(), 1u);
  EXPECT_THAT(warnings_of(driven_hull(), fast, 2), IsEmpty());  // in the air
  EXPECT_THAT(warnings_of(hull(false), fast), IsEmpty());       // not driven
}

TEST(MotionWatch, CountsHullsThatMachinesLinesAndJointsDrive) {
  const auto told = [](const std::function<void(engine::SimulationSpec&)>& change) {
    assembly::BuiltScene built = hull(false);
    change(built.spec);
    return warnings_of(built, ahead).size() == 1;
  };
  EXPECT_FALSE(told([](auto&) {}));
  EXPECT_TRUE(told([](auto& spec) { spec.propellers = {{.name = "main", .body = 0}}; }));
  EXPECT_TRUE(told([](auto& spec) { spec.foils = {{.name = "sail", .body = 0}}; }));
  EXPECT_TRUE(told([](auto& spec) { spec.lines = {{.name = "tow", .first = {.body = 0}}}; }));
  using Type = engine::JointSpec::Type;
  const auto joined = [](Type type, engine::BodyId other) {
    return [type, other](engine::SimulationSpec& spec) {
      spec.joints = {{.type = type, .first = other, .second = 0}};
    };
  };
  EXPECT_TRUE(told(joined(Type::slider, engine::kWorld)));
  EXPECT_TRUE(told(joined(Type::hinge, 1)));
  EXPECT_FALSE(told(joined(Type::hinge, engine::kWorld)));  // a gate in a stream
}

TEST(MotionWatch, GoesOnFromItsState) {
  const assembly::BuiltScene built = hull(true);
  MotionWatch whole(built), first(built);
  const auto steps = [](MotionWatch& watch, int from, int to) {
    std::vector<std::string> all;
    for (int i = from; i <= to; ++i) {
      hydro::BodyState state;
      state.linear_velocity.x() = ahead(i * kStep);
      for (const std::string& w : watch.after_step(i * kStep, {state})) all.push_back(w);
    }
    return all;
  };
  const auto text = [](const MotionWatch& watch) { return watch.state().dump(); };
  ASSERT_EQ(steps(whole, 1, 300).size(), 1u);
  steps(first, 1, 100);
  MotionWatch resumed(built);
  resumed.restore(nlohmann::ordered_json::parse(text(first)));
  EXPECT_EQ(steps(resumed, 101, 300).size(), 1u);
  EXPECT_EQ(text(resumed), text(whole));
  MotionWatch later(built);
  later.restore(resumed.state());
  EXPECT_THAT(steps(later, 301, 400), IsEmpty());
}

}  // namespace

#include "app/assembly/rigid_group.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/assembly/build.h"
#include "app/hydrostatics/hydrostatics.h"
#include "app/scene/diagnostics.h"
#include "engine/simulation.h"
#include "tests/app/build_fault.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

/// @file
/// Bodies that fixed joints hold together float as one.

namespace {

using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;

/// A hull of 10 x 4 x 2 m and 20 t, and a cabin of 2 t whose centre is 0.5 m to port and 1.5 m over
/// that of the hull. Both lie far from where they float.
const std::string kTwoBoxes =
    "plimsoll: 1\nduration: 1\nstep: 0.01\nwater: {density: 1000, level: 2}\nbodies:\n"
    "  - name: hull\n"
    "    box: {size: [10, 4, 2]}\n"
    "    mass: 20000\n"
    "    position: [7, -3, 30]\n"
    "    orientation: {axis: [0, 0, 1], angle_deg: 90}\n"
    "    start: equilibrium\n"
    "    collision: none\n"
    "  - name: cabin\n"
    "    box: {size: [2, 1, 1]}\n"
    "    mass: 2000\n"
    "    position: [6.5, -3, 31.5]\n"
    "    orientation: {axis: [0, 0, 1], angle_deg: 90}\n"
    "    collision: none\n";
const std::string kFixed = "joints: [{type: fixed, bodies: [hull, cabin]}]\n";

assembly::BuiltScene assembled(const std::string& text) {
  return assembly::build_without_added_mass(support::read_scene_text(text));
}

/// Draught on the centre line and heel of the two boxes as one.
struct Floating {
  double draught = 22.0 / 40;
  double heel = 0;  ///< To port, where the cabin is [rad].
};

/// For a hull with upright sides the lever is sin φ (GM + BM tan²φ / 2) − y_G cos φ.
Floating closed_form() {
  Floating floating;
  const double T = floating.draught;
  const double y_G = 2.0 * 0.5 / 22, z_G = 2.0 * 1.5 / 22;
  const double BM = 4.0 * 4 / (12 * T), GM = T / 2 + BM - (1 + z_G);
  double t = y_G / GM;
  for (int i = 0; i < 50; ++i) t -= (t * (GM + BM * t * t / 2) - y_G) / (GM + 1.5 * BM * t * t);
  floating.heel = std::atan(t);
  return floating;
}

TEST(RigidGroup, ABoxWithABoxFixedOnTopFloatsAtTheDraughtAndHeelOfBoth) {
  const Floating expected = closed_form();
  const engine::SimulationSpec spec = assembled(kTwoBoxes + kFixed).spec;
  const hydro::BodyState &hull = spec.bodies[0].initial, &cabin = spec.bodies[1].initial;
  const double nano = support::tolerance(1e-9);
  EXPECT_NEAR(hull.position.x(), 7, nano);
  EXPECT_NEAR(hull.position.y(), -3, nano);
  // The hull's centre is 1 m over its keel.
  EXPECT_NEAR(hull.position.z(), 2 + (1 - expected.draught) * std::cos(expected.heel), nano);
  EXPECT_LT((hydro::euler_angles(hull.orientation) - Vector3d(-expected.heel, 0, M_PI / 2)).norm(),
            nano);
  EXPECT_GT(expected.heel, M_PI / 180);
  // The cabin has kept its place on the hull.
  const Vector3d on_hull = hull.orientation.conjugate() * (cabin.position - hull.position);
  EXPECT_LT((on_hull - Vector3d(0, 0.5, 1.5)).norm(), nano);
  EXPECT_LT(cabin.orientation.angularDistance(hull.orientation), nano);
}

TEST(RigidGroup, StaysAtRestInTheSimulation) {
  const engine::SimulationSpec spec = assembled(kTwoBoxes + kFixed).spec;
  engine::Simulation simulation(spec);
  for (int i = 0; i < 1000; ++i) simulation.step();
  for (std::size_t body = 0; body < 2; ++body) {
    const hydro::BodyState& end = simulation.states()[body];
    EXPECT_LT((end.position - spec.bodies[body].initial.position).norm(), support::tolerance(1e-7));
    EXPECT_LT(end.linear_velocity.norm(), support::tolerance(1e-7));
    EXPECT_LT(end.angular_velocity.norm(), support::tolerance(1e-7));
  }
}

TEST(RigidGroup, WithoutTheJointTheHullFloatsAlone) {
  const engine::SimulationSpec spec = assembled(kTwoBoxes).spec;
  EXPECT_NEAR(spec.bodies[0].initial.position.z(), 2 + 1 - 0.5, support::tolerance(1e-9));
  EXPECT_EQ(spec.bodies[1].initial.position, Vector3d(6.5, -3, 31.5));
}

TEST(RigidGroup, ABodyUnderWaterCarriesItsPart) {
  // A keel of water's density under the hull draws it neither up nor down.
  const std::string keel =
      "  - {name: keel, box: {size: [4, 0.2, 1]}, mass: 800, position: [7, -3, 28.5]}\n"
      "joints: [{type: fixed, bodies: [keel, hull]}]\n";
  const engine::SimulationSpec spec = assembled(kTwoBoxes + keel).spec;
  EXPECT_NEAR(spec.bodies[0].initial.position.z(), 2 + 1 - 0.5, support::tolerance(1e-9));
  EXPECT_NEAR(spec.bodies[2].initial.position.z(), 2 - 1, support::tolerance(1e-9));
}

TEST(RigidGroup, IsOneBodyOfTheHydrostatics) {
  const auto bodies = app::floating_bodies({.file = support::write_scene(kTwoBoxes + kFixed)});
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_EQ(bodies[0].name, "hull + cabin");
  EXPECT_EQ(bodies[0].mass, 22000);
  EXPECT_LT((bodies[0].com_M - Vector3d(0, 1.0 / 22, 3.0 / 22)).norm(), support::tolerance(1e-12));
  const app::FloatingReport report = app::floating_report(bodies[0], {0});
  EXPECT_NEAR(report.volume, 82, support::tolerance(1e-10));
  EXPECT_NEAR(hydro::euler_angles(report.orientation)[0], -closed_form().heel,
              support::tolerance(1e-9));
}

TEST(RigidGroup, JointsOfOtherTypesDoNotJoin) {
  std::string given = kTwoBoxes;
  given.replace(given.find("start: equilibrium"), 18, "start: given");
  const engine::SimulationSpec spec =
      assembled(given + "joints: [{type: ball, bodies: [hull, cabin], anchor: [7, -3, 31]}]\n")
          .spec;
  const auto groups = assembly::rigid_groups(spec);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_THAT(groups[1].bodies, ElementsAre(1));
}

TEST(RigidGroup, WhatHoldsItIsAFaultAtTheKey) {
  const std::string to_world =
      "joints: [{type: fixed, bodies: [hull, cabin]}, "
      "{name: weld, type: fixed, bodies: [cabin, world]}]\n";
  EXPECT_THAT(support::build_fault(kTwoBoxes + to_world),
              HasSubstr(":11:12: bodies[0].start: equilibrium needs z, roll or pitch to be free, "
                        "but the joint weld fixes it to the world"));
  EXPECT_THAT(support::build_fault(kTwoBoxes + "    start: equilibrium\n" + kFixed),
              HasSubstr("bodies[1].start: found equilibrium, but fixed joints hold it to hull"));
  EXPECT_THAT(support::build_fault(kTwoBoxes + "    start: given\n" + kFixed),
              HasSubstr("bodies[1].start: found given, but fixed joints hold it to hull"));
  std::string heavy = kTwoBoxes;
  heavy.replace(heavy.find("mass: 2000\n"), 10, "mass: 90000");
  EXPECT_THAT(support::build_fault(heavy + kFixed),
              HasSubstr("bodies[0].start: with all that is fixed to it, it sinks: its mass is "
                        "110000 kg"));
}

}  // namespace

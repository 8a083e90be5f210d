#include "engine/record/constraint_errors.h"

#include <algorithm>

#include "engine/contacts/contacts.h"
#include "tests/engine/prelude.h"

/// The largest errors of constraints against those of the states and contacts of a run.

namespace {

using engine::Pair;

/// A crate on the ground with a hundred times its mass on it.
SimulationSpec pressed_crate() {
  BodySpec crate = support::box_body("crate", {1, 1, 1}, 100, {0, 0, 0.35});
  BodySpec block = support::box_body("block", {1, 1, 1}, 10000, {0, 0, 1.35});
  crate.collision = block.collision = CollisionShape::box;
  SimulationSpec spec = support::dry_world({crate, block}, 1.0 / 60);
  spec.ground = engine::PlaneGround{0};
  return spec;
}

TEST(ConstraintErrors, OfContactsAreTheDeepestOverlapOfEachPair) {
  for (const auto method : {engine::Integrator::Method::split, engine::Integrator::Method::ode}) {
    SimulationSpec spec = pressed_crate();
    spec.integrator.method = method;
    Simulation simulation(std::move(spec));
    for (int i = 0; i < 120; ++i) simulation.step();
    const auto& overlaps = simulation.constraint_errors().overlaps;
    ASSERT_TRUE(overlaps.contains(Pair(kWorld, 0)));
    ASSERT_TRUE(overlaps.contains(Pair(0, 1)));
    const engine::Peak& ground = overlaps.at(Pair(kWorld, 0));
    EXPECT_NEAR(ground.value, 0.15, tolerance(2e-3)) << "as deep as it begins";
    EXPECT_LT(overlaps.at(Pair(0, 1)).value, ground.value / 5);
    EXPECT_GE(ground.time, 0);
    EXPECT_LT(ground.time, simulation.spec().step);
  }
}

TEST(ConstraintErrors, OfContactsAreThoseOfThePairsInAStep) {
  using engine::Contact;
  std::vector<Contact> contacts(5);
  contacts[0] = {.pair = {kWorld, 0}, .point = {.depth = 0.1}};
  contacts[1] = {.pair = {kWorld, 0}, .point = {.depth = 0.3}};
  contacts[2] = {.pair = {0, 1}, .point = {.depth = 0.2}};
  contacts[3] = {.pair = {0, 1}, .point = {.depth = 0.1}};
  contacts[4] = {.pair = {1, 2}, .point = {.depth = 0.4}};
  std::vector<engine::Overlap> overlaps;
  engine::add_overlaps(contacts, 7, overlaps);
  engine::ConstraintErrors errors;
  errors.add(overlaps);
  contacts.resize(2);
  contacts[1].point.depth = 0.5;
  overlaps.clear();
  engine::add_overlaps(contacts, 8, overlaps);
  ASSERT_EQ(overlaps.size(), 1u);
  errors.add(overlaps);
  ASSERT_EQ(errors.overlaps.size(), 3u);
  EXPECT_EQ(errors.overlaps[Pair(kWorld, 0)].value, 0.5);
  EXPECT_EQ(errors.overlaps[Pair(kWorld, 0)].time, 8);
  EXPECT_EQ(errors.overlaps[Pair(0, 1)].value, 0.2);
  EXPECT_EQ(errors.overlaps[Pair(1, 2)].value, 0.4);
  EXPECT_EQ(errors.overlaps[Pair(1, 2)].time, 7);
}

/// Two boxes on a ball joint that spin fast about different axes, and one on a hinge to the world.
SimulationSpec spinning_chain() {
  SimulationSpec spec = support::dry_world({support::box_body("a", {1, 0.4, 0.2}, 500, {0, 0, 0}),
                                            support::box_body("b", {1, 0.4, 0.2}, 500, {1, 0, 0}),
                                            support::box_body("c", {1, 0.4, 0.2}, 500, {0, 9, 0})},
                                           0.05);
  spec.bodies[0].initial.angular_velocity = {3, 4, 9};
  spec.bodies[1].initial.angular_velocity = {-5, 2, 4};
  spec.joints = {{.first = 0, .second = 1, .anchor_W = {0.5, 0, 0}},
                 {.type = JointSpec::Type::hinge,
                  .first = 2,
                  .anchor_W = {-0.5, 9, 0},
                  .axis_W = Vector3d::UnitY()}};
  return spec;
}

TEST(ConstraintErrors, OfAJointAreTheLargestOfTheStatesOfARun) {
  Simulation simulation(spinning_chain());
  double apart = 0, when = 0;
  for (int i = 0; i < 60; ++i) {
    simulation.step();
    const BodyState& a = simulation.states()[0];
    const BodyState& b = simulation.states()[1];
    const double now = (a.position + a.orientation * Vector3d(0.5, 0, 0) - b.position -
                        b.orientation * Vector3d(-0.5, 0, 0))
                           .norm();
    if (now <= apart) continue;
    apart = now;
    when = simulation.time();
  }
  const std::vector<engine::JointError>& joints = simulation.constraint_errors().joints;
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_GT(apart, 0);  // round-off
  EXPECT_NEAR(joints[0].separation.value, apart, tolerance(1e-14));
  EXPECT_EQ(joints[0].separation.time, when);
  EXPECT_EQ(joints[0].turn.value, 0);
  // A joint to the world is solved in its own coordinates.
  EXPECT_LT(joints[1].separation.value, tolerance(1e-12));
  EXPECT_LT(joints[1].turn.value, tolerance(1e-12));
}

TEST(ConstraintErrors, StartAnewWithTheSimulation) {
  for (const SimulationSpec& spec : {pressed_crate(), spinning_chain()}) {
    Simulation simulation(spec);
    for (int i = 0; i < 30; ++i) simulation.step();
    simulation.reset();
    const engine::ConstraintErrors& errors = simulation.constraint_errors();
    EXPECT_TRUE(errors.overlaps.empty());
    ASSERT_EQ(errors.joints.size(), spec.joints.size());
    for (const engine::JointError& joint : errors.joints) EXPECT_EQ(joint.separation.value, 0);
  }
}

}  // namespace

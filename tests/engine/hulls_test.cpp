#include "engine/motion/hulls.h"

#include <gtest/gtest.h>

#include "engine/simulation.h"
#include "hydro/mesh/primitives.h"

namespace {

using engine::BodySpec;
using engine::Hulls;
using engine::Simulation;
using engine::SimulationSpec;

BodySpec ball(double radius) {
  BodySpec body{.name = "ball", .mesh_B = hydro::make_icosphere(radius, 2)};
  body.mass = 2000;
  body.initial.position.z() = 0.3;
  return body;
}

TEST(Hulls, OfOneMeshAreOne) {
  Hulls hulls;
  const auto first = hulls.of(ball(1));
  EXPECT_EQ(hulls.of(ball(1)), first);
  EXPECT_NE(hulls.of(ball(1.1)), first);
  BodySpec with_its_own = ball(1.1);
  with_its_own.hull = first;
  EXPECT_EQ(hulls.of(with_its_own), first);
}

TEST(Hulls, ThatAreKeptAreOfWetBodiesAndChangeNoMotion) {
  SimulationSpec spec{.sea = hydro::Sea(), .bodies = {ball(1), ball(1)}};
  spec.bodies[1].name = "dry";
  spec.bodies[1].wet = false;
  spec.bodies[1].initial.position.x() = 9;
  SimulationSpec kept = spec;
  Hulls hulls;
  engine::keep_hulls(kept, hulls);
  EXPECT_NE(kept.bodies[0].hull, nullptr);
  EXPECT_EQ(kept.bodies[1].hull, nullptr);
  Simulation plain(spec), sharing(kept), another(kept);
  for (int i = 0; i < 60; ++i) {
    plain.step();
    sharing.step();
    another.step();
  }
  EXPECT_EQ(sharing.states(), plain.states());
  EXPECT_EQ(another.states(), plain.states());
}

}  // namespace

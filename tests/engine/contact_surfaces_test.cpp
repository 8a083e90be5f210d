#include "engine/contacts/contact_surfaces.h"

#include <functional>

#include "tests/engine/prelude.h"

namespace {

using engine::ContactSpec;
using engine::ContactSurfaces;
using engine::Surface;

/// Two boxes of these surfaces; the ground has the third.
SimulationSpec surfaces(const Surface& a, const Surface& b, const Surface& ground) {
  SimulationSpec spec = support::dry_world({support::box_body("a", {1, 1, 1}, 500, {0, 0, 0.5}),
                                            support::box_body("b", {1, 1, 1}, 500, {3, 0, 0.5})},
                                           kStep);
  spec.ground = engine::PlaneGround{0};
  spec.ground_friction = ground.friction;
  spec.ground_restitution = ground.restitution;
  spec.bodies[0].friction = a.friction;
  spec.bodies[0].restitution = a.restitution;
  spec.bodies[1].friction = b.friction;
  spec.bodies[1].restitution = b.restitution;
  return spec;
}

TEST(ContactSurfaces, CombineToTheMeanFrictionAndTheLargerRestitution) {
  const ContactSurfaces pairs(surfaces({0.2, 0.1}, {0.8, 0.6}, {0.05, 0.3}));
  EXPECT_NEAR(pairs.between({0, 1}).friction, 0.4, tolerance(1e-15));
  EXPECT_EQ(pairs.between({0, 1}).restitution, 0.6);
  EXPECT_NEAR(pairs.between({kWorld, 0}).friction, 0.1, tolerance(1e-15));
  EXPECT_EQ(pairs.between({kWorld, 0}).restitution, 0.3);
}

TEST(ContactSurfaces, OfEqualFrictionHaveExactlyThat) {
  const Surface usual;
  const ContactSurfaces pairs(surfaces(usual, usual, usual));
  EXPECT_EQ(pairs.between({0, 1}).friction, engine::kFriction);
  EXPECT_EQ(pairs.between({kWorld, 1}).restitution, 0);
}

TEST(ContactSurfaces, OfAPairGoOverThoseOfItsBodies) {
  SimulationSpec spec = surfaces({0.2, 0.1}, {0.8, 0.6}, {0.05, 0.3});
  spec.contacts = {{.first = 1, .second = 0, .friction = 0.7, .restitution = {}},
                   {.first = kWorld, .second = 1, .friction = {}, .restitution = 0}};
  const ContactSurfaces pairs(spec);
  EXPECT_EQ(pairs.between({0, 1}).friction, 0.7);
  EXPECT_EQ(pairs.between({0, 1}).restitution, 0.6);
  EXPECT_NEAR(pairs.between({kWorld, 1}).friction, 0.2, tolerance(1e-15));
  EXPECT_EQ(pairs.between({kWorld, 1}).restitution, 0);
  EXPECT_EQ(pairs.between({kWorld, 0}).restitution, 0.3);
}

TEST(ContactSurfaces, OutOfBoundsAreRefused) {
  const Surface usual;
  const auto refuses = [&](const auto& change) {
    SimulationSpec spec = surfaces(usual, usual, usual);
    change(spec);
    EXPECT_THROW(ContactSurfaces{spec}, std::invalid_argument);
  };
  const auto contact = [](BodyId first, BodyId second) {
    return ContactSpec{.first = first, .second = second, .friction = 0.1, .restitution = {}};
  };
  refuses([](auto& spec) { spec.bodies[1].friction = -0.1; });
  refuses([](auto& spec) { spec.bodies[1].friction = NAN; });
  refuses([](auto& spec) { spec.ground_restitution = 1.01; });
  refuses([&](auto& spec) { spec.contacts = {contact(0, 2)}; });
  refuses([&](auto& spec) { spec.contacts = {contact(1, 1)}; });
  refuses([&](auto& spec) { spec.contacts = {contact(0, 1), contact(1, 0)}; });
}

/// The acceleration of a slab down a slope in its first second, friction given by `change`.
double sliding(double angle, double heading, const std::function<void(SimulationSpec&)>& change) {
  const Quaterniond tilt = support::lying_on_slope(angle, heading);
  const Vector3d down = tilt * Vector3d(std::cos(heading), std::sin(heading), 0);
  BodySpec slab = support::box_body("slab", {1, 1, 0.4}, 500, tilt * Vector3d(0, 0, 0.2));
  slab.initial.orientation = tilt;
  slab.collision = CollisionShape::box;
  SimulationSpec spec = support::dry_world({slab}, kStep);
  spec.ground = support::slope(angle, heading, 1);
  change(spec);
  // The slab first sinks in, so its acceleration is that after the first half second.
  Simulation simulation = support::after(spec, 50);
  const double then = simulation.states()[0].linear_velocity.dot(down);
  for (int i = 0; i < 50; ++i) simulation.step();
  return (simulation.states()[0].linear_velocity.dot(down) - then) / 0.5;
}

TEST(Friction, OfBodyGroundAndPairSetsTheAccelerationDownASlope) {
  const double angle = 0.5;
  const auto expected = [&](double mu) {
    return kGravity * (std::sin(angle) - mu * std::cos(angle));
  };
  for (const double heading : {0.0, 0.4}) {
    // Friction follows the load of the step before.
    EXPECT_NEAR(sliding(angle, heading, [](auto& spec) { spec.bodies[0].friction = 0; }),
                expected(0), tolerance(0.01));
    EXPECT_NEAR(sliding(angle, heading,
                        [](auto& spec) {
                          spec.bodies[0].friction = 0.1;
                          spec.ground_friction = 0.4;
                        }),
                expected(0.2), tolerance(0.01));
    EXPECT_NEAR(sliding(angle, heading,
                        [](auto& spec) {
                          spec.contacts = {
                              {.first = 0, .second = kWorld, .friction = 0.3, .restitution = {}}};
                        }),
                expected(0.3), tolerance(0.01));
    EXPECT_NEAR(sliding(angle, heading, [](auto& spec) { spec.bodies[0].friction = 2; }), 0,
                tolerance(0.01));
  }
}

}  // namespace

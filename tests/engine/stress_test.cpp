#include "engine/contacts/world.h"
#include "tests/engine/prelude.h"
#include "tests/support/repeats.h"

namespace {

using engine::World;

constexpr int kBodies = 8;

/// Overlapping boxes of masses up to `ratio` apart, locked at random and joined by joints that hold
/// the same motions more than once, on the ground.
SimulationSpec tangle(unsigned seed, double ratio) {
  support::Random random(seed);
  SimulationSpec spec = support::dry_world({}, kStep);
  spec.ground = engine::PlaneGround{0};
  for (int i = 0; i < kBodies; ++i) {
    const double density = std::pow(ratio, random.uniform(0, 1));
    BodySpec body = support::box_body("body", {1, 1, 1}, density, random.vector(0.5));
    body.initial.position.z() = 0.4 + 0.9 * i;
    body.collision = seed % 2 ? CollisionShape::box : CollisionShape::mesh;
    for (bool& lock : body.locked) lock = random.uniform(0, 1) < 0.2;
    spec.bodies.push_back(body);
  }
  for (int i = 0; i < 10; ++i) {
    const auto first = static_cast<BodyId>(random.uniform(0, kBodies));
    const auto second = static_cast<BodyId>(random.uniform(0, kBodies));
    const auto type = static_cast<JointSpec::Type>(static_cast<int>(random.uniform(0, 5)));
    if (first == second) continue;
    spec.joints.push_back(
        {.type = type, .first = first, .second = second, .anchor_W = random.vector(2)});
  }
  return spec;
}

TEST(Stress, ContradictoryConstraintsDoNotEndASimulation) {
  for (unsigned seed = 1; seed <= static_cast<unsigned>(support::repeats(12)); ++seed) {
    SCOPED_TRACE(seed);
    EXPECT_NO_THROW(support::after(tangle(seed, 1e5), support::repeats(200)));
  }
}

TEST(Stress, AStepThatTheExactSolverGivesUpIsStillTaken) {
  bool compromised = false;
  for (unsigned seed = 1; !compromised; ++seed) {
    ASSERT_LE(seed, 60U) << "no world was contradictory enough";
    const SimulationSpec spec = tangle(seed, 1e12);
    World world(spec.gravity);
    for (const BodySpec& body : spec.bodies) world.add_body(body);
    for (const JointSpec& joint : spec.joints) world.add_joint(joint);
    world.add_ground(spec.ground);
    try {
      for (int i = 0; i < 200 && !compromised; ++i) {
        world.collide(kStep);
        compromised = world.advance(kStep);
      }
    } catch (const engine::OdeFault&) {
      continue;  // beyond what either solver can do
    }
    for (BodyId id = 0; id < kBodies; ++id) EXPECT_TRUE(world.state(id).position.allFinite());
  }
}

}  // namespace

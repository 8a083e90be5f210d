#include "tests/engine/prelude.h"

namespace {

BodySpec crate(const Vector3d& position, CollisionShape shape) {
  BodySpec body = support::box_body("crate", {1, 1, 1}, 300, position);
  body.collision = shape;
  return body;
}

SimulationSpec on_flat_ground(const std::vector<BodySpec>& bodies) {
  SimulationSpec spec = support::dry_world(bodies, kStep);
  spec.ground = engine::PlaneGround{0};
  return spec;
}

double fastest(const Simulation& simulation) {
  double speed = 0;
  for (const hydro::BodyState& state : simulation.states()) {
    speed = std::max(speed, state.linear_velocity.norm());
  }
  return speed;
}

TEST(Stack, OfFiveCratesStandsForTwentySeconds) {
  for (const CollisionShape shape : {CollisionShape::box, CollisionShape::mesh}) {
    std::vector<BodySpec> crates;
    for (int i = 0; i < 5; ++i) {
      crates.push_back(crate({0.03 * (i % 2), -0.02 * (i % 3), 0.505 + 1.005 * i}, shape));
    }
    const Simulation simulation =
        support::after(on_flat_ground(crates), support::steps_in(support::repeats(20), kStep));
    for (std::size_t i = 0; i < crates.size(); ++i) {
      const hydro::BodyState& state = simulation.states()[i];
      const Vector3d moved = state.position - crates[i].initial.position;
      // Meshes report a flat contact by points that change from step to step, so that landing
      // shifts a crate by some centimetres before friction holds it.
      EXPECT_LT(std::hypot(moved.x(), moved.y()), tolerance(0.05));
      // The ground bears five crates and sinks in by 5 g τ², the next contact bears four.
      const double n = static_cast<double>(i);
      const double sink = support::kGravity * 1e-4 * (n + 1) * (10 - n) / 2;
      EXPECT_NEAR(state.position.z(), 0.5 + n - sink, tolerance(3e-3));
    }
    // They also make a stack of meshes tremble, at speeds up to 0.04 m/s.
    EXPECT_LT(fastest(simulation), tolerance(shape == CollisionShape::mesh ? 0.05 : 0.02));
  }
}

// More contacts than are solved for directly; what an iteration leaves undone would let the lower
// ones sink in.
TEST(Stack, OfNineCratesStandsByIteration) {
  constexpr int kCrates = 9;
  std::vector<BodySpec> crates;
  for (int i = 0; i < kCrates; ++i)
    crates.push_back(crate({0.03 * (i % 2), -0.02 * (i % 3), 0.5 + i}, CollisionShape::box));
  const Simulation simulation = support::after(on_flat_ground(crates), support::steps_in(5, kStep));
  // Each contact sinks in by what it carries, k crates by k g τ².
  const double sink = support::kGravity * 1e-4 * kCrates * (kCrates + 1) / 2;
  const hydro::BodyState& top = simulation.states().back();
  EXPECT_NEAR(top.position.z(), kCrates - 0.5 - sink, tolerance(1e-3));
  EXPECT_LT(std::hypot(top.position.x(), top.position.y() + 0.04), tolerance(0.05));
  EXPECT_LT(fastest(simulation), tolerance(0.02));
}

// A contact that gave way under what rests on it would let the stack lean, and fall in 18 s.
TEST(Stack, OfTenCratesStandsForAMinute) {
  constexpr int kCrates = 10;
  std::vector<BodySpec> crates;
  for (int i = 0; i < kCrates; ++i)
    crates.push_back(crate({0, 0, 0.5 + 1.001 * i}, CollisionShape::box));
  SimulationSpec spec = on_flat_ground(crates);
  spec.step = 1.0 / 240;
  const Simulation simulation = support::after(spec, support::steps_in(60, spec.step));
  const double sink = support::kGravity * 1e-4 * kCrates * (kCrates + 1) / 2;
  const hydro::BodyState& top = simulation.states().back();
  EXPECT_NEAR(top.position.z(), kCrates - 0.5 - sink, tolerance(1e-4));
  EXPECT_LT(std::hypot(top.position.x(), top.position.y()), tolerance(1e-5));
}

// (E13a) gives 12.6 crates. They begin on a parabola that is off by a millimetre at the top.
TEST(Stack, BendsUnderItsOwnWeightAsAColumnOfSoftJointsDoes) {
  const auto leans = [](int count) {
    std::vector<BodySpec> crates;
    for (int i = 0; i < count; ++i)
      crates.push_back(
          crate({1e-3 * std::pow(1.0 * i / count, 2), 0, 0.5 + i}, CollisionShape::box));
    SimulationSpec spec = on_flat_ground(crates);
    spec.step = 0.01;
    return support::after(spec, 1000).states().back().position.x();
  };
  EXPECT_LT(leans(11), tolerance(0.02));
  EXPECT_GT(leans(14), 0.2);
}

// Flat faces that meet edge on edge have no sound contact points at first, only deep sideways ones.
TEST(Stack, OfAlignedCratesIsNotThrownApartAsItCloses) {
  std::vector<BodySpec> crates;
  for (int i = 0; i < 3; ++i)
    crates.push_back(crate({0, 0, 0.5 + 1.001 * i}, CollisionShape::mesh));
  SimulationSpec spec = on_flat_ground(crates);
  spec.step = 0.001;
  Simulation simulation(spec);
  for (int i = 0; i < 500; ++i) {
    simulation.step();
    // No more than the fall through both gaps and the contacts' sinking in.
    EXPECT_LT(fastest(simulation), std::sqrt(2 * support::kGravity * 0.005)) << "step " << i;
  }
}

TEST(Pile, OfTwentySevenCratesSettles) {
  for (const CollisionShape shape : {CollisionShape::box, CollisionShape::mesh}) {
    std::vector<BodySpec> crates;
    for (int i = 0; i < 27; ++i) {
      const int layer = i / 9;
      crates.push_back(crate(
          {1.05 * (i % 3) + 0.02 * layer, 1.05 * (i / 3 % 3) - 0.03 * layer, 0.51 + 1.01 * layer},
          shape));
    }
    const Simulation simulation =
        support::after(on_flat_ground(crates), support::steps_in(5, kStep));
    EXPECT_LT(fastest(simulation), tolerance(0.02));
    for (std::size_t i = 0; i < crates.size(); ++i) {
      const Vector3d moved = simulation.states()[i].position - crates[i].initial.position;
      EXPECT_LT(moved.norm(), tolerance(0.1));
    }
  }
}

/// Crates that fall on each other from up to 40 m.
SimulationSpec heap(CollisionShape shape) {
  std::vector<BodySpec> crates;
  for (int i = 0; i < 27; ++i) {
    crates.push_back(crate({0.4 * (i % 3), 0.4 * (i / 3 % 3), 1 + 1.5 * i}, shape));
  }
  return on_flat_ground(crates);
}

TEST(Heap, OfFallenCratesGainsNoEnergyAndStaysAboveGround) {
  for (const CollisionShape shape : {CollisionShape::box, CollisionShape::mesh}) {
    Simulation simulation(heap(shape));
    const double start = support::energy(simulation.spec(), simulation.states());
    for (long i = 0; i < support::steps_in(support::repeats(6), kStep); ++i) {
      simulation.step();
      ASSERT_LE(support::energy(simulation.spec(), simulation.states()), start);
    }
    for (const hydro::BodyState& state : simulation.states()) EXPECT_GT(state.position.z(), 0.45);
  }
}

TEST(Heap, OfManyContactsTakesTheSameWayTwice) {
  const int steps = support::repeats(500);
  const Simulation first = support::after(heap(CollisionShape::mesh), steps);
  const Simulation second = support::after(heap(CollisionShape::mesh), steps);
  for (std::size_t i = 0; i < first.states().size(); ++i) {
    EXPECT_EQ(first.states()[i].position, second.states()[i].position);
    EXPECT_EQ(first.states()[i].orientation.coeffs(), second.states()[i].orientation.coeffs());
  }
}

}  // namespace

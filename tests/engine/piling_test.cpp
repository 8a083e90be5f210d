#include "engine/base/constants.h"
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

// Depth of rest of a contact of crates of 1 m.
constexpr double kDepthAtRest = engine::kContactDepth;

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
      const double n = static_cast<double>(i);
      EXPECT_NEAR(state.position.z(), 0.5 + n - (n + 1) * kDepthAtRest, tolerance(3e-3));
    }
    // They also make a stack of meshes tremble, at speeds up to 0.04 m/s.
    EXPECT_LT(fastest(simulation), tolerance(shape == CollisionShape::mesh ? 0.05 : 0.02));
  }
}

// What a solution that is not exact leaves undone would let the lower ones sink in and creep.
TEST(Stack, OfFortyCratesStandsAsOneOfTwoDoes) {
  constexpr int kCrates = 40;
  std::vector<BodySpec> crates;
  for (int i = 0; i < kCrates; ++i)
    crates.push_back(crate({0.03 * (i % 2), -0.02 * (i % 3), 0.5 + i}, CollisionShape::box));
  const Simulation simulation = support::after(on_flat_ground(crates), support::steps_in(5, kStep));
  const hydro::BodyState& top = simulation.states().back();
  EXPECT_NEAR(top.position.z(), kCrates - 0.5 - kCrates * kDepthAtRest, tolerance(1e-3));
  EXPECT_LT(std::hypot(top.position.x() - 0.03, top.position.y()), tolerance(5e-3));
  EXPECT_LT(fastest(simulation), tolerance(1e-3));
}

// All crates of a stack fall together, so only the stop of each lets the next one meet it.
TEST(Stack, LandsAsOneFromAnyGapBetweenItsCrates) {
  constexpr int kCrates = 20;
  for (const double gap : {0.0, 1e-5, 1e-3, 1e-2})
    for (const double step : {1.0 / 100, 1.0 / 60}) {
      std::vector<BodySpec> crates;
      for (int i = 0; i < kCrates; ++i)
        crates.push_back(
            crate({0.03 * (i % 2), -0.02 * (i % 3), 0.5 + i * (1 + gap)}, CollisionShape::box));
      SimulationSpec spec = on_flat_ground(crates);
      spec.step = step;
      Simulation simulation(spec);
      double highest = 0, lowest = kCrates;
      for (int i = 0; i < support::steps_in(1, step); ++i) {
        simulation.step();
        const double top = simulation.states().back().position.z();
        highest = std::max(highest, top);
        lowest = std::min(lowest, top);
      }
      const double start = crates.back().initial.position.z();
      const double rest = kCrates - 0.5 - kCrates * kDepthAtRest;
      EXPECT_LE(highest, start) << gap << ' ' << step;
      // The first contact is found half a step late.
      EXPECT_NEAR(lowest, rest, tolerance(2e-3)) << gap << ' ' << step;
    }
}

// A contact that gave way under what rests on it would let the stack sink, lean and fall. One of
// crates of 0.2 m has its contacts five times nearer to each other.
TEST(Stack, OfTenCratesStandsForAMinute) {
  constexpr int kCrates = 10;
  for (const double edge : {1.0, 0.2})
    for (const double step : {1.0 / 60, 1.0 / 240}) {
      std::vector<BodySpec> crates;
      for (int i = 0; i < kCrates; ++i) {
        crates.push_back(support::box_body("crate", Vector3d::Constant(edge), 300,
                                           {0, 0, edge * (0.5 + 1.001 * i)}));
        crates.back().collision = CollisionShape::box;
      }
      SimulationSpec spec = on_flat_ground(crates);
      spec.step = step;
      const Simulation simulation = support::after(spec, support::steps_in(60, step));
      const hydro::BodyState& top = simulation.states().back();
      EXPECT_NEAR(top.position.z() / edge, kCrates - 0.5 - kCrates * kDepthAtRest, tolerance(1e-3));
      EXPECT_LT(std::hypot(top.position.x(), top.position.y()) / edge, tolerance(1e-3));
    }
}

// It would not if a contact were a spring for the weight of the lower one.
TEST(Stack, OfACrateUnderAHundredAndAThousandTimesItsWeightStands) {
  for (const double ratio : {100.0, 1000.0})
    for (const double step : {1.0 / 15, 1.0 / 60, 1.0 / 240}) {
      if (ratio * step > 20) continue;  // that hops by 2 % of the crate
      BodySpec heavy = support::box_body("heavy", {1, 1, 1}, 300 * ratio, {0, 0, 1.5});
      heavy.collision = CollisionShape::box;
      SimulationSpec spec = on_flat_ground({crate({0, 0, 0.5}, CollisionShape::box), heavy});
      spec.step = step;
      const Simulation simulation = support::after(spec, support::steps_in(5, step));
      for (int i = 0; i < 2; ++i)  // Each contact gives way by at most 1 % of the crate.
        EXPECT_NEAR(simulation.states()[i].position.z(), 0.5 + i, tolerance(0.01 * (i + 1)))
            << ratio << ' ' << step;
    }
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
    EXPECT_LT(fastest(simulation), tolerance(0.03));
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

#include "engine/base/constants.h"
#include "hydro/airy_waves.h"
#include "tests/engine/prelude.h"
#include "tests/support/hollows.h"

/// Air that is trapped in the voids of hollow bodies.

namespace {

using engine::kAtmosphere;

constexpr double kFreshWater = 1000;       // Density of the water [kg/m^3].
constexpr double kVoid = 1.9 * 0.9 * 0.9;  // Volume of the closed box's void [m^3].
constexpr double kWeight = kFreshWater * kGravity;

const engine::Opening kBottom = {.at_B = {0.6, 0, -0.475}, .area = 2e-3};
const engine::Opening kTop = {.at_B = {-0.6, 0, 0.475}, .area = 2e-3};

/// The closed box in still water, whose centre of mass is in its middle, at a height of that.
SimulationSpec closed_box(double height, std::vector<engine::Opening> openings) {
  BodySpec box;
  box.name = "box";
  box.mesh_B = hydro::translated(support::closed_box(), {0, 0, -0.5});
  box.mass = 500;
  box.inertia_B = Vector3d(60, 160, 170).asDiagonal();
  box.interior = engine::Interior::flooding;
  box.air = true;
  box.openings = std::move(openings);
  box.collision = CollisionShape::none;
  box.coefficients = hydro::for_mesh({}, box.mesh_B, 1e-6);
  box.initial.position.z() = height;
  SimulationSpec spec = support::dry_world({std::move(box)}, 1.0 / 60);
  spec.sea = hydro::Sea{.density = kFreshWater, .gravity = kGravity};
  return spec;
}

SimulationSpec held(SimulationSpec spec) {
  spec.bodies[0].locked = engine::kAllDofs;
  return spec;
}

engine::PocketState after(Simulation& simulation, double seconds) {
  const long steps = support::steps_in(seconds, simulation.spec().step);
  for (long i = 0; i < steps; ++i) simulation.step();
  return simulation.interiors()[0].pockets[0];
}

// The water rises until p₀ V₀/V = p₀ + ρg (0 − level), with V = V₀ − 1.9·0.9·(level − floor).
TEST(TrappedAir, InABellIsCompressedByBoylesLaw) {
  for (const double height : {-0.4, -3.0, -20.0, -200.0}) {
    Simulation simulation(held(closed_box(height, {kBottom})));
    const engine::PocketState pocket = after(simulation, 600);
    const double air = kVoid - pocket.volume;
    EXPECT_NEAR(pocket.air * air, kAtmosphere * kVoid, 1e-10 * kAtmosphere * kVoid);
    EXPECT_NEAR(pocket.level, height - 0.45 + pocket.volume / (1.9 * 0.9), 1e-9);
    EXPECT_NEAR(kAtmosphere - kWeight * pocket.level, pocket.air, 1e-6 * pocket.air) << height;
  }
}

// A bell under a tide of 4 m: it comes down in 300 s.
TEST(TrappedAir, PushesTheWaterOutAgainAsThePressureFalls) {
  constexpr double period = 600, amplitude = 2;
  SimulationSpec spec = held(closed_box(-2.2, {kBottom}));
  const double rate = 2 * M_PI / period;
  spec.sea->surface = hydro::WaveSurface{
      {hydro::deep_water_wave(amplitude, 2 * M_PI * kGravity / (rate * rate), 0, 0, kGravity)}};
  Simulation simulation(spec);
  const double high = after(simulation, 20).volume;
  const engine::PocketState pocket = after(simulation, period / 2 - 20);
  EXPECT_LT(pocket.volume, 0.5 * high);
  EXPECT_NEAR(pocket.air, kAtmosphere + kWeight * (-amplitude - pocket.level), 1e-3 * kAtmosphere);
  EXPECT_NEAR(pocket.air * (kVoid - pocket.volume), kAtmosphere * kVoid,
              1e-10 * kAtmosphere * kVoid);
}

TEST(TrappedAir, LeavesThroughAnOpeningToTheAtmosphere) {
  for (const bool air : {true, false}) {
    SimulationSpec spec = held(closed_box(0.1, {kBottom, kTop}));
    spec.bodies[0].air = air;
    Simulation simulation(spec);
    const engine::PocketState pocket = after(simulation, 600);
    EXPECT_NEAR(pocket.level, 0, 1e-6) << air;
    EXPECT_EQ(std::isnan(pocket.air), !air);
    EXPECT_FALSE(std::abs(pocket.air - kAtmosphere) > 1e-9 * kAtmosphere);
  }
}

// While the air can leave, it makes no difference to what runs in.
TEST(TrappedAir, ThatCanLeaveHoldsNothingUp) {
  double volume[2];
  for (const bool air : {true, false}) {
    SimulationSpec spec = held(closed_box(0.1, {kBottom, kTop}));
    spec.bodies[0].air = air;
    Simulation simulation(spec);
    volume[air] = after(simulation, 30).volume;
  }
  EXPECT_NEAR(volume[1], volume[0], 1e-3 * volume[0]);
  EXPECT_LT(volume[0], 0.9 * 1.9 * 0.9 * 0.35);
}

TEST(TrappedAir, LeavesAsBubblesThroughAnOpeningBelowTheSurface) {
  Simulation simulation(held(closed_box(-2, {kBottom, kTop})));
  const engine::PocketState pocket = after(simulation, 900);
  // The upper opening is in the middle of the deck; water stands up to it.
  EXPECT_NEAR(pocket.volume, kVoid, 1e-6 * kVoid);
}

TEST(TrappedAir, KeepsAFloatAfloatThatWouldSink) {
  for (const bool air : {true, false}) {
    SimulationSpec spec = closed_box(0.2, {kBottom});
    spec.bodies[0].locked = {true, true, false, true, true, true};
    spec.bodies[0].mass = 1200;
    spec.bodies[0].air = air;
    Simulation simulation(spec);
    after(simulation, 600);
    EXPECT_EQ(simulation.states()[0].position.z() > -0.5, air);
  }
}

// What the air gives back as the float rises is no energy out of nothing: nothing slows the float.
// It still bobs by a millimetre or two.
TEST(TrappedAir, LetsAFloatComeToItsRest) {
  SimulationSpec spec = closed_box(0.3, {{.at_B = {0.6, 0, -0.475}, .area = 0.1}});
  spec.bodies[0].locked = {true, true, false, true, true, true};
  spec.bodies[0].mass = 1200;
  Simulation simulation(spec);
  const double water = after(simulation, 120).volume;
  const double z = simulation.states()[0].position.z();
  EXPECT_EQ(simulation.counts()[0].clamped, 0);
  EXPECT_NEAR(kFreshWater * 2 * (0.5 - z), 1200 + kFreshWater * water, 5);
}

/// The closed box with a bulkhead from bottom to deck.
SimulationSpec two_voids(double height, std::vector<engine::Opening> openings) {
  SimulationSpec spec = closed_box(height, std::move(openings));
  spec.bodies[0].mesh_B = hydro::translated(
      support::blocks(
          {{{-1, -0.95, -0.025, 0.025, 0.95, 1}, {-0.5, -0.45, 0.45, 0.5}, {0, 0.05, 0.95, 1}}},
          [](int i, int j, int k) { return i == 0 || i == 2 || i == 4 || j != 1 || k != 1; }),
      {0, 0, -0.5});
  return spec;
}

TEST(TrappedAir, SharesItsPressureThroughAnOpeningAboveTheWater) {
  Simulation simulation(held(two_voids(-5, {kBottom, {.at_B = {0, 0, 0.4}, .area = 1e-3}})));
  after(simulation, 600);
  const auto pockets = simulation.interiors()[0].pockets;
  ASSERT_EQ(pockets.size(), 2u);
  EXPECT_NEAR(pockets[0].air, pockets[1].air, 1e-9 * kAtmosphere);
  double air = 0;
  for (const engine::PocketState& pocket : pockets)
    air += pocket.air * (0.925 * 0.9 * 0.9 - pocket.volume);
  EXPECT_NEAR(air, kAtmosphere * 2 * 0.925 * 0.9 * 0.9, 1e-9 * kAtmosphere);
  EXPECT_EQ(std::min(pockets[0].volume, pockets[1].volume), 0);
  const double level = std::isnan(pockets[0].level) ? pockets[1].level : pockets[0].level;
  EXPECT_NEAR(kAtmosphere - kWeight * level, pockets[0].air, 1e-6 * kAtmosphere);
}

TEST(TrappedAir, IsPumpedAgainstUntilItsPressureHoldsThePump) {
  constexpr double head = 4;
  SimulationSpec spec = held(closed_box(0.2, {}));
  spec.bodies[0].pumps = {{.from_B = {3, 0, -1}, .to_B = Vector3d(0, 0, -0.4), .head = head}};
  spec.set_points = {{.name = "pumps[p].rate", .initial = 0.01}};
  Simulation simulation(spec);
  const engine::PocketState pocket = after(simulation, 300);
  const double lift = pocket.level + (pocket.air - kAtmosphere) / kWeight;
  EXPECT_NEAR(lift, head, 1e-3);
}

TEST(TrappedAir, IsPartOfTheState) {
  Simulation simulation(held(closed_box(-3, {kBottom})));
  after(simulation, 5);
  const engine::SimulationState state = simulation.state();
  const double volume = after(simulation, 5).volume;
  simulation.restore(state);
  EXPECT_EQ(after(simulation, 5).volume, volume);
}

}  // namespace

#include "engine/hollows/streams.h"
#include "tests/engine/prelude.h"
#include "tests/support/hollows.h"

/// Pumps that empty and fill hollow bodies.

namespace {

constexpr double kFreshWater = 1000;  // Density of the water [kg/m^3].
constexpr double kFloor = 1.9 * 0.9;  // Area of the open box's floor [m^2].

/// An open box of 400 kg, or another hull of its size, in still water, with a pump. The centre of
/// mass is half a metre above its bottom.
SimulationSpec pumped(const engine::PumpSpec& pump, double rate, double water, double draught,
                      const hydro::TriMesh& mesh = support::open_box()) {
  BodySpec box;
  box.name = "box";
  box.mesh_B = hydro::translated(mesh, {0, 0, -0.5});
  box.mass = 400;
  box.inertia_B = Vector3d(60, 160, 170).asDiagonal();
  box.interior = engine::Interior::flooding;
  box.collision = CollisionShape::none;
  box.coefficients = hydro::for_mesh({}, box.mesh_B, 1e-6);
  box.initial.position.z() = 0.5 - draught;
  if (water > 0) box.interior_water = {{.at_B = {-0.5, 0, -0.4}, .volume = water}};
  box.pumps = {pump};
  SimulationSpec spec = support::dry_world({std::move(box)}, 1.0 / 60);
  spec.sea = hydro::Sea{.density = kFreshWater, .gravity = kGravity};
  spec.set_points = {{.name = "pumps[p].rate", .initial = rate}};
  return spec;
}

SimulationSpec held(SimulationSpec spec) {
  spec.bodies[0].locked = engine::kAllDofs;
  return spec;
}

double volume_in(const Simulation& simulation, std::size_t pocket = 0) {
  return simulation.interiors()[0].pockets[pocket].volume;
}

TEST(Pump, HasItsRateWithoutALiftAndNothingAtItsHead) {
  EXPECT_EQ(engine::pump_flow(0.3, 0, 8), 0.3);
  EXPECT_EQ(engine::pump_flow(0.3, -1, 8), 0.3);
  EXPECT_EQ(engine::pump_flow(0.3, 6, 8), 0.15);
  EXPECT_EQ(engine::pump_flow(0.3, 8, 8), 0);
  EXPECT_EQ(engine::pump_flow(0.3, 9, 8), 0);
  EXPECT_EQ(engine::pump_flow(0.3, 9, HUGE_VAL), 0.3);
}

TEST(Pump, BringsItsRateUntilItsSuctionIsDry) {
  Simulation simulation(held(pumped({.from_B = {0.5, 0, -0.4}}, 0.01, 0.5, 0.3)));
  for (int i = 0; i < 60 * 20; ++i) simulation.step();
  EXPECT_NEAR(volume_in(simulation), 0.3, 1e-12);
  for (int i = 0; i < 60 * 30; ++i) simulation.step();
  EXPECT_NEAR(volume_in(simulation), 0.05 * kFloor, 1e-9);
}

// With u = √(1 − H/H₀) the level between upright walls falls so that u' = −Q₀/(2 A H₀). A substep
// takes the flow of its start for all of it, which adds H'' h/2 a second: 7e-6 m in all.
TEST(Pump, LiftsAgainstItsHead) {
  constexpr double rate = 0.005, head = 0.5, seconds = 100;
  Simulation simulation(held(pumped({.from_B = {0, 0, -0.44}, .head = head}, rate, 0.6, 0.55)));
  const double lift = 0.55 - 0.05 - 0.6 / kFloor;
  for (int i = 0; i < 60 * seconds; ++i) simulation.step();
  const double u = std::sqrt(1 - lift / head) - rate * seconds / (2 * kFloor * head);
  const double level = simulation.interiors()[0].pockets[0].level;
  EXPECT_NEAR(-level, head * (1 - u * u), tolerance(1.5e-5));
}

TEST(Pump, LightensAHullThatFloats) {
  SimulationSpec spec = pumped({.from_B = {0, 0, -0.44}}, 0.01, 0.3, 0.35);
  spec.bodies[0].locked = {true, true, false, true, true, true};  // Its free surface lets it heel.
  Simulation simulation(std::move(spec));
  for (int i = 0; i < 60 * 90; ++i) simulation.step();
  const double left = 0.01 * kFloor;
  EXPECT_NEAR(volume_in(simulation), left, 1e-9);
  // It bobs by what the pump takes in a part of its period.
  const double draught = (400 + kFreshWater * left) / (kFreshWater * 2);
  EXPECT_NEAR(0.5 - simulation.states()[0].position.z(), draught, 1e-3);
  EXPECT_EQ(simulation.counts()[0].clamped, 0);
}

TEST(Pump, BringsWaterFromOneCompartmentToAnother) {
  const engine::PumpSpec pump{.from_B = {-0.5, 0, -0.44}, .to_B = Vector3d(0.5, 0, -0.2)};
  Simulation simulation(held(pumped(pump, 0.01, 0.25, 0.3, support::divided_box(0.4))));
  for (int i = 0; i < 60 * 10; ++i) simulation.step();
  const auto pockets = simulation.interiors()[0].pockets;
  ASSERT_EQ(pockets.size(), 2u);
  EXPECT_NEAR(pockets[0].volume, 0.15, 1e-12);
  EXPECT_NEAR(pockets[1].volume, 0.1, 1e-12);
}

TEST(Pump, DrawsFromTheSeaWhileItsSuctionIsUnderIt) {
  for (const double height : {-0.4, 0.0}) {
    const engine::PumpSpec pump{.from_B = {0, 0.6, height}, .to_B = Vector3d(0, 0, 0)};
    Simulation simulation(held(pumped(pump, 0.01, 0, 0.3)));
    for (int i = 0; i < 60 * 10; ++i) simulation.step();
    EXPECT_NEAR(volume_in(simulation), height < 0 ? 0.1 : 0, 1e-12);
  }
}

TEST(Pump, FillsAVoidUpToItsVolume) {
  const engine::PumpSpec pump{.from_B = {0, 0.6, -0.4}, .to_B = Vector3d(0, 0, 0)};
  Simulation simulation(held(pumped(pump, 0.5, 0, 0.3, support::closed_box())));
  for (int i = 0; i < 60 * 10; ++i) simulation.step();
  EXPECT_NEAR(volume_in(simulation), kFloor * 0.9, 1e-9);
}

TEST(Pump, AContinuedRunHasTheSameBytes) {
  const SimulationSpec spec = pumped({.from_B = {-0.5, 0, -0.44}}, 0.02, 0.3, 0.3);
  Simulation whole(spec);
  for (int i = 0; i < 100; ++i) whole.step();
  const std::string saved = whole.state().to_bytes();
  for (int i = 0; i < 300; ++i) whole.step();
  Simulation other(spec);
  other.restore(engine::SimulationState::from_bytes(saved));
  EXPECT_EQ(other.state().to_bytes(), saved);
  for (int i = 0; i < 300; ++i) other.step();
  EXPECT_EQ(other.state().to_bytes(), whole.state().to_bytes());
}

}  // namespace

#include "engine/contacts/bed_suction.h"

#include "tests/engine/prelude.h"

/// Bodies that a soft bed holds, against the closed forms of (E41).

namespace {

constexpr double kPressure = 1500;                 // [Pa]
constexpr double kHoldTime = 4;                    // T [s]
constexpr double kFootprint = 2;                   // [m^2]
constexpr double kWhole = kPressure * kFootprint;  // p A [N]
constexpr double kPullStart = 1;                   // [s]

/// A box of 2 m x 1 m x 0.5 m that lies on the ground, or begins above it.
SimulationSpec on_bed(double height = 0) {
  BodySpec box = support::box_body("box", {2, 1, 0.5}, 300, {0, 0, 0.25 + height});
  box.collision = CollisionShape::box;
  SimulationSpec spec = support::dry_world({std::move(box)}, kStep);
  spec.ground = engine::PlaneGround{0};
  spec.suction = engine::BedSuction{.pressure = kPressure, .time = kHoldTime};
  return spec;
}

double weight(const SimulationSpec& spec) { return spec.bodies[0].mass * spec.gravity; }

/// Time at which a point of the body has been lifted by a centimetre; infinite if it never is.
double time_free(const SimulationSpec& spec, const Vector3d& at_B, double seconds) {
  Simulation simulation(spec);
  const auto height = [&] {
    const hydro::BodyState& state = simulation.states()[0];
    return (state.position + state.orientation * at_B).z();
  };
  const double start = height();
  while (simulation.time() < seconds) {
    simulation.step();
    if (height() > start + 0.01) return simulation.time();
  }
  return HUGE_VAL;
}

/// Time from the begin of a pull over the weight to the lift of the box.
double time_pulled(SimulationSpec spec, double pull, double seconds) {
  spec.bodies[0].loads = {{.force = {0, 0, weight(spec) + pull}, .start = kPullStart}};
  return time_free(spec, Vector3d::Zero(), kPullStart + seconds) - kPullStart;
}

// The bond follows the force of the step before, and the lift of 1 cm takes √(2 s/a) of what is
// left over when the bond gives.
TEST(BedSuction, ConstantPullsFreeABodyAfterTheirTime) {
  for (const double share : {0.25, 0.5, 0.8}) {
    const double expected = kHoldTime * (1 / share - 1);
    EXPECT_NEAR(time_pulled(on_bed(), share * kWhole, 30), expected, tolerance(0.25)) << share;
  }
}

// In still water the energy of what nothing drives may not grow, and the bed's load does work.
TEST(BedSuction, HoldsABodyUnderWaterForTheSameTime) {
  SimulationSpec spec = on_bed();
  BodySpec& box = spec.bodies[0];
  box.wet = true;
  box.mass = 1800;
  box.inertia_B *= 6;
  spec.sea = hydro::Sea{.density = 1000, .gravity = kGravity, .level = 5};
  const double lifted = (1800 - 1000 * kFootprint / 2) * kGravity;
  box.loads = {{.force = {0, 0, lifted + kWhole / 2}, .start = kPullStart}};
  const double time = time_free(spec, Vector3d::Zero(), 20) - kPullStart;
  EXPECT_NEAR(time, kHoldTime, tolerance(0.4));
}

TEST(BedSuction, APullOfTheWholeForceFreesABodyAtOnce) {
  EXPECT_LT(time_pulled(on_bed(), 1.05 * kWhole, 10), 0.5);
  EXPECT_GT(time_pulled(on_bed(), 0.9 * kWhole, 10), 0.09 / 0.9 * kHoldTime);
  SimulationSpec hard = on_bed();
  hard.suction.reset();
  EXPECT_LT(time_pulled(hard, 0.05 * kWhole, 10), 0.5);
}

TEST(BedSuction, ABodyThatIsPulledFromTheStartHasLainThere) {
  SimulationSpec spec = on_bed();
  spec.bodies[0].loads = {{.force = {0, 0, weight(spec) + kWhole / 2}}};
  EXPECT_NEAR(time_free(spec, Vector3d::Zero(), 10), kHoldTime, tolerance(0.25));
}

TEST(BedSuction, ABodyThatIsNotPulledLiesStill) {
  Simulation simulation(on_bed());
  for (int i = 0; i < 60; ++i) simulation.step();
  const hydro::BodyState then = simulation.states()[0];
  for (int i = 0; i < 3600; ++i) simulation.step();
  EXPECT_LT((simulation.states()[0].position - then.position).norm(), tolerance(1e-6));
}

// About the other edge the weight and the suction have half of the arm of the pull.
TEST(BedSuction, OneEndIsLiftedByHalfTheForce) {
  SimulationSpec spec = on_bed();
  const Vector3d end(1, 0, -0.25);
  for (const double part : {0.93, 1.07}) {
    const double force = part * (weight(spec) + kWhole) / 2;
    spec.bodies[0].loads = {{.force = {0, 0, force}, .at_B = end, .start = kPullStart}};
    const double time = time_free(spec, end, kPullStart + 0.25);
    EXPECT_EQ(std::isfinite(time), part > 1) << part;
  }
}

// b = W t/(p A T) after it has been pressed down by its weight for t.
TEST(BedSuction, ABodyThatComesLaterBondsByItsWeight) {
  SimulationSpec spec = on_bed(0.2);
  const double landed = std::sqrt(2 * 0.2 / kGravity), start = landed + 2;
  // The landing itself presses the box, too: N dt = m v.
  const double landing = spec.bodies[0].mass * kGravity * landed;
  const double bond = (weight(spec) * 2 + landing) / (kWhole * kHoldTime);
  ASSERT_LT(bond, 1);
  for (const double part : {0.85, 1.15}) {
    spec.bodies[0].loads = {{.force = {0, 0, weight(spec) + part * bond * kWhole}, .start = start}};
    Simulation simulation(spec);
    while (simulation.time() < start + 0.25) simulation.step();
    EXPECT_EQ(simulation.states()[0].position.z() > 0.255, part > 1) << part;
  }
}

TEST(BedSuction, IsPartOfTheState) {
  SimulationSpec spec = on_bed();
  spec.bodies[0].loads = {{.force = {0, 0, weight(spec) + kWhole / 2}, .start = kPullStart}};
  Simulation simulation(spec);
  for (int i = 0; i < 180; ++i) simulation.step();
  const engine::SimulationState saved = simulation.state();
  const auto go_on = [&] {
    for (int i = 0; i < 180; ++i) simulation.step();
    return simulation.states()[0].position;
  };
  const Vector3d first = go_on();
  simulation.restore(saved);
  EXPECT_EQ(go_on(), first);
  spec.suction.reset();
  Simulation hard(spec);
  EXPECT_THROW(hard.restore(saved), std::invalid_argument);
}

TEST(BedSuction, WhatCannotBeIsRefused) {
  const auto refused = [](const auto& change) {
    SimulationSpec spec = on_bed();
    change(spec);
    EXPECT_THROW(Simulation{spec}, std::invalid_argument);
  };
  refused([](SimulationSpec& spec) { spec.suction->pressure = -1; });
  refused([](SimulationSpec& spec) { spec.suction->time = 0; });
  refused([](SimulationSpec& spec) { spec.ground = std::monostate{}; });
  refused([](SimulationSpec& spec) { spec.integrator.method = engine::Integrator::Method::ode; });
}

}  // namespace

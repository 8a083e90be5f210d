#include <numbers>

#include "engine/base/constants.h"
#include "hydro/added_mass/added_mass.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "tests/engine/prelude.h"

namespace {

using engine::Integrator;

BodySpec barge() {
  BodySpec body = support::box_body("barge", {4, 3, 1}, 500, {0, 0, 0.2}, 2);
  body.wet = true;
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  body.initial.orientation = Eigen::AngleAxisd(0.2, Vector3d(1, 0.5, 0.3).normalized());
  body.added_mass = std::make_shared<hydro::WettedAddedMass>(
      body.mesh_B, hydro::solve_added_mass(body.mesh_B, {.tolerance = 0.02}));
  return body;
}

SimulationSpec in_water(const BodySpec& body, double step) {
  SimulationSpec spec = support::dry_world({body}, step);
  spec.sea.emplace();
  return spec;
}

hydro::BodyState rocked(SimulationSpec spec, double time) {
  return support::after(spec, support::steps_in(time, spec.step)).states()[0];
}

TEST(SplitStep, OfARockingBargeWithChangingAddedMassIsOfSecondOrder) {
  const BodySpec body = barge();
  const hydro::BodyState exact = rocked(in_water(body, 1.0 / 3840), 2);
  const double coarse = distance(rocked(in_water(body, 1.0 / 60), 2), exact);
  const double fine = distance(rocked(in_water(body, 1.0 / 480), 2), exact);
  // Above the second order's error there is some of the fourth's: the slope is that of the finer.
  EXPECT_GT(std::log2(coarse / fine) / 3, 1.6) << coarse << " and " << fine;
  EXPECT_LT(coarse, tolerance(8e-5));
}

// The added mass changes with the wetted surface, and loads of waves depend on time, too. The
// errors are 1.7e-4, 3.4e-5 and 7e-6 m, of the orders 2.3 and 2.25. If half of
// the finest error were of first order, the second of them would be 1.76.
TEST(SplitStep, OfABargeInARegularWaveIsOfSecondOrder) {
  const BodySpec body = barge();
  const auto tossed = [&](double step) {
    SimulationSpec spec = in_water(body, step);
    const double wave_number = 2 * std::numbers::pi / 20;
    spec.sea->surface =
        hydro::WaveSurface{{hydro::linear_wave(*spec.sea, 0.2, wave_number, 0.35, 0)}};
    return rocked(std::move(spec), 4);
  };
  const hydro::BodyState exact = tossed(1.0 / 960);
  const double coarse = distance(tossed(1.0 / 30), exact);
  const double middle = distance(tossed(1.0 / 60), exact);
  const double fine = distance(tossed(1.0 / 120), exact);
  EXPECT_GT(std::log2(coarse / middle), 1.8) << coarse << " and " << middle;
  EXPECT_GT(std::log2(middle / fine), 1.8) << middle << " and " << fine;
}

TEST(Tolerance, BoundsTheErrorOfAFreeBody) {
  const BodySpec body = barge();
  const hydro::BodyState exact = rocked(in_water(body, 1.0 / 3840), 2);
  for (const double wanted : {1e-3, 1e-5}) {
    SimulationSpec spec = in_water(body, 0.1);
    spec.integrator.tolerance = wanted;
    const Simulation simulation = support::after(spec, 20);
    // The body's radius is 2.5 m; 2 s of a motion that does not amplify errors.
    EXPECT_LT(distance(simulation.states()[0], exact), tolerance(2.5 * 2 * wanted)) << wanted;
    EXPECT_GT(simulation.counts()[0].substeps, 40);
  }
}

/// Two barges that a hinge joins end to end, rocking.
SimulationSpec hinged_barges(double step) {
  std::vector<BodySpec> both(2, barge());
  both[1].name = "other";
  for (BodySpec& body : both) body.initial.orientation.setIdentity();
  both[0].initial.position = {-2.1, 0, 0.3};
  both[1].initial.position = {2.1, 0, 0.3};
  SimulationSpec spec = support::dry_world(both, step);
  spec.sea.emplace();
  spec.joints = {{.name = "hinge",
                  .type = engine::JointSpec::Type::hinge,
                  .first = 0,
                  .second = 1,
                  .anchor_W = {0, 0, 0.3},
                  .axis_W = Vector3d::UnitY()}};
  spec.bodies[0].initial.linear_velocity.z() = 0.5;
  spec.bodies[0].initial.angular_velocity.y() = -0.5 / 2.1;
  return spec;
}

TEST(Tolerance, BoundsTheErrorOfBodiesUnderJoints) {
  const std::vector<hydro::BodyState> exact =
      support::after(hinged_barges(1.0 / 3840), 2 * 3840).states();
  for (const double wanted : {1e-3, 1e-4}) {
    SimulationSpec spec = hinged_barges(0.1);
    spec.integrator.tolerance = wanted;
    const Simulation simulation = support::after(spec, 20);
    double error = 0;
    for (std::size_t i = 0; i < 2; ++i)
      error = std::max(error, distance(simulation.states()[i], exact[i]));
    EXPECT_LT(error, tolerance(2.5 * 2 * wanted)) << wanted;
  }
}

TEST(SplitStep, OfABodyThatStartsToSwingOnAHingeIsOfFourthOrder) {
  const auto swung = [](double step) {
    BodySpec plate = support::box_body("plate", {0.2, 1, 1.5}, 2500, {-0.65, 0, -0.375});
    SimulationSpec spec = support::dry_world({plate}, step);
    spec.joints = {{.name = "hinge", .first = 0, .axis_W = Vector3d::UnitY()}};
    return support::after(spec, support::steps_in(1, step)).states()[0];
  };
  const hydro::BodyState exact = swung(1.0 / 3840);
  const double coarse = distance(swung(1.0 / 60), exact);
  const double fine = distance(swung(1.0 / 480), exact);
  EXPECT_GT(std::log2(coarse / fine) / 3, 3.7) << coarse << " and " << fine;
}

TEST(PlainMethod, IsFurtherOffThanTheSplitStepByFar) {
  BodySpec body = barge();
  body.added_mass = nullptr;
  SimulationSpec spec = in_water(body, 1.0 / 3840);
  const hydro::BodyState exact = rocked(spec, 2);
  spec.step = 0.01;
  const double split = distance(rocked(spec, 2), exact);
  spec.integrator.method = Integrator::Method::ode;
  const double plain = distance(rocked(spec, 2), exact);
  EXPECT_GT(plain, 10 * split);
}

TEST(Entry, DoesNotTakeWhatALoadHasGiven) {
  // Pushed along for 6 s, then it falls into the water at once: suddenly, with all that it gained.
  for (const double lift : {0.0, 0.01}) {
    BodySpec body = barge();
    body.added_mass = nullptr;
    body.coefficients.pressure_drag = {0, 0};
    body.coefficients.lift = lift;
    body.locked = {false, false, false, true, true, true};
    body.initial.orientation.setIdentity();
    body.initial.position.z() = 177;  // m: 5.9 s of fall
    body.loads.push_back({.force = {20000, 0, 0}});
    const SimulationSpec spec = in_water(body, 1.0 / 15);
    const Simulation simulation = support::after(spec, 10 * 15);
    const double gained = 20000 * 10 / body.mass;
    EXPECT_NEAR(simulation.states()[0].linear_velocity.x(), gained, tolerance(1e-9 * gained))
        << lift;
  }
}

TEST(Impact, GivesABodyAfloatWhatTheOtherLoses) {
  // No drag: the momentum along the water is kept, by bodies that bob and heel after they have met.
  std::vector<BodySpec> boxes;
  for (const double x : {-3.0, 0.0}) {
    BodySpec box = support::box_body("box", {1, 1, 0.5}, 500, {x, 0, 0.4}, 1);  // above the water
    box.wet = true;
    box.coefficients.pressure_drag = {0, 0};
    box.coefficients.lift = 0;
    box.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
    box.collision = engine::CollisionShape::mesh;
    boxes.push_back(box);
  }
  boxes[0].initial.linear_velocity = {3, 0, 0};
  SimulationSpec spec = support::dry_world(boxes, 1.0 / 60);
  spec.sea.emplace();
  const Simulation simulation = support::after(spec, 240);
  const double mean =
      (simulation.states()[0].linear_velocity.x() + simulation.states()[1].linear_velocity.x()) / 2;
  // What bobbing seems to gain is trimmed from the whole motion: up to kEnergyGain of its energy
  // each time that the bodies have come apart; they touch up to four times.
  EXPECT_NEAR(mean, 1.5, tolerance(4 * engine::kEnergyGain * 1.5));
  EXPECT_GT(simulation.states()[1].linear_velocity.x(), 1);
}

TEST(Entry, AtHighSpeedGainsNoEnergy) {
  for (const double speed : {30.0, 300.0}) {
    BodySpec body = barge();
    body.initial.position.z() = 20;
    body.initial.linear_velocity = {5, 0, -speed};
    body.initial.angular_velocity = {1, 2, 0};
    const SimulationSpec spec = in_water(body, 1.0 / 15);
    Simulation simulation(spec);
    double top = support::total_energy(spec, simulation.states());
    const double start = top;
    for (int i = 0; i < 60; ++i) {
      simulation.step();
      const double now = support::total_energy(spec, simulation.states());
      ASSERT_LE(now, top + 1e-3 * top) << speed << ", step " << i;
      top = std::max(top, now);
    }
    EXPECT_LT(support::total_energy(spec, simulation.states()), 0.5 * start);
  }
}

}  // namespace

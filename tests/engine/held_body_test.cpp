#include "engine/motion/body.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "hydro/radiation/floating_body.h"
#include "tests/engine/prelude.h"
#include "tests/support/radiating_sphere.h"

/// Bodies that locks or a fixed joint hold: what the water does to them, and what holds them.

namespace {

using engine::BodyForces;
using hydro::Wrench;

constexpr double kRho = 1025;  // Density of the water [kg/m^3].

/// A box of 1 × 2 × 3 m and half the water's density that reaches 2 m into the water.
BodySpec pier() {
  BodySpec box = support::box_body("pier", {1, 2, 3}, kRho / 2, {0, 0, -0.5}, 2);
  box.wet = true;
  box.coefficients.lift = 0;
  box.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  return box;
}

BodySpec free_of_drag(BodySpec body) {
  body.coefficients.pressure_drag = {0, 0};
  return body;
}

BodySpec with_added_mass(BodySpec body) {
  const hydro::AddedMassSolution solution =
      hydro::solve_added_mass(body.mesh_B, {.tolerance = 1e3});
  body.added_mass = std::make_shared<hydro::WettedAddedMass>(body.mesh_B, solution);
  return body;
}

SimulationSpec in_sea(BodySpec body, const hydro::Sea& sea) {
  SimulationSpec spec = support::dry_world({std::move(body)}, 0.05);
  spec.sea = sea;
  spec.record_work = true;
  return spec;
}

SimulationSpec locked(SimulationSpec spec) {
  spec.bodies[0].locked = engine::kAllDofs;
  return spec;
}

SimulationSpec fixed(SimulationSpec spec) {
  spec.joints = {{.name = "foot", .type = JointSpec::Type::fixed, .first = 0}};
  return spec;
}

SimulationSpec locked_and_fixed(SimulationSpec spec) {
  spec.bodies[0].locked = {true, true, true, true, true, false};
  return fixed(std::move(spec));
}

hydro::Sea waves_on_a_current(double amplitude, double length, const Vector3d& current) {
  hydro::Sea sea{.density = kRho, .gravity = kGravity, .current = current};
  const double k = 2 * M_PI / length;
  sea.surface = hydro::WaveSurface{{hydro::linear_wave(sea, amplitude, k, 0.3, 0.2)}};
  return sea;
}

std::vector<Wrench> all_loads(const BodyForces& f) {
  return {f.water.buoyancy, f.water.pressure_drag, f.water.wave_inertia, f.weight,
          f.radiation,      f.added_mass,          f.constraint,         f.lines,
          f.applied};
}

double size(const Wrench& wrench) { return wrench.force.norm() + wrench.moment.norm(); }

/// The loads of a body after each of some steps, those of the start first.
std::vector<std::vector<Wrench>> log_of(const SimulationSpec& spec, int steps) {
  Simulation simulation(spec);
  std::vector<std::vector<Wrench>> rows;
  for (int i = 0; i <= steps; ++i) {
    rows.push_back(all_loads(simulation.forces()[0]));
    simulation.step();
  }
  return rows;
}

TEST(HeldBody, InStillWaterIsHeldAgainstItsWeightLessItsBuoyancy) {
  const SimulationSpec spec = in_sea(pier(), {.density = kRho, .gravity = kGravity});
  for (const SimulationSpec& held : {locked(spec), fixed(spec), locked_and_fixed(spec)})
    for (const int steps : {0, 10}) {
      const BodyForces forces = support::after(held, steps).forces()[0];
      const double buoyancy = kRho * kGravity * 1 * 2 * 2;
      const double weight = kRho / 2 * kGravity * 1 * 2 * 3;
      EXPECT_NEAR(forces.water.buoyancy.force.z(), buoyancy, tolerance(1e-11 * buoyancy));
      EXPECT_NEAR(forces.constraint.force.z(), weight - buoyancy, tolerance(1e-11 * buoyancy));
      EXPECT_LT(forces.constraint.moment.norm(), tolerance(1e-11 * buoyancy));
    }
}

TEST(HeldBody, IsPushedByACurrentAsItsFacesAre) {
  const Vector3d current(1.5, 0, 0);
  const SimulationSpec spec =
      in_sea(pier(), {.density = kRho, .gravity = kGravity, .current = current});
  const hydro::PressureDrag& c = spec.bodies[0].coefficients.pressure_drag;
  const double drag = 0.5 * kRho * (c.front + c.back) * (2 * 2) * 1.5 * 1.5;
  const BodyForces forces = support::after(locked(spec), 3).forces()[0];
  EXPECT_NEAR(forces.water.pressure_drag.force.x(), drag, tolerance(1e-11 * drag));
  EXPECT_NEAR(forces.constraint.force.x(), -drag, tolerance(1e-11 * drag));
}

// Below a long wave the water's acceleration is that at the centre; the rest is of the order of the
// steepness, 0.8 %, and of (k · 1.5 m)².
TEST(HeldBody, IsPushedByALongWaveWithItsDisplacedAndAddedMass) {
  BodySpec body = free_of_drag(pier());
  body.initial.position.z() = -6;
  Matrix6d added = Matrix6d::Zero();
  added.diagonal() << 5000, 3000, 1000, 0, 0, 0;
  body.added_mass = std::make_shared<hydro::ConstantAddedMass>(body.mesh_B, added);
  const SimulationSpec spec = locked(in_sea(body, waves_on_a_current(0.5, 400, Vector3d::Zero())));
  Simulation simulation(spec);
  for (int i = 0; i < 40; ++i) simulation.step();
  const BodyForces forces = simulation.forces()[0];
  const Vector3d a =
      hydro::water_at(*spec.sea, body.initial.position, simulation.time()).acceleration;
  const Vector3d inertia = Vector3d(5000, 3000, 1000).cwiseProduct(a);
  ASSERT_GT(a.norm(), 0.05);
  const double weight = kRho / 2 * kGravity * 6;
  const double off = 1e-3 * inertia.norm();
  EXPECT_LT((forces.water.wave_inertia.force - inertia).norm(), tolerance(off));
  const Vector3d held = Vector3d(0, 0, -weight) - kRho * 6 * a - inertia;
  EXPECT_LT((forces.constraint.force - held).norm(), tolerance(8e-3 * kRho * 6 * a.norm() + off));
}

TEST(HeldBody, HasTheSameLoadsHoweverItIsHeld) {
  const SimulationSpec spec =
      in_sea(with_added_mass(pier()), waves_on_a_current(0.4, 25, {1, 0.3, 0}));
  const auto rows = log_of(locked(spec), 100);
  for (const SimulationSpec& other : {fixed(spec), locked_and_fixed(spec)}) {
    const auto others = log_of(other, 100);
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t k = 0; k < rows[i].size(); ++k)
        ASSERT_LT(size(rows[i][k] + -1.0 * others[i][k]), tolerance(1e-9 * size(rows[i][0])))
            << "row " << i << ", load " << k;
  }
}

TEST(HeldBody, StaysWhereItIs) {
  const SimulationSpec spec =
      in_sea(with_added_mass(pier()), waves_on_a_current(0.4, 25, {1, 0, 0}));
  for (const SimulationSpec& held : {locked(spec), fixed(spec), locked_and_fixed(spec)})
    EXPECT_EQ(support::after(held, 100).states()[0], spec.bodies[0].initial);
}

/// Sum over a time of the load of the water that moves with a held body [N s].
Vector3d entry_impulse(Simulation& simulation, double until) {
  Vector3d sum = Vector3d::Zero();
  while (simulation.time() < until) {
    simulation.step();
    sum += simulation.spec().step * simulation.forces()[0].added_mass.force;
  }
  return sum;
}

// Water that rises along a body in a current is slowed to the body's velocity: ΔA (U − 0). The
// waves are so long that their own velocities are small against the current's.
TEST(HeldBody, TakesTheMomentumOfTheWaterThatRisesAlongIt) {
  BodySpec body = with_added_mass(free_of_drag(pier()));
  const Vector3d current(2, 0, 0);
  hydro::Sea sea = waves_on_a_current(0.3, 2000, current);
  const SimulationSpec spec = locked(in_sea(body, sea));
  const auto height = [&](double time) { return hydro::surface_elevation(sea, 0, 0, time); };
  Simulation simulation(spec);
  const double period = 2 * M_PI / std::sqrt(kGravity * 2 * M_PI / 2000);
  double trough = 0;  // The first one.
  for (double t = 0; t < period; t += 0.05)
    if (height(t) < height(trough)) trough = t;
  entry_impulse(simulation, trough);
  const auto added = [&] {
    return body.added_mass->at(spec.bodies[0].initial, sea, simulation.time())(0, 0);
  };
  const double before = added();
  const double in = entry_impulse(simulation, simulation.time() + 0.4 * period).x();
  const double gain = added() - before;
  ASSERT_GT(gain, 500);
  EXPECT_NEAR(in, gain * current.x(), tolerance(0.1 * gain * current.x()));
}

TEST(HeldBody, GivesNothingBackToTheWaterThatFallsAlongIt) {
  const BodySpec body = with_added_mass(free_of_drag(pier()));
  const SimulationSpec spec = locked(in_sea(body, waves_on_a_current(0.3, 100, {2, 0, 0})));
  Simulation simulation(spec);
  const auto added = [&] {
    return body.added_mass->at(spec.bodies[0].initial, *spec.sea, simulation.time())(0, 0);
  };
  double rising = 0, falling = 0;
  for (int i = 0; i < 200; ++i) {
    const double before = added();
    simulation.step();
    double& sum = added() > before ? rising : falling;
    sum += std::abs(simulation.forces()[0].added_mass.force.x());
  }
  EXPECT_GT(rising, 1e4);
  EXPECT_LT(falling, tolerance(0.02 * rising));  // Some directions gain while the others lose.
}

// A lock holds against the same water in one direction as in all. The body is so heavy that it
// hardly moves in the others.
TEST(HeldBody, OneLockHoldsAgainstTheWaterThatRisesAlongTheBody) {
  BodySpec body = with_added_mass(free_of_drag(pier()));
  body.mass *= 1e6;
  SimulationSpec spec = in_sea(body, waves_on_a_current(0.3, 100, {2, 0, 0}));
  spec.gravity = 0;
  SimulationSpec heaving = spec;
  heaving.bodies[0].locked = {true, true, false, true, true, true};
  Simulation all(locked(spec)), one(heaving);
  double most = 0;
  for (int i = 0; i < 100; ++i) {
    double loads = one.forces()[0].water.total().force.x() / 2;
    all.step();
    one.step();
    const BodyForces forces = one.forces()[0];
    loads += forces.water.total().force.x() / 2;
    const double expected = all.forces()[0].added_mass.force.x();
    most = std::max(most, std::abs(expected));
    EXPECT_NEAR(forces.added_mass.force.x(), expected, tolerance(1e-3 * most));
    // That of a lock is a mean over the step.
    EXPECT_NEAR(forces.constraint.force.x(), -loads - expected, tolerance(5e-3 * most));
  }
  EXPECT_GT(most, 100);
}

TEST(HeldBody, IsPushedByTheWavesThatItScatters) {
  BodySpec ball = support::sphere_body("ball", 1, 500, {0, 0, 0});
  ball.wet = true;
  const auto push = [](const BodyState&, const hydro::WaveFrame&, const hydro::Sea&, double time) {
    return Wrench{.force = {100 * time, 0, 0}};
  };
  ball.radiation =
      std::make_shared<hydro::FloatingBody>(ball.mesh_B, support::radiating_sphere(1), push);
  ball.added_mass = ball.radiation;
  const SimulationSpec spec = in_sea(ball, waves_on_a_current(0.05, 20, Vector3d::Zero()));
  for (const SimulationSpec& held : {locked(spec), fixed(spec)}) {
    const BodyForces forces = support::after(held, 20).forces()[0];
    EXPECT_NEAR(forces.water.diffraction.force.x(), 100, tolerance(1e-12));
    EXPECT_LT(size(forces.water.total() + forces.weight + forces.added_mass + forces.radiation +
                   forces.constraint),
              tolerance(1e-12 * size(forces.weight)));
  }
}

TEST(HeldBody, CostsNothingWhereNobodyAsks) {
  SimulationSpec spec = in_sea(with_added_mass(pier()), waves_on_a_current(0.4, 25, {1, 0, 0}));
  spec.record_work = false;
  const Simulation simulation = support::after(locked(spec), 10);
  EXPECT_EQ(simulation.counts()[0].substeps, 0);
  EXPECT_TRUE(simulation.skips().water);
}

}  // namespace

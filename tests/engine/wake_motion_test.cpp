#include "engine/state_data.h"
#include "hydro/loads/wake.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/engine/prelude.h"

/// Drag of bodies that start, or move to and fro, in the water.

namespace {

using engine::MovingBody;

constexpr double kFirstSpeed = 0.5;  // [m/s]

/// A ball, or a box, deep in still water, that weighs as much as the water and knows drag alone.
SimulationSpec deep_in_water(BodySpec body, double step) {
  body.wet = true;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  body.initial.position.z() = -50;
  SimulationSpec spec = support::dry_world({std::move(body)}, step);
  spec.sea = hydro::Sea{.density = 1000, .gravity = kGravity};
  spec.record_work = true;
  return spec;
}

BodySpec ball() { return support::sphere_body("ball", 0.5, 1000, {0, 0, 0}); }
BodySpec box() { return support::box_body("box", {3, 2, 1}, 1000, {0, 0, 0}); }

BodySpec pulled(BodySpec body, double force) {
  // Its buoyancy is that of a polyhedron.
  body.mass = 1000 * std::abs(hydro::solid_properties(body.mesh_B).volume);
  body.loads = {{.force = {force, 0, 0}}};
  return body;
}

/// The way of a ball of the mass m that a force pulls from rest: m v' = F − f(d) k v²,
/// d' = v − v d/ℓ, by Runge and Kutta's method.
double way_from_rest(double force, double mass, double k, double length, double time) {
  using Eigen::Vector3d;  // way, speed, d
  const auto rate = [&](const Vector3d& y) {
    const double formed = std::pow(y[2] / length, 4);
    return Vector3d(y[1], (force - formed * k * y[1] * y[1]) / mass, y[1] * (1 - y[2] / length));
  };
  constexpr int kSteps = 4000;
  const double h = time / kSteps;
  Vector3d y = Vector3d::Zero();
  for (int i = 0; i < kSteps; ++i) {
    const Vector3d a = rate(y), b = rate(y + h / 2 * a), c = rate(y + h / 2 * b);
    y += h / 6 * (a + 2 * b + 2 * c + rate(y + h * c));
  }
  return y[0];
}

TEST(WakeMotion, OfABallThatIsPulledFromRestIsOfSecondOrder) {
  const double force = 400, time = 6;
  double missed[2];
  for (int i = 0; i < 2; ++i) {
    const SimulationSpec spec = deep_in_water(pulled(ball(), force), i == 0 ? 0.04 : 0.02);
    const hydro::BodyState steady{.position = {0, 0, -50}, .linear_velocity = {1, 0, 0}};
    const double k = -hydro::compute_loads(hydro::make_hull(spec.bodies[0].mesh_B), steady,
                                           *spec.sea, 0, spec.bodies[0].coefficients)
                          .pressure_drag.force.x();
    const double length = hydro::wake_scale(spec.bodies[0].mesh_B).length;
    const double exact = way_from_rest(force, spec.bodies[0].mass, k, length, time);
    const Simulation end = support::after(spec, support::steps_in(time, spec.step));
    missed[i] = std::abs(end.states()[0].position.x() - exact);
    EXPECT_LT(missed[i], tolerance(2e-3 * exact));
  }
  EXPECT_GT(missed[0] / missed[1], 3);
}

TEST(WakeMotion, ThatGoesOnAsItStartedHasSteadyDrag) {
  for (const bool current : {false, true}) {
    SimulationSpec spec = deep_in_water(pulled(ball(), 0), 0.02);
    (current ? spec.sea->current : spec.bodies[0].initial.linear_velocity) = {kFirstSpeed, 0, 0};
    SimulationSpec steady = spec;
    steady.bodies[0].coefficients.pressure_drag.blunt = 0;
    const Simulation a = support::after(spec, 200), b = support::after(steady, 200);
    EXPECT_LT(support::distance(a.states()[0], b.states()[0]), tolerance(1e-12));
    EXPECT_LT(b.states()[0].linear_velocity.norm(), 0.8 * kFirstSpeed);
  }
}

TEST(WakeMotion, OfAHeldBodyHasSteadyDrag) {
  SimulationSpec spec = deep_in_water(box(), 0.02);
  spec.bodies[0].locked = engine::kAllDofs;
  EXPECT_FALSE(support::moving_bodies(spec)[0].body.wake);
}

TEST(WakeMotion, AboveTheWaterLeavesNone) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 1});
  spec.bodies[0].initial.linear_velocity.x() = 1;
  Simulation simulation(spec);
  const auto formed = [&] { return simulation.state().data().bodies[0].motion.wake.norm(); };
  EXPECT_EQ(formed(), 0);
  while (simulation.states()[0].position.z() > 0.55) simulation.step();
  EXPECT_EQ(formed(), 0);
  for (int i = 0; i < 20; ++i) simulation.step();
  EXPECT_GT(formed(), 0.1);
}

TEST(WakeMotion, TakesPowerWhateverTheWake) {
  support::Random random(5);
  SimulationSpec spec = deep_in_water(box(), 0.02);
  MovingBody moving = std::move(support::moving_bodies(spec)[0]);
  for (int i = 0; i < 100; ++i) {
    hydro::BodyState state = random.state(0, 1);
    state.position.z() = random.uniform(-1, 1);
    moving.motion.wake << random.vector(0.5), random.vector(0.5);
    const hydro::Wrench drag =
        engine::water_loads(moving.body, moving.motion, state, 0).pressure_drag;
    const double power =
        drag.force.dot(state.linear_velocity) + drag.moment.dot(state.angular_velocity);
    EXPECT_LE(power, 0);
  }
}

/// A box that starts to turn about its long axis meets its edges' drag: as much as that of a plane
/// flow gives to the order of magnitude, and ten times that of its panels.
TEST(WakeMotion, OfABoxThatTurnsFromRestIsThatOfItsEdges) {
  SimulationSpec spec = deep_in_water(support::box_body("bar", {20, 3, 1}, 1000, {0, 0, 0}), 0.02);
  MovingBody moving = std::move(support::moving_bodies(spec)[0]);
  hydro::BodyState state = moving.motion.state;
  state.angular_velocity.x() = 1;
  const double edges =
      engine::water_loads(moving.body, moving.motion, state, 0).pressure_drag.moment.x();
  moving.motion.wake = hydro::steady_wake(moving.body.wake->scale, Matrix3d::Identity(),
                                          engine::velocity(state, Vector3d::Zero()));
  const double panels =
      engine::water_loads(moving.body, moving.motion, state, 0).pressure_drag.moment.x();
  EXPECT_GT(edges / panels, 5);
  EXPECT_LT(edges / panels, 20);
}

TEST(WakeMotion, GoesOnFromASavedStateToTheLastBit) {
  BodySpec body = box();
  body.loads = {{.force = {3000, 500, 0}, .at_B = {0, 0.3, 0.1}, .sine = engine::Sine{0.2, 0}}};
  const SimulationSpec spec = deep_in_water(body, 0.02);
  Simulation whole(spec), resumed(spec);
  for (int i = 0; i < 100; ++i) whole.step();
  resumed.restore(engine::SimulationState::from_bytes(whole.state().to_bytes()));
  for (int i = 0; i < 100; ++i) {
    whole.step();
    resumed.step();
  }
  EXPECT_EQ(whole.states()[0], resumed.states()[0]);
  EXPECT_GT(whole.states()[0].angular_velocity.norm(), 1e-3);
}

}  // namespace

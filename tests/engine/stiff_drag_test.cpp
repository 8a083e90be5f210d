#include "engine/stiff_drag.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/specs.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using engine::BodySpec;
using engine::Simulation;
using engine::SimulationSpec;
using support::tolerance;

constexpr double kStep = 1.0 / 60;
constexpr double kDensity = 1000;  // of the water [kg/m^3]

hydro::Sea deep_water() {
  return {.density = kDensity, .gravity = support::kGravity, .level = 1000};
}

/// A box that meets pressure drag alone, submerged.
BodySpec dragged_box(const Vector3d& size, double density) {
  BodySpec body = support::box_body("box", size, density, {0, 0, 0}, 2);
  body.wet = true;
  body.coefficients.buoyancy = false;
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  return body;
}

/// The body without gravity in water that stands still.
SimulationSpec weightless(const BodySpec& body) {
  SimulationSpec spec = support::dry_world({body}, kStep);
  spec.gravity = 0;
  spec.sea = deep_water();
  return spec;
}

hydro::Wrench drag_on(const BodySpec& body) {
  return hydro::compute_loads(hydro::make_hull(body.mesh_B), body.initial, deep_water(), 0,
                              body.coefficients)
      .pressure_drag;
}

/// Drag of a unit cube moved face-on [N].
double face_on_drag(const BodySpec& cube, double speed) {
  const hydro::PressureDrag& c = cube.coefficients.pressure_drag;
  return 0.5 * kDensity * (c.front + c.back) * speed * speed;
}

TEST(StiffDrag, StiffnessOfACubeMovedFaceOnIsItsShareOfTheMomentum) {
  BodySpec cube = dragged_box({1, 1, 1}, 20);
  cube.initial.linear_velocity = {3, 0, 0};
  const double expected = kStep * face_on_drag(cube, 3) / (20 * 3);
  // Round-off of the panel sums.
  EXPECT_NEAR(engine::drag_stiffness(cube, cube.initial, Vector3d::Zero(), drag_on(cube), kStep),
              expected, tolerance(1e-13 * expected));
}

TEST(StiffDrag, IsMeasuredRelativeToTheWater) {
  BodySpec cube = dragged_box({1, 1, 1}, 20);
  cube.initial.linear_velocity = {3, 0, 0};
  const hydro::Wrench drag = drag_on(cube);
  const double still = engine::drag_stiffness(cube, cube.initial, Vector3d::Zero(), drag, kStep);
  const Vector3d current(-7, 2, 0);
  cube.initial.linear_velocity += current;
  // The velocity relative to the water loses a digit.
  EXPECT_NEAR(engine::drag_stiffness(cube, cube.initial, current, drag, kStep), still,
              tolerance(1e-14 * still));
}

TEST(StiffDrag, ImplicitPartOfACubeMovedFaceOnIsTheScalarSolution) {
  BodySpec cube = dragged_box({1, 1, 1}, 20);
  constexpr double kSpeed = 3;
  cube.initial.linear_velocity = {kSpeed, 0, 0};
  const double drag = face_on_drag(cube, kSpeed);
  const hydro::Wrench load{{500 - drag, 0, 0}, {0, 0, 0}};
  const hydro::Wrench part = engine::implicit_part(cube, hydro::make_hull(cube.mesh_B),
                                                   cube.initial, deep_water(), 0, load, kStep);
  const double resistance = 2 * drag / kSpeed;
  const double expected = -resistance * kStep * load.force.x() / (20 + kStep * resistance);
  // Forward differences of a quadratic, 1e-6 of the speed apart, are 0.5e-6 off.
  EXPECT_NEAR(part.force.x(), expected, tolerance(1e-6 * std::abs(expected)));
  EXPECT_LT(part.force.tail<2>().norm() + part.moment.norm(), tolerance(1e-6 * drag));
}

TEST(StiffDrag, LockedDegreesOfFreedomTakeNoPart) {
  BodySpec box = dragged_box({1, 1, 0.1}, 20);
  box.initial = support::Random(3).state(0, 2);
  box.locked = {true, true, false, true, true, true};
  box.initial = {.orientation = box.initial.orientation, .linear_velocity = {0, 0, 2}};
  const hydro::Wrench drag = drag_on(box);
  const double expected = kStep * std::abs(drag.force.z()) / (box.mass * 2);
  EXPECT_NEAR(engine::drag_stiffness(box, box.initial, Vector3d::Zero(), drag, kStep), expected,
              tolerance(1e-13 * expected));
}

TEST(StiffDrag, NeverAddsEnergyHoweverLightTheBody) {
  support::Random random(5);
  for (const double density : {0.01, 1.0, 10.0}) {
    BodySpec box = dragged_box({1, 0.7, 0.05}, density);
    box.initial = random.state(1, 20);
    const SimulationSpec spec = weightless(box);
    Simulation simulation(spec);
    double before = support::energy(spec, simulation.states());
    const double start = before;
    for (int i = 0; i < 100; ++i) {
      simulation.step();
      const double now = support::energy(spec, simulation.states());
      ASSERT_LE(now, before * (1 + 1e-12)) << density << ", step " << i;
      before = now;
    }
    EXPECT_LT(before, 0.01 * start);
    EXPECT_GT(simulation.stiff_steps()[0], 0);
  }
}

TEST(StiffDrag, ABodyMuchLighterThanWaterRisesAtItsTerminalVelocity) {
  for (const double density : {1.0, 20.0, 80.0}) {
    BodySpec cube = dragged_box({0.1, 0.1, 0.1}, density);
    cube.coefficients.buoyancy = true;
    cube.locked = {false, false, false, true, true, true};  // face-on is not a stable attitude
    SimulationSpec spec = support::dry_world({cube}, kStep);
    spec.sea = deep_water();
    const double rise = support::after(spec, 120).states()[0].linear_velocity.z();
    const hydro::PressureDrag& c = cube.coefficients.pressure_drag;
    const double balance = (kDensity - density) * support::kGravity * 0.1;
    const double terminal = std::sqrt(balance / (0.5 * kDensity * (c.front + c.back)));
    // 2 s are 20 and more times m/(2 k v): what is left of the start is below 1e-9.
    EXPECT_NEAR(rise, terminal, tolerance(1e-9 * terminal)) << density;
  }
}

TEST(StiffDrag, BodiesHeavyForTheirSizeAreLeftToTheExplicitStep) {
  BodySpec cube = dragged_box({1, 1, 1}, 500);
  cube.initial.linear_velocity = {0, 0, -6};
  EXPECT_EQ(support::after(weightless(cube), 50).stiff_steps()[0], 0);
}

TEST(StiffDrag, JointedBodiesAreLeftToTheExplicitStep) {
  BodySpec light = dragged_box({1, 1, 1}, 1);
  light.initial.linear_velocity = {0, 0, 5};
  SimulationSpec spec = weightless(light);
  EXPECT_GT(support::after(spec, 3).stiff_steps()[0], 0);
  BodySpec heavy = support::box_body("heavy", {1, 1, 1}, 1e6, {0, 0, 2});
  spec.bodies.push_back(heavy);
  spec.joints.push_back({.type = engine::JointSpec::Type::fixed, .first = 0, .second = 1});
  EXPECT_EQ(support::after(spec, 3).stiff_steps()[0], 0);
}

}  // namespace

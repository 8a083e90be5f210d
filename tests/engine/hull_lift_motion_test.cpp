#include "hydro/added_mass/constant_added_mass.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/loads/hull_lift.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/engine/prelude.h"
#include "tests/support/meshes.h"

/// Slender hulls under way, with the lift that their sterns shed.

namespace {

using engine::BodyForces;

/// A body of the water's density times `density` that is wet and has added mass.
BodySpec afloat(const std::string& name, const hydro::TriMesh& mesh, double density) {
  BodySpec body = support::box_body(name, {1, 1, 1}, density, {0, 0, 0});
  body.mesh_B = mesh;
  const hydro::SolidProperties solid = hydro::solid_properties(mesh);
  body.mass = density * std::abs(solid.volume);
  const Vector3d size = hydro::bounding_box(mesh).sizes();
  const Vector3d squares = size.cwiseAbs2();
  body.inertia_B =
      body.mass / 12 *
      Vector3d(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y())
          .asDiagonal();
  body.wet = true;
  const hydro::AddedMassSolution solution = hydro::solve_added_mass(mesh, {.tolerance = 1e3});
  body.added_mass = std::make_shared<hydro::WettedAddedMass>(mesh, solution);
  body.coefficients = hydro::for_mesh(body.coefficients, mesh, 1e-6);
  return body;
}

SimulationSpec in_calm(BodySpec body, double step) {
  SimulationSpec spec = support::dry_world({std::move(body)}, step);
  spec.sea = hydro::Sea{.density = 1000, .gravity = kGravity};
  spec.record_work = true;
  return spec;
}

/// Two hulls of 5 m, half under water and 2 m apart, with the added mass that `plimsoll radiation`
/// finds for them at high frequency.
BodySpec catamaran() {
  const hydro::TriMesh hull = hydro::make_box({5, 0.45, 0.3}, 2);
  BodySpec body = afloat(
      "catamaran",
      support::united(hydro::translated(hull, {0, 1, 0}), hydro::translated(hull, {0, -1, 0})),
      500);
  Vector6d added;
  added << 14.4, 177.6, 1086.1, 1059.5, 1997.4, 375.9;
  body.added_mass =
      std::make_shared<hydro::ConstantAddedMass>(body.mesh_B, Matrix6d(added.asDiagonal()));
  return body;
}

double heading(const BodyState& state) {
  const Vector3d ahead = state.orientation * Vector3d::UnitX();
  return std::atan2(ahead.y(), ahead.x());
}

// With Munk's moment alone a disturbance of 0.01 rad/s turns it by more than 100 degrees.
TEST(HullLiftMotion, KeepsACatamaranOnItsCourse) {
  for (const double thrust : {20.0, 80.0, 320.0}) {
    BodySpec body = catamaran();
    body.initial.angular_velocity.z() = 0.01;
    body.loads = {{.force = {thrust, 0, 0}, .in_body_frame = true, .at_B = {-2.3, 0, -0.1}}};
    Simulation simulation(in_calm(body, 0.05));
    double most = 0;
    for (int i = 0; i < 1200; ++i) {
      simulation.step();
      most = std::max(most, std::abs(heading(simulation.states()[0])));
    }
    const double speed = simulation.states()[0].linear_velocity.norm();
    EXPECT_LT(most, tolerance(7 * M_PI / 180)) << thrust << " N, " << speed << " m/s";
  }
}

TEST(HullLiftMotion, OfAHeldHullInACurrentIsThatOfOneThatMovesThroughStillWater) {
  BodySpec body = catamaran();
  body.locked = engine::kAllDofs;
  SimulationSpec spec = in_calm(body, 0.05);
  spec.sea->current = {-2, 0.1, 0};
  const hydro::Wrench held = Simulation(spec).forces()[0].water.hull_lift;
  body.locked = {};
  body.initial.linear_velocity = {2, -0.1, 0};
  const hydro::Wrench moving = Simulation(in_calm(body, 0.05)).forces()[0].water.hull_lift;
  EXPECT_GT(held.force.norm(), 10);
  EXPECT_LT((held.force - moving.force).norm(), tolerance(1e-12 * held.force.norm()));
  EXPECT_LT((held.moment - moving.moment).norm(), tolerance(1e-12 * held.moment.norm()));
}

TEST(HullLiftMotion, HasNoPartInAnIdealFluid) {
  BodySpec body = catamaran();
  body.initial.linear_velocity = {2, -0.1, 0};
  body.coefficients.pressure_drag = {0, 0};
  const BodyForces forces = Simulation(in_calm(body, 0.05)).forces()[0];
  EXPECT_TRUE(forces.water.hull_lift.force.isZero(0));
}

// The rate at which the lift takes the sideways motion is of the order of U/L = 15 per second.
TEST(HullLiftMotion, OfALightBodyAtSpeedIsStableInLongSteps) {
  for (const double step : {1.0 / 15, 1.0 / 60}) {
    BodySpec body = afloat("fish", hydro::make_box({0.4, 0.04, 0.05}, 2), 100);
    body.mass *= 10;  // its weight is its buoyancy, its inertia that of a light shell
    body.initial.position.z() = -5;
    body.initial.linear_velocity = {6, 1, 0.5};
    body.initial.angular_velocity = {0, 1, 2};
    Simulation simulation(in_calm(body, step));
    double last = simulation.states()[0].linear_velocity.norm();
    for (int i = 0; i < 150; ++i) {
      simulation.step();
      const double speed = simulation.states()[0].linear_velocity.norm();
      EXPECT_LT(speed, last + 0.3) << i;
      last = speed;
    }
    const engine::Works works = simulation.forces()[0].works;
    EXPECT_LT(last, 2);
    EXPECT_LT(works.hull_lift, 0);
    EXPECT_LT(works.clamped_share(), 0.01);
  }
}

}  // namespace

#include "engine/base/body_check.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "tests/engine/prelude.h"
#include "tests/support/radiating_sphere.h"

namespace {

using testing::HasSubstr;
using testing::Property;
using testing::Throws;
using testing::ThrowsMessage;

BodySpec sound() { return support::box_body("crate", {1, 2, 3}, 100, {0, 0, 0}); }

TEST(BodyCheck, AcceptsASolid) { EXPECT_NO_THROW(engine::check_body(sound())); }

// A lamina is the limit of a solid: one principal moment is the sum of the others.
TEST(BodyCheck, AcceptsALamina) {
  BodySpec body = sound();
  body.inertia_B = Eigen::Vector3d(1, 2, 3).asDiagonal();
  EXPECT_NO_THROW(engine::check_body(body));
}

TEST(BodyCheck, RefusesWhatNoSolidCouldBeAndSaysWhy) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Fault {
    std::function<void(BodySpec&)> make;
    std::string message;
  };
  const std::vector<Fault> faults = {
      {[](BodySpec& b) { b.mass = 0; }, "the mass is 0 kg"},
      {[](BodySpec& b) { b.mass = -5; }, "the mass is -5 kg"},
      {[nan](BodySpec& b) { b.mass = nan; }, "the mass is nan kg"},
      {[](BodySpec& b) { b.inertia_B(0, 1) += 1e3; }, "not symmetric"},
      {[](BodySpec& b) { b.inertia_B *= -1; }, "not positive"},
      {[](BodySpec& b) { b.inertia_B = Eigen::Vector3d(1, 2, 3.1).asDiagonal(); }, "no solid"},
      {[nan](BodySpec& b) { b.inertia_B(2, 2) = nan; }, "the inertia is not finite"},
      {[nan](BodySpec& b) { b.initial.position.z() = nan; }, "the position's z is nan"},
      {[](BodySpec& b) { b.initial.orientation.coeffs() *= 2; }, "not a unit quaternion"},
      {[nan](BodySpec& b) { b.mesh_B.vertices(0, 0) = nan; }, "vertex"},
      {[](BodySpec& b) { b.mesh_B.vertices(0, 0) = 1e300; }, "beyond all bounds"},
      {[](BodySpec& b) {
         b.collision = engine::CollisionShape::mesh;
         b.mesh_B = {};
       },
       "no triangles"},
      {[](BodySpec& b) {
         b.radiation =
             std::make_shared<hydro::FloatingBody>(b.mesh_B, support::radiating_sphere(1));
       },
       "no added mass"},
  };
  for (const Fault& fault : faults) {
    BodySpec body = sound();
    fault.make(body);
    EXPECT_THAT([&] { engine::check_body(body); },
                ThrowsMessage<std::invalid_argument>(
                    testing::AllOf(HasSubstr("body 'crate'"), HasSubstr(fault.message))));
  }
}

// The engine's collision pass would stop at coordinates that it cannot number.
TEST(GroundCheck, RefusesGroundBeyondAllBounds) {
  engine::MeshGround mesh = support::slope(0, 0, 1);
  EXPECT_NO_THROW(engine::check_ground(mesh));
  EXPECT_NO_THROW(engine::check_ground(engine::PlaneGround{-1e8}));
  EXPECT_THROW(engine::check_ground(engine::PlaneGround{1e300}), std::invalid_argument);
  mesh.mesh_W.vertices(2, 0) = -1e300;
  EXPECT_THROW(engine::check_ground(mesh), std::invalid_argument);
  engine::SimulationSpec spec = support::dry_world({sound()}, 0.01);
  spec.ground = mesh;
  EXPECT_THROW(engine::Simulation{spec}, std::invalid_argument);
}

TEST(BodyCheck, GuardsTheSimulation) {
  BodySpec body = sound();
  body.mass = 0;
  EXPECT_THROW(engine::Simulation(support::dry_world({body}, 0.01)), std::invalid_argument);
}

}  // namespace

// Three crates fall into the water onto each other and a floor, one of them hinged to the world;
// prints their states after two seconds with all digits.
#include <fmt/format.h>

#include "engine/simulation.h"
#include "hydro/mesh/primitives.h"

int main() {
  engine::SimulationSpec spec;
  spec.sea = hydro::Sea{};
  spec.ground = engine::PlaneGround{-1};
  for (int i = 0; i < 3; ++i) {
    engine::BodySpec body{.name = fmt::format("crate{}", i), .mesh_B = hydro::make_box({1, 1, 1})};
    body.mass = 300 + 500 * i;
    body.inertia_B = body.mass / 6 * Eigen::Matrix3d::Identity();
    body.coefficients = hydro::for_mesh({}, body.mesh_B, 1e-6);
    body.initial.position = {0.3 * i, 0.1 * i, 0.2 + 1.2 * i};
    body.initial.angular_velocity = {0, 1.0 * i, 0.5};
    spec.bodies.push_back(body);
  }
  spec.joints.push_back({.name = "hinge",
                         .type = engine::JointSpec::Type::hinge,
                         .first = engine::kWorld,
                         .second = 0,
                         .anchor_W = {-0.5, 0, 0},
                         .axis_W = Eigen::Vector3d::UnitY()});
  engine::Simulation simulation(spec);
  for (int i = 0; i < 120; ++i) simulation.step();
  for (const hydro::BodyState& state : simulation.states())
    for (const double number : state.position) fmt::print("{:a}\n", number);
}

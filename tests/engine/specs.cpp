#include "tests/engine/specs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/motion/energy.h"
#include "hydro/mesh/primitives.h"

namespace support {
namespace {

engine::BodySpec body(const std::string& name, hydro::TriMesh mesh_B, double mass,
                      const Eigen::Vector3d& moments, const Eigen::Vector3d& position) {
  engine::BodySpec spec;
  spec.name = name;
  spec.mesh_B = std::move(mesh_B);
  spec.mass = mass;
  spec.inertia_B = moments.asDiagonal();
  spec.initial.position = position;
  spec.wet = false;
  spec.collision = engine::CollisionShape::none;
  return spec;
}

Eigen::Matrix3d inertia_W(const engine::BodySpec& body, const hydro::BodyState& state) {
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  return R_WB * body.inertia_B * R_WB.transpose();
}

}  // namespace

engine::BodySpec box_body(const std::string& name, const Eigen::Vector3d& size, double density,
                          const Eigen::Vector3d& position, int divisions) {
  const double mass = density * size.prod();
  const Eigen::Vector3d squares = size.cwiseAbs2();
  const Eigen::Vector3d moments = mass / 12 * (squares.sum() * Eigen::Vector3d::Ones() - squares);
  return body(name, hydro::make_box(size, divisions), mass, moments, position);
}

engine::BodySpec sphere_body(const std::string& name, double radius, double density,
                             const Eigen::Vector3d& position) {
  const double mass = density * 4 / 3 * std::numbers::pi * std::pow(radius, 3);
  const Eigen::Vector3d moments = 0.4 * mass * radius * radius * Eigen::Vector3d::Ones();
  return body(name, hydro::make_icosphere(radius, 2), mass, moments, position);
}

engine::SimulationSpec dry_world(std::vector<engine::BodySpec> bodies, double step) {
  engine::SimulationSpec spec;
  spec.step = step;
  spec.gravity = kGravity;
  spec.bodies = std::move(bodies);
  return spec;
}

engine::SimulationSpec box_in_still_water(const Eigen::Vector3d& position) {
  engine::BodySpec box = box_body("box", {1, 1, 1}, 500, position, 2);
  box.wet = true;
  engine::SimulationSpec spec = dry_world({box}, kStep);
  spec.sea = hydro::Sea{.density = 1000, .gravity = kGravity};
  return spec;
}

engine::SimulationSpec left_to_the_solver(engine::SimulationSpec spec) {
  using Type = engine::JointSpec::Type;
  for (const engine::JointSpec& joint : std::vector(spec.joints)) {
    spec.joints.push_back(joint);
    // The anchor of a hinge lies on its axis.
    if (joint.type == Type::hinge) spec.joints.back().type = Type::ball;
  }
  return spec;
}

engine::MeshGround slope(double angle, double heading, int cells) {
  constexpr double kLength = 100;
  hydro::TriMesh mesh;
  mesh.vertices.resize(3, (cells + 1) * (cells + 1));
  mesh.faces.resize(3, 2 * cells * cells);
  int face = 0;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const int corner = j * (cells + 1) + i;
      const double x = kLength * (static_cast<double>(i) / cells - 0.5);
      const double y = kLength * (static_cast<double>(j) / cells - 0.5);
      const double along = x * std::cos(heading) + y * std::sin(heading);
      mesh.vertices.col(corner) << x, y, -along * std::tan(angle);
      if (i == cells || j == cells) continue;
      mesh.faces.col(face++) << corner, corner + 1, corner + cells + 2;
      mesh.faces.col(face++) << corner, corner + cells + 2, corner + cells + 1;
    }
  }
  return {mesh};
}

Eigen::Quaterniond lying_on_slope(double angle, double heading) {
  const Eigen::Vector3d axis(-std::sin(heading), std::cos(heading), 0);
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

double energy(const engine::SimulationSpec& spec, const std::vector<hydro::BodyState>& states) {
  double sum = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const engine::BodySpec& body = spec.bodies[i];
    const hydro::BodyState& state = states[i];
    sum += body.mass * spec.gravity * state.position.z() +
           body.mass / 2 * state.linear_velocity.squaredNorm() +
           state.angular_velocity.dot(spin(body, state)) / 2;
  }
  return sum;
}

double total_energy(const engine::SimulationSpec& spec,
                    const std::vector<hydro::BodyState>& states) {
  const std::vector<engine::Body> bodies = engine::make_bodies(spec);
  double sum = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!bodies[i].movable) continue;
    engine::Motion motion{.state = states[i]};
    motion.added_B = engine::added_mass(bodies[i], states[i], nullptr, 0);
    sum += engine::kinetic_energy(bodies[i], motion, bodies[i].current()) +
           engine::potential_energy(bodies[i], motion);
  }
  return sum;
}

std::vector<engine::MovingBody> moving_bodies(const engine::SimulationSpec& spec) {
  std::vector<engine::MovingBody> moving;
  for (engine::Body& body : engine::make_bodies(spec)) {
    engine::Motion motion = engine::motion_at(body, spec, body.spec->initial, 0);
    moving.push_back({.body = std::move(body),
                      .motion = std::move(motion),
                      .inputs = {},
                      .cache = {},
                      .counts = {}});
  }
  return moving;
}

double distance(const hydro::BodyState& a, const hydro::BodyState& b) {
  return std::max((a.position - b.position).norm(),
                  2 * (a.orientation * b.orientation.conjugate()).vec().norm());
}

Eigen::Vector3d spin(const engine::BodySpec& body, const hydro::BodyState& state) {
  return inertia_W(body, state) * state.angular_velocity;
}

engine::Simulation after(engine::SimulationSpec spec, long steps) {
  engine::Simulation simulation(std::move(spec));
  for (long i = 0; i < steps; ++i) simulation.step();
  return simulation;
}

long steps_in(double time, double step) { return std::lround(time / step); }

}  // namespace support

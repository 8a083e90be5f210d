#include "tests/stress/arrangement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hydro/mesh/primitives.h"
#include "tests/stress/rigging.h"

namespace stress {
namespace {

using Eigen::Vector3d;
using engine::BodySpec;
using Joint = engine::JointSpec::Type;

Eigen::AlignedBox3d box_W(const BodySpec& body) {
  Eigen::AlignedBox3d box;
  const Eigen::Matrix3d R_WB = body.initial.orientation.toRotationMatrix();
  for (Eigen::Index i = 0; i < body.mesh_B.vertex_count(); ++i)
    box.extend(R_WB * body.mesh_B.vertices.col(i));
  return box;
}

void add_copies(const BodySpec& body, int count, const Vector3d& offset, Scenario& scenario) {
  for (int i = 0; i < count; ++i) {
    scenario.spec.bodies.push_back(body);
    scenario.spec.bodies.back().name = fmt::format("body{}", i + 1);
    scenario.spec.bodies.back().initial.position += i * offset;
  }
}

void join(Joint type, engine::BodyId first, engine::BodyId second, const Vector3d& anchor,
          const Vector3d& axis, Scenario& scenario) {
  scenario.spec.joints.push_back({.name = fmt::format("joint{}", scenario.spec.joints.size() + 1),
                                  .type = type,
                                  .first = first,
                                  .second = second,
                                  .anchor_W = anchor,
                                  .axis_W = axis});
}

void tie_to_world(Joint type, const Vector3d& axis, const BodySpec& body, Scenario& scenario) {
  add_copies(body, 1, Vector3d::Zero(), scenario);
  const Vector3d arm = scenario.size * Vector3d(0.3, 0.2, 0.6);
  join(type, engine::kWorld, 0, body.initial.position + arm, axis, scenario);
}

void add_chain(const BodySpec& body, Scenario& scenario) {
  const Vector3d offset = 1.5 * scenario.size * Vector3d(0.8, 0, -0.6);
  add_copies(body, 3, offset, scenario);
  for (int i = 0; i < 3; ++i)
    join(Joint::ball, i - 1, i, body.initial.position + (i - 0.5) * offset, Vector3d::UnitZ(),
         scenario);
}

double floor_height(const BodySpec& body) {
  return std::min(0.0, body.initial.position.z()) + lowest(body);
}

/// Returns round hills whose heights differ by 0.8 sizes; the body is above the top of one.
engine::MeshGround hills(double top, double size) {
  constexpr int kCells = 24;
  engine::MeshGround ground;
  hydro::TriMesh& mesh = ground.mesh_W;
  mesh.vertices.resize(3, (kCells + 1) * (kCells + 1));
  mesh.faces.resize(3, 2 * kCells * kCells);
  int face = 0;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const int corner = j * (kCells + 1) + i;
      const double x = i - kCells / 2, y = j - kCells / 2;
      const double drop = 0.2 * (2 - std::cos(x) - std::cos(y));
      mesh.vertices.col(corner) << size * x, size * y, top - size * drop;
      if (i == kCells || j == kCells) continue;
      mesh.faces.col(face++) << corner, corner + 1, corner + kCells + 2;
      mesh.faces.col(face++) << corner, corner + kCells + 2, corner + kCells + 1;
    }
  }
  return ground;
}

void add_wall(const BodySpec& body, Scenario& scenario) {
  add_copies(body, 1, Vector3d::Zero(), scenario);
  const double size = scenario.size;
  BodySpec wall{.name = "wall", .mesh_B = hydro::make_box(size * Vector3d(4, 40, 40)), .mass = 1};
  wall.initial.position = body.initial.position;
  wall.initial.position.x() += box_W(body).max().x() + 2.001 * size;
  wall.wet = false;
  wall.locked.fill(true);
  scenario.spec.bodies.push_back(wall);
  scenario.push = {body.mass * scenario.spec.gravity, 0, 0};
  scenario.spec.bodies[0].loads.push_back({.force = scenario.push});
}

void add_stack(const BodySpec& body, double top_factor, Scenario& scenario) {
  add_copies(body, 3, 1.001 * box_W(body).sizes().z() * Vector3d::UnitZ(), scenario);
  BodySpec& top = scenario.spec.bodies.back();
  top.mass *= top_factor;
  top.inertia_B *= top_factor;
  scenario.spec.ground = engine::PlaneGround{floor_height(body)};
}

}  // namespace

double lowest(const BodySpec& body) { return box_W(body).min().z(); }

void arrange(const std::string& with, const BodySpec& body, Scenario& scenario) {
  if (is_rigged(with)) {
    const bool two = with == "rope" || with == "spring";
    arrange(two ? "two" : with == "driven" ? "hinged" : "free", body, scenario);
    return rig(with, scenario);
  }
  const Vector3d level_axis(0.6, 0.8, 0);
  if (with == "pinned") return tie_to_world(Joint::ball, level_axis, body, scenario);
  if (with == "hinged") return tie_to_world(Joint::hinge, level_axis, body, scenario);
  if (with == "slider") return tie_to_world(Joint::slider, Vector3d::UnitZ(), body, scenario);
  if (with == "chain") return add_chain(body, scenario);
  if (with == "wall") return add_wall(body, scenario);
  if (with == "stack") return add_stack(body, 1, scenario);
  if (with == "overload") return add_stack(body, 100, scenario);
  const Vector3d aside = 1.5 * scenario.size * Vector3d::UnitX();
  add_copies(body, with == "fixed" || with == "two" ? 2 : 1, aside, scenario);
  if (with == "fixed")
    join(Joint::fixed, 0, 1, body.initial.position + aside / 2, Vector3d::UnitZ(), scenario);
  else if (with == "locked")
    scenario.spec.bodies[0].locked = {true, true, false, false, false, true};
  else if (with == "floor")
    scenario.spec.ground = engine::PlaneGround{floor_height(body)};
  else if (with == "terrain")
    scenario.spec.ground = hills(floor_height(body), scenario.size);
  else if (with != "free" && with != "two")
    throw std::invalid_argument(fmt::format("'{}' is nothing that a body can be with", with));
}

}  // namespace stress

#include "engine/contacts/world.h"

#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <limits>

#include "engine/base/body_check.h"
#include "engine/base/constants.h"
#include "engine/contacts/ode_world.h"
#include "engine/motion/locks.h"

namespace engine {
namespace {

void place(dxGeom* geom, const hydro::BodyState& state, const Eigen::Vector3d& center_B) {
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Eigen::Vector3d center_W = R_WB * center_B + state.position;
  dGeomSetPosition(geom, center_W.x(), center_W.y(), center_W.z());
  dGeomSetRotation(geom, to_ode(R_WB).data());
}

}  // namespace

World::World(double gravity) : gravity_(gravity) {
  open_ode();
  world_.reset(dWorldCreate());
  dWorldSetGravity(world_.get(), 0, 0, -gravity);
  dWorldSetERP(world_.get(), kJointErp);
  dWorldSetAutoDisableFlag(world_.get(), 0);
  space_.reset(dSimpleSpaceCreate(nullptr));
  contact_joints_.reset(dJointGroupCreate(0));
}

BodyId World::add_body(const BodySpec& spec, bool collides) {
  check_body(spec);
  Body body{.mass = spec.mass,
            .initial = without_locked_motion(spec.locked, spec.initial),
            .load = {},
            .inertia = {.mass = spec.mass, .acceleration = {0, 0, -gravity_}}};
  if (!immovable(spec.locked)) body.handle = create_body(spec);
  if (collides && spec.collision != CollisionShape::none) add_shape(body, spec);
  bodies_.push_back(body);
  return static_cast<BodyId>(bodies_.size()) - 1;
}

dxBody* World::create_body(const BodySpec& spec) {
  soften_joints(spec);
  dxBody* body = dBodyCreate(world_.get());
  set_mass(body, spec.mass, spec.inertia_B);
  // This mode turns by exactly |ω| h about ω; ODE's default, a normalised first-order step, by
  // less.
  dBodySetFiniteRotationMode(body, 1);
  place(body, without_locked_motion(spec.locked, spec.initial));
  if (partly_locked(spec.locked)) add_lock_motors(body, spec);
  return body;
}

void World::soften_joints(const BodySpec& spec) {
  const Eigen::Vector3d moments = spec.inertia_B.diagonal();
  lightest_ = std::min({lightest_, spec.mass, moments.minCoeff()});
  heaviest_ = std::max({heaviest_, spec.mass, moments.maxCoeff()});
  dWorldSetCFM(world_.get(),
               std::min(kComplianceOfLightest / lightest_, kComplianceOfHeaviest / heaviest_));
}

void World::add_shape(Body& body, const BodySpec& spec) {
  body.shape_B = hydro::bounding_box(spec.mesh_B);
  Eigen::Vector3d center = body.shape_B.center();
  const Eigen::Vector3d size = body.shape_B.sizes();
  if (spec.collision == CollisionShape::mesh) {
    body.geom = create_trimesh(spec.mesh_B);
    center.setZero();
  } else if (spec.collision == CollisionShape::box) {
    body.geom = dCreateBox(space_.get(), size.x(), size.y(), size.z());
  } else {
    const double radius = (spec.mesh_B.vertices.colwise() - center).colwise().norm().maxCoeff();
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(radius);
    body.geom = dCreateSphere(space_.get(), radius);
    body.shape_B = {center - half, center + half};
  }
  if (!body.handle) return place(body.geom, body.initial, center);
  dGeomSetBody(body.geom, body.handle);
  dGeomSetOffsetPosition(body.geom, center.x(), center.y(), center.z());
}

dxGeom* World::create_trimesh(const hydro::TriMesh& mesh) {
  const auto known = std::find_if(meshes_.begin(), meshes_.end(), [&](const auto& other) {
    return hydro::same_mesh(other->mesh, mesh);
  });
  if (known != meshes_.end())
    return dCreateTriMesh(space_.get(), (*known)->data.get(), nullptr, nullptr, nullptr);
  meshes_.push_back(std::make_unique<CollisionMesh>());
  CollisionMesh& kept = *meshes_.back();
  kept.mesh = mesh;
  kept.data.reset(dGeomTriMeshDataCreate());
  static_assert(sizeof(dTriIndex) == sizeof(int), "ODE reads the faces as they are");
  dGeomTriMeshDataBuildDouble(kept.data.get(), kept.mesh.vertices.data(), 3 * sizeof(double),
                              static_cast<int>(mesh.vertex_count()), kept.mesh.faces.data(),
                              static_cast<int>(mesh.faces.size()), 3 * sizeof(dTriIndex));
  return dCreateTriMesh(space_.get(), kept.data.get(), nullptr, nullptr, nullptr);
}

void World::add_lock_motors(dxBody* body, const BodySpec& spec) {
  dxJoint* linear = dJointCreateLMotor(world_.get(), nullptr);
  dxJoint* angular = dJointCreateAMotor(world_.get(), nullptr);
  dJointAttach(linear, body, nullptr);
  dJointAttach(angular, body, nullptr);
  const double unlimited = std::numeric_limits<double>::infinity();
  // ODE numbers the parameters of a motor's axes in groups: FMax1, FMax2, FMax3.
  int linear_axes = 0;
  int angular_axes = 0;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
    if (spec.locked[i]) {
      dJointSetLMotorNumAxes(linear, linear_axes + 1);
      dJointSetLMotorAxis(linear, linear_axes, 0, axis.x(), axis.y(), axis.z());
      dJointSetLMotorParam(linear, dParamFMax + dParamGroup * linear_axes++, unlimited);
    }
    if (spec.locked[3 + i]) {
      dJointSetAMotorNumAxes(angular, angular_axes + 1);
      dJointSetAMotorAxis(angular, angular_axes, 0, axis.x(), axis.y(), axis.z());
      dJointSetAMotorParam(angular, dParamFMax + dParamGroup * angular_axes++, unlimited);
    }
  }
}

void World::add_ground(const Ground& ground) {
  check_ground(ground);
  if (const auto* plane = std::get_if<PlaneGround>(&ground))
    ground_ = dCreatePlane(space_.get(), 0, 0, 1, plane->z);
  if (const auto* mesh = std::get_if<MeshGround>(&ground)) ground_ = create_trimesh(mesh->mesh_W);
}

bool World::can_collide() const {
  const auto collides = [](const Body& body) { return body.geom != nullptr; };
  const auto moves = [](const Body& body) { return body.geom && body.handle; };
  const auto things = std::count_if(bodies_.begin(), bodies_.end(), collides) + (ground_ ? 1 : 0);
  return things > 1 && std::any_of(bodies_.begin(), bodies_.end(), moves);
}

const Eigen::AlignedBox3d& World::shape_box(BodyId body) const { return bodies_.at(body).shape_B; }

dxBody* World::handle_of(BodyId id) const { return id == kWorld ? nullptr : bodies_.at(id).handle; }

dxGeom* World::geom_of(BodyId id) const { return id == kWorld ? ground_ : bodies_.at(id).geom; }

hydro::BodyState World::state(BodyId id) const {
  dxBody* body = handle_of(id);
  if (!body) return bodies_.at(id).initial;
  return {.position = vector_from_ode(dBodyGetPosition(body)),
          .orientation = quaternion_from_ode(dBodyGetQuaternion(body)),
          .linear_velocity = vector_from_ode(dBodyGetLinearVel(body)),
          .angular_velocity = vector_from_ode(dBodyGetAngularVel(body))};
}

void World::set_state(BodyId id, const hydro::BodyState& state) {
  if (dxBody* body = handle_of(id)) place(body, state);
}

void World::apply(BodyId id, const hydro::Wrench& load) {
  Body& body = bodies_.at(id);
  body.load += load;
  body.inertia.acceleration = body.load.force / body.mass - gravity_ * Eigen::Vector3d::UnitZ();
}

bool World::advance(double step) {
  open_ode();
  std::vector<hydro::BodyState> before;
  for (std::size_t i = 0; i < bodies_.size(); ++i) before.push_back(state(static_cast<BodyId>(i)));
  const auto set_loads = [this] {
    for (const Body& body : bodies_) {
      if (!body.handle) continue;
      const auto& [force, moment] = body.load;
      dBodySetForce(body.handle, force.x(), force.y(), force.z());
      dBodySetTorque(body.handle, moment.x(), moment.y(), moment.z());
    }
  };
  const auto restart = [&] {
    for (std::size_t i = 0; i < before.size(); ++i) set_state(static_cast<BodyId>(i), before[i]);
    set_loads();
  };
  set_loads();
  const bool compromised = step_or_fall_back(world_.get(), restart, step);
  for (Body& body : bodies_) body.load = {};
  return compromised;
}

}  // namespace engine

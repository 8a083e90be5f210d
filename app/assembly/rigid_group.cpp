#include "app/assembly/rigid_group.h"

#include <algorithm>
#include <numeric>

#include "app/assembly/build_interior.h"
#include "hydro/mesh/mesh_union.h"

namespace assembly {
namespace {

using Eigen::Vector3d;
using engine::BodyId;

bool is_fixed(const engine::JointSpec& joint) {
  return joint.type == engine::JointSpec::Type::fixed;
}

}  // namespace

std::vector<Eigen::Isometry3d> poses_in_lead(const std::vector<engine::BodySpec>& bodies,
                                             const RigidGroup& group, BodyId lead) {
  const hydro::BodyState& base = bodies[lead].initial;
  const Eigen::Quaterniond to_lead = base.orientation.conjugate();
  std::vector<Eigen::Isometry3d> X_LB;
  for (const BodyId id : group.bodies) {
    const hydro::BodyState& state = bodies[id].initial;
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    // Round-off would turn the lead.
    if (id != lead) X.linear() = (to_lead * state.orientation).toRotationMatrix();
    X.translation() = to_lead * (state.position - base.position);
    X_LB.push_back(X);
  }
  return X_LB;
}

std::vector<std::vector<BodyId>> groups_by(std::vector<engine::Pair> pairs, std::size_t count) {
  std::vector<BodyId> bodies(count);
  std::iota(bodies.begin(), bodies.end(), BodyId{0});
  // A pair of a body with itself makes a group of each.
  for (const BodyId body : bodies) pairs.emplace_back(body, body);
  return engine::connected_components(bodies, pairs);
}

bool has_buoyancy(const engine::BodySpec& body) { return body.wet && body.coefficients.buoyancy; }

std::vector<RigidGroup> rigid_groups(const engine::SimulationSpec& spec) {
  std::vector<engine::Pair> pairs;
  for (const engine::JointSpec& joint : spec.joints)
    if (is_fixed(joint)) pairs.push_back(std::minmax(joint.first, joint.second));
  std::vector<RigidGroup> groups;
  for (std::vector<BodyId>& members : groups_by(std::move(pairs), spec.bodies.size())) {
    RigidGroup group{.bodies = std::move(members), .joint_to_world = {}};
    for (const engine::JointSpec& joint : spec.joints) {
      if (!is_fixed(joint) || std::min(joint.first, joint.second) != engine::kWorld) continue;
      if (std::ranges::count(group.bodies, std::max(joint.first, joint.second)) > 0)
        group.joint_to_world = joint.name;
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

FloatingGroup floating_group(const engine::SimulationSpec& spec, const RigidGroup& group,
                             BodyId lead) {
  FloatingGroup joined{.mesh_G = {}, .tanks = {}, .X_GB = poses_in_lead(spec.bodies, group, lead)};
  Vector3d moment = Vector3d::Zero();
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    const double mass = spec.bodies[group.bodies[i]].mass;
    joined.mass += mass;
    moment += mass * joined.X_GB[i].translation();
  }
  std::vector<hydro::TriMesh> meshes;
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    const engine::BodySpec& body = spec.bodies[group.bodies[i]];
    Eigen::Isometry3d& X = joined.X_GB[i];
    X.translation() -= moment / joined.mass;
    if (has_buoyancy(body)) meshes.push_back(hydro::transformed(engine::outside_B(body), X));
    for (hydro::Tank& tank : tanks_of(body))
      joined.tanks.push_back(
          {.hull = hydro::make_hull(hydro::transformed(tank.hull.mesh_B, X), tank.hull.boundary),
           .volume = tank.volume});
  }
  joined.mesh_G = hydro::side_by_side(meshes);
  return joined;
}

}  // namespace assembly

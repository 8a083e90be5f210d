#include "app/assembly/build_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/assembly/build_interior.h"
#include "app/assembly/rest_states.h"
#include "app/assembly/rigid_group.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/statics/equilibrium.h"

namespace assembly {
namespace {

using engine::BodyId;

std::string start_path(BodyId body) { return fmt::format("bodies[{}].start", body); }

/// Returns the body of a group that has `start: equilibrium`; none if there is none. Adds a fault
/// for another one that has the key, since only one can keep its x, y and heading.
std::optional<BodyId> lead_of(const RigidGroup& group, BuildLog& log) {
  const std::vector<scene::Body>& bodies = log.scene.bodies;
  const auto lead = std::ranges::find_if(
      group.bodies, [&](BodyId id) { return bodies[id].start == scene::Start::equilibrium; });
  if (lead == group.bodies.end()) return std::nullopt;
  for (const BodyId id : group.bodies)
    if (id != *lead && log.scene.places.contains(start_path(id)))
      log.faults.add(
          log.scene.places, start_path(id),
          fmt::format("found {}, but fixed joints hold it to {}, which has equilibrium and takes "
                      "it along; expected the key at one of them",
                      bodies[id].start == scene::Start::equilibrium ? "equilibrium" : "given",
                      bodies[*lead].name));
  return *lead;
}

/// True if no fault has kept a body of the group from being made.
bool is_built(const RigidGroup& group, const engine::SimulationSpec& spec) {
  return std::ranges::all_of(group.bodies, [&](BodyId id) {
    return spec.bodies[id].mass > 0 && spec.bodies[id].mesh_B.vertex_count() > 0;
  });
}

/// True if the water alone may carry a group, until the rig is there.
bool floats_free(const engine::SimulationSpec& spec, const RigidGroup& group) {
  return std::ranges::all_of(group.bodies, [&](BodyId id) {
    const engine::DofMask& locked = spec.bodies[id].locked;
    const bool held = std::ranges::any_of(spec.joints, [&](const engine::JointSpec& joint) {
      return std::min(joint.first, joint.second) == engine::kWorld &&
             std::max(joint.first, joint.second) == id;
    });
    return !held && !locked[2] && !locked[3] && !locked[4];
  });
}

/// Moves the bodies of a group to where it floats. @param com_M   Of the lead.
void settle(const RigidGroup& group, BodyId lead, const Eigen::Vector3d& com_M,
            engine::SimulationSpec& spec, BuildLog& log) {
  const scene::Water& water = *log.scene.water;
  const FloatingGroup floating = floating_group(spec, group, lead);
  MassAfloat mass;
  for (const BodyId id : group.bodies) {
    mass.body += spec.bodies[id].mass;
    mass.water += mass_of_water_in(spec.bodies[id], water.density);
  }
  const std::string reason =
      why_not_afloat(mass, hydro::solid_properties(floating.mesh_G).volume, water.density);
  if (!reason.empty())
    return log.faults.add(
        log.scene.places, start_path(lead),
        group.bodies.size() == 1 ? reason : "with all that is fixed to it, " + reason);
  const Eigen::Quaterniond given = spec.bodies[lead].initial.orientation;
  const hydro::Flotation rest =
      hydro::equilibrium(floating.mesh_G, mass.sum() / water.density, given, floating.tanks);
  const Eigen::Quaterniond R_WG =
      hydro::with_heading(rest.orientation, hydro::euler_angles(given)[2]);
  const auto place =
      static_cast<std::size_t>(std::ranges::find(group.bodies, lead) - group.bodies.begin());
  const Eigen::Vector3d p_GL = floating.X_GB[place].translation();
  Eigen::Vector3d p_WG = log.scene.bodies[lead].position + R_WG * com_M - R_WG * p_GL;
  p_WG.z() = water.level + rest.height;
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    hydro::BodyState& state = spec.bodies[group.bodies[i]].initial;
    state.position = p_WG + R_WG * floating.X_GB[i].translation();
    state.orientation = group.bodies[i] == lead
                            ? R_WG
                            : (R_WG * given.conjugate() * state.orientation).normalized();
  }
}

/// Moves a group to its rest. Joints between its bodies go with them, and keep their coordinates:
/// that of a hinge or slider is zero in the pose that the scene gives.
void move_to(const Rest& rest, const HeldGroup& group, engine::SimulationSpec& spec) {
  for (std::size_t j = 0; j < spec.joints.size(); ++j) {
    engine::JointSpec& joint = spec.joints[j];
    const BodyId id = std::max(joint.first, joint.second);
    if (std::ranges::count(group.bodies, id) == 0) continue;
    joint.drive.rest -= rest.coordinates[j];
    if (joint.drive.limits)
      for (double& limit : *joint.drive.limits) limit -= rest.coordinates[j];
    if (std::min(joint.first, joint.second) == engine::kWorld) continue;
    const hydro::BodyState &from = spec.bodies[joint.first].initial, &to = rest.states[joint.first];
    const Eigen::Quaterniond turn = to.orientation * from.orientation.conjugate();
    joint.anchor_W = to.position + turn * (joint.anchor_W - from.position);
    joint.axis_W = turn * joint.axis_W;
    joint.axis2_W = turn * joint.axis2_W;
  }
  for (const BodyId id : group.bodies) {
    spec.bodies[id].initial.position = rest.states[id].position;
    spec.bodies[id].initial.orientation = rest.states[id].orientation;
  }
}

/// The name of a joint between a group and others; empty if there is none.
std::string joint_of(const engine::SimulationSpec& spec, const RigidGroup& group) {
  for (const engine::JointSpec& joint : spec.joints)
    if (std::ranges::count(group.bodies, joint.first) !=
        std::ranges::count(group.bodies, joint.second))
      return joint.name;
  return "";
}

}  // namespace

std::string why_not_afloat(const MassAfloat& mass, double volume, double density) {
  const double most = density * volume;
  // Round-off of a mesh's volume is larger than that of a double; within 1e-12 the masses are
  // equal.
  if (mass.sum() < (1 - 1e-12) * most) return "";
  const std::string water =
      mass.water > 0 ? fmt::format(", the water in it weighs {:.7g} kg,", mass.water) : "";
  return fmt::format(
      "it {}: its mass is {:.7g} kg{} and its volume of {:.7g} m^3 displaces {:.7g} kg",
      mass.sum() > (1 + 1e-12) * most ? "sinks" : "hovers in the water, as heavy as it", mass.body,
      water, volume, most);
}

std::vector<bool> starts_afloat(const scene::Scene& scene, const engine::SimulationSpec& spec) {
  std::vector<bool> afloat(spec.bodies.size(), false);
  for (const RigidGroup& group : rigid_groups(spec)) {
    const bool settles = std::ranges::any_of(group.bodies, [&](BodyId id) {
      return scene.bodies[id].start == scene::Start::equilibrium;
    });
    for (const BodyId id : group.bodies) afloat[id] = settles;
  }
  return afloat;
}

void put_afloat(const std::vector<Eigen::Vector3d>& centers_of_mass, engine::SimulationSpec& spec,
                BuildLog& log) {
  if (!log.scene.water) return;
  for (const RigidGroup& group : rigid_groups(spec)) {
    const std::optional<BodyId> lead = lead_of(group, log);
    if (lead && !group.joint_to_world.empty())
      log.faults.add(log.scene.places, start_path(*lead),
                     fmt::format("equilibrium needs z, roll or pitch to be free, but the joint {} "
                                 "fixes it to the world",
                                 group.joint_to_world));
    if (lead && is_built(group, spec) && floats_free(spec, group))
      settle(group, *lead, centers_of_mass[*lead], spec, log);
  }
}

void put_to_rest(engine::SimulationSpec& spec, BuildLog& log) {
  if (!log.scene.water) return;
  for (const HeldGroup& group : held_groups(spec)) {
    const auto lead = std::ranges::find_if(group.bodies, [&](BodyId id) {
      return log.scene.bodies[id].start == scene::Start::equilibrium;
    });
    if (lead == group.bodies.end() || group.holder.empty()) continue;
    if (const std::optional<Rest> rest = find_rest(spec, group))
      move_to(*rest, group, spec);
    else
      log.faults.add(log.scene.places, start_path(*lead),
                     fmt::format("{}, held by {}, does not come to rest within ten of its radii",
                                 spec.bodies[*lead].name, group.holder));
  }
}

void heel_over(engine::SimulationSpec& spec, BuildLog& log) {
  for (const RigidGroup& group : rigid_groups(spec))
    for (const BodyId lead : group.bodies) {
      const scene::Heel& heel = log.scene.bodies[lead].heel;
      if (heel.roll == 0 && heel.pitch == 0) continue;
      if (const std::string joint = joint_of(spec, group); !joint.empty()) {
        log.faults.add(log.scene.places, fmt::format("bodies[{}].heel", lead),
                       fmt::format("the joint {} holds {}; expected a body that no joint holds",
                                   joint, spec.bodies[lead].name));
        continue;
      }
      const hydro::BodyState about = spec.bodies[lead].initial;
      const Eigen::Quaterniond yaw(
          Eigen::AngleAxisd(hydro::euler_angles(about.orientation)[2], Eigen::Vector3d::UnitZ()));
      const Eigen::Quaterniond turn =
          yaw * Eigen::AngleAxisd(heel.pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(heel.roll, Eigen::Vector3d::UnitX()) * yaw.conjugate();
      for (const BodyId id : group.bodies) {
        hydro::BodyState& state = spec.bodies[id].initial;
        state.position = about.position + turn * (state.position - about.position);
        state.orientation = (turn * state.orientation).normalized();
      }
    }
}

}  // namespace assembly

#include "app/assembly/mean_pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/assembly/build_interior.h"
#include "app/assembly/radiation_store.h"
#include "engine/motion/locks.h"
#include "hydro/mesh/mesh_union.h"
#include "hydro/statics/equilibrium.h"

namespace assembly {
namespace {

using Eigen::Quaterniond;
using engine::BodyId;

/// Part of the hull's radius by which its centre of mass would sink against that of buoyancy on the
/// way to an attitude that does not matter [-]: a sphere of 50 slices has 4e-4.
constexpr double kNeutral = 5e-4;

/// Tilt between two attitudes above which a neutral hull keeps that of its start [rad].
constexpr double kNeutralTilt = 15 * M_PI / 180;

/// A pose of rest under constraints is rounded to this part of the radius, and of a radian: what
/// the engine leaves of the motion is less.
constexpr double kHeldStep = 1e-5;

/// Latest bodies with which one is compared that may float alike: more than there are kinds in a
/// scene of many bodies.
constexpr std::ptrdiff_t kMostRests = 64;

double radius_of(const hydro::TriMesh& mesh) {
  return std::sqrt(mesh.vertices.colwise().squaredNorm().maxCoeff());
}

/// Angle between the verticals of two attitudes [rad].
double tilt_between(const Quaterniond& a, const Quaterniond& b) {
  const Eigen::Vector3d up_a = a.conjugate() * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d up_b = b.conjugate() * Eigen::Vector3d::UnitZ();
  return std::atan2(up_a.cross(up_b).norm(), up_a.dot(up_b));
}

double displaced_volume(const hydro::TriMesh& mesh_B, const Quaterniond& R, double height) {
  return hydro::hydrostatics(hydro::transformed(mesh_B, Eigen::Isometry3d(R)), height).volume;
}

/// A hull at rest that the water alone carries, in its attitude at the start if that does not
/// matter to it.
FreeRest found_rest(const RadiatingHull& hull, const Quaterniond& start, double density) {
  const double volume = (hull.mass + hull.water) / density;
  hydro::TriMesh mesh = hull.mesh_B;  // about the centre of mass of the whole
  std::vector<hydro::Tank> tanks = hull.tanks_B;
  if (!hull.com_B.isZero(0)) {
    mesh = hydro::translated(std::move(mesh), -hull.com_B);
    for (hydro::Tank& tank : tanks)
      tank.hull =
          hydro::make_hull(hydro::translated(tank.hull.mesh_B, -hull.com_B), tank.hull.boundary);
  }
  const hydro::ImmersedMesh immersed(mesh);
  const hydro::Flotation held = hydro::afloat(immersed, volume, start, tanks);
  hydro::Flotation rest = hydro::equilibrium(immersed, volume, start, tanks);
  const double sinks = rest.effective_centre().z() - held.effective_centre().z();
  const bool neutral = sinks < kNeutral * immersed.radius();
  if (neutral && tilt_between(start, rest.orientation) > kNeutralTilt) rest = held;
  return {hull.lead, rest.orientation, rest.height - (rest.orientation * hull.com_B).z()};
}

/// True if two bodies float alike at rest, as copies do.
bool float_alike(const engine::BodySpec& a, const engine::BodySpec& b) {
  return a.mass == b.mass && a.interior_water.empty() && b.interior_water.empty() &&
         a.initial.orientation.coeffs() == b.initial.orientation.coeffs() &&
         hydro::same_mesh(outside_B(a), outside_B(b));
}

}  // namespace

RadiatingHull radiating_hull(const engine::SimulationSpec& spec, const RigidGroup& group,
                             BodyId lead) {
  RadiatingHull hull{.group = group, .lead = lead};
  const std::vector<Eigen::Isometry3d> poses = poses_in_lead(spec.bodies, group, lead);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const engine::BodySpec& part = spec.bodies[static_cast<std::size_t>(group.bodies[i])];
    const Eigen::Isometry3d& X_LB = poses[i];
    hull.parts_B.push_back(hydro::transformed(outside_B(part), X_LB));
    hull.mass += part.mass;
    hull.water += mass_of_water_in(part, spec.sea->density);
    hull.com_B += part.mass * X_LB.translation();
    for (hydro::Tank& tank : tanks_of(part))
      hull.tanks_B.push_back(
          {.hull = hydro::make_hull(hydro::transformed(tank.hull.mesh_B, X_LB), tank.hull.boundary),
           .volume = tank.volume});
  }
  hull.com_B /= hull.mass;
  hull.mesh_B = hydro::side_by_side(hull.parts_B);
  return hull;
}

WetSurface wet_surface(const engine::SimulationSpec& spec, const RadiatingHull& hull,
                       const hydro::MeanPose& pose) {
  const Eigen::Matrix3d R_HB = pose.orientation.toRotationMatrix();
  std::vector<hydro::TriMesh> wet;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < hull.parts_B.size(); ++i) {
    if (pose.height + (R_HB.row(2) * hull.parts_B[i].vertices).minCoeff() >= 0) continue;
    wet.push_back(hull.parts_B[i]);
    names.push_back(spec.bodies[static_cast<std::size_t>(hull.group.bodies[i])].name);
  }
  if (wet.size() == 1) return {.mesh_B = wet.front(), .fault = {}};
  for (std::size_t i = 0; i < wet.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (hydro::common_part(wet[j], wet[i]))
        return {.mesh_B = {},
                .fault = fmt::format("{} and {}, which fixed joints hold together, overlap",
                                     names[j], names[i])};
  return {.mesh_B = hydro::joined(wet), .fault = {}};
}

MeanPoses::MeanPoses(const engine::SimulationSpec& spec)
    : spec_(spec), groups_(held_groups(spec)), group_of_(spec.bodies.size()) {
  for (std::size_t g = 0; g < groups_.size(); ++g)
    for (const BodyId id : groups_[g].bodies) group_of_[static_cast<std::size_t>(id)] = g;
}

std::optional<hydro::BodyState> MeanPoses::held_rest(const RadiatingHull& hull, std::size_t group) {
  const auto [found, added] = rests_.try_emplace(group);
  if (added) found->second = find_rest(spec_, groups_[group]);
  if (!found->second) return std::nullopt;
  return found->second->states[static_cast<std::size_t>(hull.lead)];
}

std::string MeanPoses::holder(const RadiatingHull& hull) const {
  if (!hull.group.joint_to_world.empty())
    return fmt::format("the joint {}", hull.group.joint_to_world);
  return groups_[group_of_[static_cast<std::size_t>(hull.lead)]].holder;
}

FreeRest MeanPoses::free_rest(const RadiatingHull& hull) {
  const engine::BodySpec& body = spec_.bodies[static_cast<std::size_t>(hull.lead)];
  const bool single = hull.group.bodies.size() == 1;
  if (single) {
    const auto end = known_.rbegin() + std::min(kMostRests, std::ssize(known_));
    const auto alike = std::find_if(known_.rbegin(), end, [&](const FreeRest& rest) {
      return float_alike(spec_.bodies[static_cast<std::size_t>(rest.lead)], body);
    });
    if (alike != end) return *alike;
  }
  const FreeRest rest = found_rest(hull, body.initial.orientation, spec_.sea->density);
  if (single) known_.push_back(rest);
  return rest;
}

FoundPose MeanPoses::find(const RadiatingHull& hull,
                          const std::optional<scene::Radiation::Pose>& wanted) {
  const auto lead = static_cast<std::size_t>(hull.lead);
  const hydro::BodyState& start = spec_.bodies[lead].initial;
  const double level = spec_.sea->level, radius = radius_of(hull.mesh_B);
  const std::size_t group = group_of_[lead];
  FoundPose found{.holder = holder(hull)};
  const bool immovable =
      !hull.group.joint_to_world.empty() || engine::immovable(spec_.bodies[lead].locked);
  Quaterniond orientation = start.orientation;
  double height = start.position.z() - level, step = kPoseStep;
  if (wanted != scene::Radiation::Pose::start && !immovable) {
    if (found.holder.empty()) {
      const FreeRest rest = free_rest(hull);
      orientation = rest.orientation;
      height = rest.height;
      found.at_rest = true;
    } else if (const std::optional<hydro::BodyState> rest = held_rest(hull, group)) {
      orientation = rest->orientation;
      height = rest->position.z() - level;
      step = kHeldStep;
      found.at_rest = true;
    }
  }
  found.start_tilt = tilt_between(start.orientation, orientation);
  found.start_volume =
      displaced_volume(hull.mesh_B, start.orientation, start.position.z() - level) /
      displaced_volume(hull.mesh_B, orientation, height);
  found.pose =
      rounded({.orientation = hydro::with_heading(orientation, 0), .height = height}, radius, step);
  return found;
}

}  // namespace assembly

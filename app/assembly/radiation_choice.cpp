#include "app/assembly/radiation_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/assembly/build_interior.h"
#include "app/assembly/build_start.h"
#include "app/assembly/radiation_store.h"
#include "engine/broad_phase.h"
#include "engine/locks.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/statics/equilibrium.h"

namespace assembly {
namespace {

// Bounds of what starts afloat. Beyond them the start is a launch or a drop, of which linear theory
// knows little.
constexpr double kMassMismatch = 0.25;             ///< Of the displaced mass [-].
constexpr double kTiltMismatch = 15 * M_PI / 180;  ///< [rad]
constexpr double kLargestFroudeNumber = 0.1;       ///< Below it encounter effects are small [-].

/// Part of the body's radius by which its centre of mass would sink against that of buoyancy on the
/// way to an attitude that does not matter [-]: a sphere of 50 slices has 4e-4.
constexpr double kNeutral = 5e-4;

// Waves of half the body's length, and the added mass, feel a bottom that is nearer than these.
constexpr double kDraughtsToGround = 4;
constexpr double kLengthsToGround = 0.5;

/// Bodies of more than these lengths between them hardly feel each other's waves.
constexpr double kLengthsApart = 10;

/// Size of a mesh in a pose.
struct Extent {
  double radius = 0;  ///< About the centre of mass [m].
  double length = 0;  ///< Largest horizontal extent [m].
  // Height of the vertices over the centre of mass [m].
  double lowest = 0;
  double highest = 0;
};

Extent extent_of(const engine::BodySpec& body, const Eigen::Quaterniond& orientation) {
  const Eigen::Matrix3Xd at = orientation.toRotationMatrix() * outside_B(body).vertices;
  const Eigen::Vector3d sides = at.rowwise().maxCoeff() - at.rowwise().minCoeff();
  return {.radius = std::sqrt(at.colwise().squaredNorm().maxCoeff()),
          .length = std::max(sides.x(), sides.y()),
          .lowest = at.row(2).minCoeff(),
          .highest = at.row(2).maxCoeff()};
}

using Source = scene::Radiation::Source;

/// Angle between the verticals of two attitudes [rad].
double tilt_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Vector3d up_a = a.conjugate() * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d up_b = b.conjugate() * Eigen::Vector3d::UnitZ();
  return std::atan2(up_a.cross(up_b).norm(), up_a.dot(up_b));
}

/// Froude number of a body's start, by its speed in the water [-].
double froude_number(const engine::SimulationSpec& spec, const engine::BodySpec& body,
                     double length) {
  return (body.initial.linear_velocity - spec.sea->current).norm() /
         std::sqrt(spec.sea->gravity * length);
}

/// The choices of one scene.
class Chooser {
 public:
  Chooser(const scene::Scene& scene, const engine::SimulationSpec& spec)
      : scene_(scene), spec_(spec), has_neighbour_(spec.bodies.size()) {
    std::vector<double> radii;
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const engine::BodySpec& body : spec.bodies) {
      const Eigen::Matrix3Xd& vertices = outside_B(body).vertices;
      radii.push_back(vertices.cols() > 0 ? std::sqrt(vertices.colwise().squaredNorm().maxCoeff())
                                          : 0);
      const Eigen::Array3d at = body.initial.position;
      boxes.emplace_back(at - radii.back(), at + radii.back());
    }
    for (const auto& [i, j] : engine::overlapping(boxes)) {
      const double distance =
          (spec.bodies[i].initial.position - spec.bodies[j].initial.position).norm();
      if (distance < radii[i] + radii[j]) has_neighbour_[i] = has_neighbour_[j] = true;
    }
  }

  RadiationChoice choose(std::size_t i) const {
    const Source wanted = scene_.bodies[i].hydro.radiation.source;
    RadiationChoice choice{.written = wanted != Source::by_default};
    const bool other =
        scene_.bodies[i].hydro.added_mass.model != scene::AddedMass::Model::automatic;
    if (wanted == Source::none || (other && !choice.written)) return choice;
    choice.reason = impossible(i);
    if (!choice.reason.empty()) return choice;
    if (!choice.written) choice.reason = not_free_and_afloat(i);
    if (!choice.reason.empty()) return choice;
    const engine::BodySpec& body = spec_.bodies[i];
    choice.pose = mean_pose(body);
    const Extent extent = extent_of(body, choice.pose->orientation);
    choice.draught = -(choice.pose->height + extent.lowest);
    choice.length = extent.length;
    choice.reason = choice.written ? pose_fault(choice, body) : far_from_mean(choice, i);
    if (!choice.reason.empty()) choice.pose.reset();
    return choice;
  }

 private:
  /// Why a body cannot have radiation; empty if it can.
  std::string impossible(std::size_t i) const {
    const engine::BodySpec& body = spec_.bodies[i];
    if (!spec_.sea) return "the scene has no water";
    const hydro::Sea& sea = *spec_.sea;
    if (sea.gravity == 0) return "there is no gravity";
    if (spec_.integrator.method == engine::Integrator::Method::ode)
      return "integrator.method: ode has no added mass";
    if (std::holds_alternative<hydro::HeightField>(sea.surface))
      return "the water's surface is a fixed height field";
    const auto* waves = std::get_if<hydro::WaveSurface>(&sea.surface);
    if (waves && waves->kinematics == hydro::Kinematics::hydrostatic)
      return "kinematics: hydrostatic has no waves that a body could scatter";
    if (!body.wet || !body.coefficients.buoyancy) return "hydro.buoyancy is switched off";
    if (engine::immovable(body.locked)) return "the body is held in all six";
    if (scene_.bodies[i].hydro.added_mass.model != scene::AddedMass::Model::automatic)
      return "hydro.added_mass is given, and with radiation it is that of the mean pose";
    return why_not_afloat(mass_afloat(body, sea.density),
                          hydro::solid_properties(outside_B(body)).volume, sea.density);
  }

  std::string not_free_and_afloat(std::size_t i) const {
    const engine::BodySpec& body = spec_.bodies[i];
    if (body.locked[2]) return "its height is locked";
    for (const engine::JointSpec& joint : spec_.joints)
      if (joint.first == static_cast<engine::BodyId>(i) ||
          joint.second == static_cast<engine::BodyId>(i))
        return fmt::format("it hangs on {}", joint.name);
    const hydro::TriMesh mesh_G =
        hydro::transformed(outside_B(body), Eigen::Isometry3d(body.initial.orientation));
    const double volume =
        hydro::hydrostatics(mesh_G, body.initial.position.z() - spec_.sea->level).volume;
    if (volume == 0) return "it starts dry";
    const double ratio = spec_.sea->density * volume / mass_afloat(body, spec_.sea->density);
    if (std::abs(ratio - 1) > kMassMismatch)
      return fmt::format("at its start it displaces {:.3g} of its mass", ratio);
    return has_neighbour_[i] ? "another body starts within its radius and their own" : "";
  }

  hydro::MeanPose mean_pose(const engine::BodySpec& body) const {
    const hydro::BodyState& start = body.initial;
    hydro::MeanPose pose{.orientation = start.orientation,
                         .height = start.position.z() - spec_.sea->level};
    if (!body.locked[2]) {
      const hydro::Flotation rest = at_rest(body);
      pose = {.orientation = rest.orientation, .height = rest.height};
    }
    pose.orientation = hydro::with_heading(pose.orientation, 0);
    return rounded(pose, extent_of(body, pose.orientation).radius);
  }

  /// The body as it floats at rest; in its attitude at the start if that is locked or neutral.
  hydro::Flotation at_rest(const engine::BodySpec& body) const {
    const double density = spec_.sea->density;
    const double volume = mass_afloat(body, density) / density;
    const std::vector<hydro::Tank> tanks = tanks_of(body);
    const Eigen::Quaterniond& start = body.initial.orientation;
    const hydro::Flotation held = hydro::afloat(outside_B(body), volume, start, tanks);
    if (body.locked[3] || body.locked[4]) return held;
    const hydro::Flotation rest = hydro::equilibrium(outside_B(body), volume, start, tanks);
    const double sinks = rest.effective_centre().z() - held.effective_centre().z();
    const bool neutral = sinks < kNeutral * extent_of(body, start).radius;
    return neutral && tilt_between(start, rest.orientation) > kTiltMismatch ? held : rest;
  }

  /// A body whose height is locked may be out of the water, and a deep one on its bottom.
  std::string pose_fault(const RadiationChoice& choice, const engine::BodySpec& body) const {
    if (choice.draught <= 0) return "its height is locked where it is dry";
    if (choice.draught >= spec_.sea->depth)
      return fmt::format("its draught of {:.4g} m reaches the bottom", choice.draught);
    const double highest = choice.pose->height + extent_of(body, choice.pose->orientation).highest;
    return highest <= 0 ? "its height is locked where it is submerged" : "";
  }

  std::string far_from_mean(const RadiationChoice& choice, std::size_t i) const {
    const engine::BodySpec& body = spec_.bodies[i];
    if (std::string fault = pose_fault(choice, body); !fault.empty()) return fault;
    const double tilt = tilt_between(body.initial.orientation, choice.pose->orientation);
    if (tilt > kTiltMismatch)
      return fmt::format("it starts {:.0f}° from the attitude at which it floats at rest",
                         tilt * 180 / M_PI);
    const double froude = froude_number(spec_, body, choice.length);
    if (froude > kLargestFroudeNumber)
      return fmt::format("it starts with a Froude number of {:.2g}", froude);
    const double bound =
        std::max(kDraughtsToGround * choice.draught, kLengthsToGround * choice.length);
    if (depth_over(body.initial.position, choice.length) < std::min(bound, spec_.sea->depth))
      return "ground is near";
    return "";
  }

  /// Depth of the highest ground within a length of a point [m]; infinite without ground.
  double depth_over(const Eigen::Vector3d& at, double length) const {
    double depth = std::numeric_limits<double>::infinity();
    const double level = spec_.sea->level;
    if (const auto* plane = std::get_if<engine::PlaneGround>(&spec_.ground))
      return level - plane->z;
    const auto* ground = std::get_if<engine::MeshGround>(&spec_.ground);
    if (!ground) return depth;
    const Eigen::Vector2d from = at.head<2>().array() - length, to = at.head<2>().array() + length;
    for (const auto face : ground->mesh_W.faces.colwise()) {
      Eigen::Matrix3d corners;
      for (int i = 0; i < 3; ++i) corners.col(i) = ground->mesh_W.vertices.col(face[i]);
      const Eigen::Vector3d lowest = corners.rowwise().minCoeff();
      const Eigen::Vector3d highest = corners.rowwise().maxCoeff();
      if ((lowest.head<2>().array() <= to.array()).all() &&
          (highest.head<2>().array() >= from.array()).all())
        depth = std::min(depth, level - highest.z());
    }
    return depth;
  }

  const scene::Scene& scene_;
  const engine::SimulationSpec& spec_;
  std::vector<bool> has_neighbour_;  ///< Another starts within its radius and the other's.
};

/// Tells where a body's waves come from.
std::string described(const RadiationChoice& choice, const engine::BodySpec& body,
                      const hydro::Sea& sea) {
  if (!choice.database)
    return fmt::format("{} frequencies at a draught of {:.4g} m",
                       hydro::radiation_frequencies(outside_B(body), *choice.pose,
                                                    {.gravity = sea.gravity, .depth = sea.depth})
                           .size(),
                       choice.draught);
  const hydro::RadiationData& data = choice.database->found.data;
  return fmt::format("{} frequencies and {} headings of {} ({}, body {}) at a draught of {:.4g} m",
                     data.frequencies.size(), data.headings.size(),
                     choice.database->file.filename().string(), choice.database->format,
                     choice.database->body, choice.draught);
}

}  // namespace

std::vector<RadiationChoice> radiation_choices(const scene::Scene& scene,
                                               const engine::SimulationSpec& spec,
                                               scene::Faults& faults) {
  const Chooser chooser(scene, spec);
  std::vector<RadiationChoice> choices;
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    choices.push_back(chooser.choose(i));
    const RadiationChoice& choice = choices.back();
    if (choice.written && !choice.reason.empty())
      faults.add(
          scene.places, fmt::format("bodies[{}].hydro.radiation", i),
          fmt::format("found {} for {}: {}; expected none",
                      scene.bodies[i].hydro.radiation.source == Source::file ? "a file" : "auto",
                      spec.bodies[i].name, choice.reason));
  }
  return choices;
}

std::vector<std::string> radiation_warnings(const engine::SimulationSpec& spec,
                                            const std::vector<RadiationChoice>& choices) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (!choices[i].written || !choices[i].pose) continue;
    const std::string key = fmt::format("bodies[{}].hydro.radiation", i);
    const double froude = froude_number(spec, spec.bodies[i], choices[i].length);
    if (froude > kLargestFroudeNumber)
      lines.push_back(fmt::format(
          "{}: {} starts with a Froude number of {:.2g}, and the waves of a body are known without "
          "forward speed; expected at most {:g}",
          key, spec.bodies[i].name, froude, kLargestFroudeNumber));
    for (std::size_t j = 0; j < choices.size(); ++j) {
      if (i == j || !choices[j].pose || (choices[j].written && j < i)) continue;
      const double distance =
          (spec.bodies[i].initial.position - spec.bodies[j].initial.position).norm();
      const double bound = kLengthsApart * std::max(choices[i].length, choices[j].length);
      if (distance >= bound) continue;
      lines.push_back(fmt::format(
          "{}: {} and {} are {:.3g} m apart, and neither feels the waves of the other, which "
          "count up to some {:.3g} m",
          key, spec.bodies[i].name, spec.bodies[j].name, distance, bound));
      break;  // One neighbour tells it.
    }
  }
  return lines;
}

std::vector<std::string> radiation_lines(const engine::SimulationSpec& spec,
                                         const std::vector<RadiationChoice>& choices) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const RadiationChoice& choice = choices[i];
    if (!choice.pose && choice.reason.empty()) continue;
    const std::string text = choice.pose
                                 ? "radiation: " + described(choice, spec.bodies[i], *spec.sea)
                                 : "no radiation: " + choice.reason;
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const auto& known) { return known.first == text; });
    if (group == groups.end()) group = groups.insert(group, {text, {}});
    group->second.push_back(spec.bodies[i].name);
  }
  std::vector<std::string> lines;
  for (const auto& [text, names] : groups)
    lines.push_back(names.size() == 1
                        ? fmt::format("{}: {}", names.front(), text)
                        : fmt::format("{} and {} more: {}", names.front(), names.size() - 1, text));
  return lines;
}

}  // namespace assembly

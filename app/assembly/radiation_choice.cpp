#include "app/assembly/radiation_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "app/assembly/build_start.h"
#include "app/assembly/mean_pose.h"
#include "engine/motion/locks.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/radiation/radiation_solve.h"

namespace assembly {
namespace {

constexpr double kLargestTilt = 45 * M_PI / 180;  ///< Largest turn of a start from rest [rad].

/// Distance to the surface, over the draught, at which a body still touches it [-].
constexpr double kTouching = 0.02;

// Largest turn and change of displaced volume between the start and the rest of a hull that is
// held. An angle of 15° in a scene is within the limit, also at a hinge that lies a little beside
// the hull's middle.
constexpr double kHeldTilt = 16 * M_PI / 180;  ///< [rad]
constexpr double kHeldVolume = 0.25;           ///< Over the displaced volume at rest [-].

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

Extent extent_of(const hydro::TriMesh& mesh_B, const Eigen::Quaterniond& orientation) {
  const Eigen::Matrix3Xd at = orientation.toRotationMatrix() * mesh_B.vertices;
  const Eigen::Vector3d sides = at.rowwise().maxCoeff() - at.rowwise().minCoeff();
  return {.radius = std::sqrt(at.colwise().squaredNorm().maxCoeff()),
          .length = std::max(sides.x(), sides.y()),
          .lowest = at.row(2).minCoeff(),
          .highest = at.row(2).maxCoeff()};
}

using Source = scene::Radiation::Source;

/// The choices of one scene.
class Chooser {
 public:
  Chooser(const scene::Scene& scene, const engine::SimulationSpec& spec)
      : scene_(scene), spec_(spec), poses_(spec) {}

  /// Sets the choices of the bodies of a group, of which one leads.
  void choose(const RigidGroup& group, std::vector<RadiationChoice>& choices) {
    const engine::BodyId lead = lead_of(group);
    const std::size_t i = index(lead);
    RadiationChoice choice{.written = hydro(lead).radiation.source != Source::by_default};
    if (wants_none(group, lead)) return;
    choice.reason = impossible(group, lead);
    if (choice.reason.empty()) {
      choose_pose(group, lead, choice);
      if (std::string why = missing_theory(); !why.empty()) {
        choice.unexpected = choice.reason.empty();  // In another scene it would make waves.
        choice.reason = std::move(why);
      }
    }
    if (!choice.reason.empty()) choice.pose.reset();
    choice.simulated = choice.pose && is_simulated();
    choices[i] = std::move(choice);
    for (const engine::BodyId id : group.bodies)
      if (id != lead)
        choices[index(id)] = {
            .lead = lead,
            .reason = choices[i].reason.empty()
                          ? fmt::format("{} carries that of their hull", body(lead).name)
                          : choices[i].reason};
  }

 private:
  static std::size_t index(engine::BodyId id) { return static_cast<std::size_t>(id); }
  const scene::Hydro& hydro(engine::BodyId id) const { return scene_.bodies[index(id)].hydro; }
  const engine::BodySpec& body(engine::BodyId id) const { return spec_.bodies[index(id)]; }

  /// True if bodies feel the waves of others.
  bool is_simulated() const {
    return scene_.water && scene_.water->simulated.kind == scene::SimulatedWater::Kind::felt;
  }

  /// The first body of a group with the key, or else the first.
  engine::BodyId lead_of(const RigidGroup& group) const {
    const auto asks = [&](engine::BodyId id) {
      const Source source = hydro(id).radiation.source;
      return source == Source::automatic || source == Source::file;
    };
    const auto found = std::ranges::find_if(group.bodies, asks);
    return found == group.bodies.end() ? group.bodies.front() : *found;
  }

  /// True if the keys say that the hull has no radiation.
  bool wants_none(const RigidGroup& group, engine::BodyId lead) const {
    if (hydro(lead).radiation.source == Source::none) return true;
    if (hydro(lead).radiation.source != Source::by_default) return false;
    return std::ranges::any_of(group.bodies, [&](engine::BodyId id) {
      return hydro(id).radiation.source == Source::none ||
             hydro(id).added_mass.model != scene::AddedMass::Model::automatic;
    });
  }

  void choose_pose(const RigidGroup& group, engine::BodyId lead, RadiationChoice& choice) {
    const bool immovable = engine::immovable(body(lead).locked) || !group.joint_to_world.empty();
    // In simulated water it turns the waves of others back.
    if (immovable && !choice.written && !is_simulated()) {
      choice.reason = "it is held in all six";
      return;
    }
    const RadiatingHull hull = radiating_hull(spec_, group, lead);
    choice.held = poses_.holder(hull);
    if (choice.held.empty())
      choice.reason = why_not_afloat(
          {hull.mass, hull.water}, hydro::solid_properties(hull.mesh_B).volume, spec_.sea->density);
    if (!choice.reason.empty()) return;
    const std::optional<scene::Radiation::Pose>& wanted = hydro(lead).radiation.pose;
    const FoundPose found = poses_.find(hull, wanted);
    choice.pose = found.pose;
    const Extent extent = extent_of(hull.mesh_B, found.pose.orientation);
    choice.draught = -(found.pose.height + extent.lowest);
    choice.length = extent.length;
    choice.reason = pose_fault(found.pose, extent);
    if (!choice.reason.empty()) return;
    WetSurface wet = wet_surface(spec_, hull, found.pose);
    choice.reason = wet.fault;
    if (choice.reason.empty() && !wanted) choice.reason = held_away(found);
    if (choice.reason.empty() && !choice.written)
      choice.reason = far_from(found, hull.mesh_B, extent, lead);
    choice.unexpected = !choice.reason.empty() && found.start_volume > 0;
    if (group.bodies.size() > 1)
      choice.joined_B = std::make_shared<const hydro::TriMesh>(std::move(wet.mesh_B));
  }

  /// Why no hull can have radiation by this method on this surface; empty if one can.
  std::string missing_theory() const {
    if (spec_.integrator.method == engine::Integrator::Method::ode)
      return "integrator.method: ode has no added mass";
    const auto& surface = spec_.sea->surface;
    if (std::holds_alternative<hydro::HeightField>(surface))
      return "the water's surface is a fixed height field";
    const auto* waves = std::get_if<hydro::WaveSurface>(&surface);
    if (waves && waves->kinematics == hydro::Kinematics::hydrostatic)
      return "kinematics: hydrostatic has no waves that a body could scatter";
    return "";
  }

  /// Why a hull cannot have radiation, whatever the method and the surface; empty if it can.
  std::string impossible(const RigidGroup& group, engine::BodyId lead) const {
    if (!spec_.sea) return "the scene has no water";
    if (spec_.sea->gravity == 0) return "there is no gravity";
    for (const engine::BodyId id : group.bodies)
      if (!body(id).wet || !body(id).coefficients.buoyancy) return "hydro.buoyancy is switched off";
    if (is_simulated() && hydro(lead).radiation.source == Source::file)
      return "water.simulated finds the waves of all bodies, of which a file knows one alone";
    if (hydro(lead).added_mass.model != scene::AddedMass::Model::automatic)
      return "hydro.added_mass is given, and with radiation it is that of the mean pose";
    return "";
  }

  /// A hull that is held may be out of the water or below its surface, and a deep one on its
  /// bottom.
  std::string pose_fault(const hydro::MeanPose& pose, const Extent& extent) const {
    const double draught = -(pose.height + extent.lowest);
    if (draught <= 0) return "it is dry in its mean pose";
    if (draught >= spec_.sea->depth)
      return fmt::format("its draught of {:.4g} m reaches the bottom", draught);
    return pose.height + extent.highest <= 0 ? "it is submerged in its mean pose" : "";
  }

  /// Why a hull that is held starts too far from its rest; empty if it does not.
  static std::string held_away(const FoundPose& found) {
    const bool near =
        found.start_tilt <= kHeldTilt && std::abs(found.start_volume - 1) <= kHeldVolume;
    if (found.holder.empty() || near) return "";
    return fmt::format(
        "held by {}, it comes to rest {:.0f}° from its start, where it displaces {:.3g} of what it "
        "does there: pose: equilibrium takes the rest as the mean pose, and pose: start the start",
        found.holder, found.start_tilt * 180 / M_PI, found.start_volume);
  }

  /// Why linear theory about the mean pose says little of what follows from the start.
  std::string far_from(const FoundPose& found, const hydro::TriMesh& mesh_B, const Extent& extent,
                       engine::BodyId lead) const {
    const hydro::BodyState& start = body(lead).initial;
    if (found.start_tilt > kLargestTilt)
      return fmt::format("it starts {:.0f}° from the attitude at which it floats at rest",
                         found.start_tilt * 180 / M_PI);
    const double draught = -(found.pose.height + extent.lowest);
    const Extent at_start = extent_of(mesh_B, start.orientation);
    const Eigen::Vector3d& p = start.position;
    const double height = p.z() - hydro::surface_height(*spec_.sea, p.x(), p.y(), 0);
    const double speed = std::hypot(start.linear_velocity.z(),
                                    extent.radius * start.angular_velocity.head<2>().norm());
    const double beyond = std::max(height + at_start.lowest, -(height + at_start.highest)) +
                          speed * speed / (2 * spec_.sea->gravity);
    if (beyond > kTouching * draught)
      return fmt::format(
          "it starts as if it were let go {:.3g} m beyond where it would just touch "
          "the surface",
          beyond);
    const double bound = std::max(kDraughtsToGround * -(found.pose.height + extent.lowest),
                                  kLengthsToGround * extent.length);
    if (depth_over(start.position, extent.length) < std::min(bound, spec_.sea->depth))
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
  MeanPoses poses_;
};

/// Tells where a body's waves come from.
std::string described(const RadiationChoice& choice, const engine::BodySpec& body,
                      const hydro::Sea& sea) {
  if (choice.simulated)
    return fmt::format("in simulated water, about a draught of {:.4g} m{}", choice.draught,
                       choice.held.empty() ? "" : ", held by " + choice.held);
  if (!choice.database)
    return fmt::format("{} frequencies at a draught of {:.4g} m{}",
                       hydro::radiation_frequencies(radiating_mesh(choice, body), *choice.pose,
                                                    {.gravity = sea.gravity, .depth = sea.depth})
                           .size(),
                       choice.draught, choice.held.empty() ? "" : ", held by " + choice.held);
  const hydro::RadiationData& data = choice.database->found.data;
  return fmt::format("{} frequencies and {} headings of {} ({}, body {}) at a draught of {:.4g} m",
                     data.frequencies.size(), data.headings.size(),
                     choice.database->file.filename().string(), choice.database->format,
                     choice.database->body, choice.draught);
}

/// A warning of the first of several bodies, of which each has numbers and names of its own in it.
struct AlikeWarning {
  std::string kind;
  std::string text;
  std::size_t first;
  int more = 0;
};

/// Adds a warning of body i, or counts it with those that differ in numbers and names of bodies.
void add_warning(const std::string& text, const engine::SimulationSpec& spec, std::size_t i,
                 std::vector<AlikeWarning>& warnings) {
  std::string kind = text;
  for (const engine::BodySpec& body : spec.bodies)
    if (kind.starts_with(body.name + " ")) kind.erase(0, body.name.size());
  std::erase_if(kind,
                [](char c) { return std::isdigit(static_cast<unsigned char>(c)) || c == '.'; });
  const auto known = std::ranges::find(warnings, kind, &AlikeWarning::kind);
  if (known == warnings.end())
    warnings.push_back({.kind = kind, .text = text, .first = i});
  else
    ++known->more;
}

}  // namespace

double froude_number(const hydro::Sea& sea, double speed, double length) {
  return speed / std::sqrt(sea.gravity * length);
}

std::vector<RadiationChoice> radiation_choices(const scene::Scene& scene,
                                               const engine::SimulationSpec& spec,
                                               scene::Faults& faults) {
  Chooser chooser(scene, spec);
  std::vector<RadiationChoice> choices(spec.bodies.size());
  for (const RigidGroup& group : rigid_groups(spec)) chooser.choose(group, choices);
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const RadiationChoice& choice = choices[i];
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
  std::vector<AlikeWarning> warnings;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (choices[i].unexpected) add_warning("no radiation: " + choices[i].reason, spec, i, warnings);
    if (!choices[i].pose || choices[i].simulated) continue;
    for (std::size_t j = i + 1; j < choices.size(); ++j) {
      if (!choices[j].pose || !(choices[i].written || choices[j].written)) continue;
      const double distance =
          (spec.bodies[i].initial.position - spec.bodies[j].initial.position).norm();
      const double bound = kLengthsApart * std::max(choices[i].length, choices[j].length);
      if (distance >= bound) continue;
      add_warning(fmt::format("{} is {:.3g} m away, and neither feels the waves of the other, "
                              "which count up to some {:.3g} m",
                              spec.bodies[j].name, distance, bound),
                  spec, i, warnings);
      break;  // One neighbour tells it.
    }
  }
  std::vector<std::string> lines;
  for (const AlikeWarning& warning : warnings)
    lines.push_back(fmt::format(
        "bodies[{}].hydro.radiation: {}{}: {}", warning.first, spec.bodies[warning.first].name,
        warning.more > 0 ? fmt::format(" and {} more", warning.more) : "", warning.text));
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

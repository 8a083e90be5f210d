#include "app/assembly/build_rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "app/assembly/build_control.h"
#include "app/assembly/build_moordyn.h"
#include "app/scene/rig_names.h"
#include "engine/rig/dynamic_lines.h"
#include "engine/rig/line_pull.h"

namespace assembly {
namespace {

using Of = scene::SetPoint::Of;

/// A mooring line that is this many times shorter than its span does not reach its anchor.
constexpr double kOutOfReach = 1.2;

/// Coefficients of a line with inertia that has a diameter [-].
constexpr double kLineDragAlong = 0.05, kLineAddedMass = 1;

/// Builds the rig of one scene.
class RigBuilder {
 public:
  RigBuilder(BuiltScene& built, BuildLog& log) : built_(built), spec_(built.spec), log_(log) {}

  void all() {
    add_set_points();
    add_loads();
    add_pumps();
    add_drives();
    add_tethers(log_.scene.springs, "springs", engine::LineSpec::Kind::spring, Of::spring_length);
    add_tethers(log_.scene.ropes, "ropes", engine::LineSpec::Kind::rope, Of::rope_length);
    add_winches();
    add_moorings();
    build_moordyn(spec_, log_, [this](const std::string& body, const Eigen::Vector3d& point) {
      return attached(body, point);
    });
    for (std::size_t i = 0; i < log_.scene.propellers.size(); ++i)
      add_propeller(log_.scene.propellers[i], i);
    for (std::size_t i = 0; i < log_.scene.rudders.size(); ++i)
      add_rudder(log_.scene.rudders[i], i);
    for (std::size_t i = 0; i < log_.scene.sails.size(); ++i) add_sail(log_.scene.sails[i], i);
    add_controls(spec_, log_);
  }

 private:
  void add_set_points() {
    for (const scene::SetPoint& point : scene::set_points(log_.scene)) {
      ids_[{point.of, point.index, point.load}] =
          static_cast<engine::SetPointId>(spec_.set_points.size());
      spec_.set_points.push_back({.name = point.name,
                                  .initial = point.initial.value_or(0),
                                  .unit = point.unit,
                                  .least = point.least});
    }
  }

  std::optional<engine::SetPointId> find_id(Of of, std::size_t index, std::size_t load = 0) const {
    const auto found = ids_.find({of, index, load});
    return found == ids_.end() ? std::nullopt : std::optional(found->second);
  }
  engine::SetPointId id(Of of, std::size_t index) const { return ids_.at({of, index, 0}); }

  /// @param point   In the mesh frame, or in W for the world.
  engine::AttachmentPoint attached(const std::string& body, const Eigen::Vector3d& point) const {
    const engine::BodyId id = body_id(log_.scene, body);
    if (id == engine::kWorld) return {.body = id, .at = point};
    return {.body = id, .at = point - built_.centers_of_mass[static_cast<std::size_t>(id)]};
  }

  void add_loads() {
    for (std::size_t i = 0; i < spec_.bodies.size(); ++i)
      for (std::size_t k = 0; k < spec_.bodies[i].loads.size(); ++k)
        spec_.bodies[i].loads[k].factor = find_id(Of::load_factor, i, k);
  }

  void add_pumps() {
    for (std::size_t i = 0; i < spec_.bodies.size(); ++i)
      for (std::size_t k = 0; k < spec_.bodies[i].pumps.size(); ++k)
        spec_.bodies[i].pumps[k].rate = ids_.at({Of::pump_rate, i, k});
  }

  void add_drives() {
    using Mode = engine::JointMotor::Mode;
    const std::map<scene::JointMotor::Mode, Mode> modes = {
        {scene::JointMotor::Mode::speed, Mode::speed},
        {scene::JointMotor::Mode::position, Mode::position},
        {scene::JointMotor::Mode::effort, Mode::effort}};
    for (std::size_t i = 0; i < spec_.joints.size(); ++i) {
      const scene::JointDrive& drive = log_.scene.joints[i].drive;
      spec_.joints[i].drive = {.limits = drive.limits,
                               .stiffness = drive.stiffness,
                               .rest = drive.rest,
                               .damping = drive.damping,
                               .friction = drive.friction};
      if (drive.motor)
        spec_.joints[i].drive.motor =
            engine::JointMotor{.mode = modes.at(drive.motor->mode),
                               .set_point = id(Of::joint_motor, i),
                               .largest_effort = drive.motor->largest_effort,
                               .rate = drive.motor->rate};
    }
  }

  template <class Tethers>
  void add_tethers(const Tethers& tethers, const char* list, engine::LineSpec::Kind kind,
                   Of length) {
    for (std::size_t i = 0; i < tethers.size(); ++i) {
      const scene::Tether& tether = tethers[i];
      engine::LineSpec line{.name = tether.name,
                            .kind = kind,
                            .first = attached(tether.bodies[0], tether.points[0]),
                            .second = attached(tether.bodies[1], tether.points[1]),
                            .stiffness = tether.stiffness,
                            .damping = tether.damping,
                            .breaks_at = tether.breaks_at,
                            .set_length = find_id(length, i)};
      line.length = tether.length.value_or(span_of(line));
      if (line.set_length) spec_.set_points[*line.set_length].initial = line.length;
      check_strength(line, fmt::format("{}[{}].breaks_at", list, i));
      spec_.lines.push_back(std::move(line));
    }
  }

  void add_winches() {
    const std::size_t first = log_.scene.springs.size();
    for (std::size_t i = 0; i < log_.scene.ropes.size(); ++i) {
      spec_.lines[first + i].set_rate = find_id(Of::rope_rate, i);
      spec_.lines[first + i].shortest = log_.scene.ropes[i].shortest;
      const scene::Rope& rope = log_.scene.ropes[i];
      if (!rope.inertia) continue;
      spec_.lines[first + i].weight = rope.weight;
      add_inertia(*rope.inertia, rope.drag, scene::bottom_of(log_.scene),
                  fmt::format("ropes[{}]", i), spec_.lines[first + i]);
    }
  }

  /// @param bottom   Height of the bottom that carries the line.
  void add_inertia(const scene::LineInertia& given, const scene::LineDrag& drag,
                   const std::optional<double>& bottom, const std::string& path,
                   engine::LineSpec& line) {
    const double displaced =
        spec_.sea ? spec_.sea->density * std::numbers::pi / 4 * drag.diameter * drag.diameter : 0;
    const double mass = given.mass.value_or(line.weight / spec_.gravity + displaced);
    if (!(mass > 0) || !std::isfinite(mass))  // without gravity a weight tells no mass
      log_.faults.add(log_.scene.places, path + ".weight",
                      "leaves the line no mass, expected its mass beside it");
    line.drag_diameter = drag.diameter;
    line.drag_coefficient = drag.diameter > 0 ? drag.coefficient : 0;
    line.inertia = {.segments = given.segments,
                    .mass = mass,
                    .drag_along = drag.along.value_or(kLineDragAlong),
                    .added_mass = drag.added_mass.value_or(kLineAddedMass)};
    if (bottom) line.inertia->bottom = *bottom;
    const double longest = engine::longest_step(spec_, line);
    if (spec_.step > longest)
      log_.faults.add(log_.scene.places, path + ".stiffness",
                      fmt::format("found {:g}, but between two bodies that move a line with weight "
                                  "and this stiffness needs a step of {:.3g} s or less; the "
                                  "scene's is {:g} s",
                                  line.stiffness, longest, spec_.step));
  }

  double span_of(const engine::LineSpec& line) const {
    return (place_at_start(spec_, line.second) - place_at_start(spec_, line.first)).norm();
  }

  /// Refuses a line that breaks at once.
  void check_strength(const engine::LineSpec& line, const std::string& path) {
    if (!std::isfinite(line.breaks_at)) return;
    const double tension = tension_at_start(spec_, line);
    if (tension > line.breaks_at)
      log_.faults.add(log_.scene.places, path,
                      fmt::format("found {:g}, but the line starts with a tension of {:.4g} N",
                                  line.breaks_at, tension));
  }

  void add_moorings() {
    for (std::size_t i = 0; i < log_.scene.moorings.size(); ++i) {
      const scene::Mooring& mooring = log_.scene.moorings[i];
      engine::LineSpec line{
          .name = mooring.name,
          .kind = engine::LineSpec::Kind::mooring,
          .first = attached(mooring.body, mooring.fairlead),
          .second = {.body = engine::kWorld, .at = mooring.anchor},
          .length = mooring.length,
          .stiffness = mooring.stiffness,
          .breaks_at = mooring.breaks_at,
          .weight = mooring.weight,
          .friction = mooring.on_bottom ? mooring.friction : 0,
          .on_bottom = mooring.on_bottom,
          .drag_diameter = mooring.drag.diameter,
          .drag_coefficient = mooring.drag.diameter > 0 ? mooring.drag.coefficient : 0};
      const std::string path = fmt::format("moorings[{}]", i);
      if (mooring.inertia)
        add_inertia(*mooring.inertia, mooring.drag,
                    mooring.on_bottom ? std::optional(mooring.anchor.z()) : std::nullopt, path,
                    line);
      if (check_reach(line, path)) check_strength(line, path + ".breaks_at");
      spec_.lines.push_back(std::move(line));
    }
  }

  /// Returns false and adds a fault for a mooring that cannot be where it is.
  bool check_reach(const engine::LineSpec& line, const std::string& path) {
    const double span = span_of(line);
    const double height = place_at_start(spec_, line.first).z() - line.second.at.z();
    if (span > kOutOfReach * line.length)
      log_.faults.add(log_.scene.places, path + ".length",
                      fmt::format("found {:g}, but the anchor is {:.4g} m from the fairlead at the "
                                  "start; expected a line that reaches it",
                                  line.length, span));
    else if (line.on_bottom && height < 0)
      log_.faults.add(log_.scene.places, path + ".fairlead",
                      fmt::format("lies {:.4g} m below its anchor, expected a place above the "
                                  "bottom",
                                  -height));
    else
      return true;
    return false;
  }

  void add_propeller(const scene::Propeller& propeller, std::size_t i) {
    const engine::AttachmentPoint at = attached(propeller.body, propeller.at);
    try {
      hydro::PropellerCurves{propeller.screw};
    } catch (const std::invalid_argument& error) {
      log_.faults.add(log_.scene.places, fmt::format("propellers[{}].model", i), error.what());
    }
    spec_.propellers.push_back({.name = propeller.name,
                                .body = at.body,
                                .at_B = at.at,
                                .axis_B = propeller.axis,
                                .pivot_B = propeller.pivot,
                                .screw = propeller.screw,
                                .inertia = propeller.inertia,
                                .right_handed = propeller.right_handed,
                                .speed = id(Of::propeller_speed, i),
                                .azimuth = id(Of::propeller_azimuth, i)});
  }

  engine::FoilSpec foil_spec(const scene::Foil& foil, const std::string& path) {
    const engine::AttachmentPoint at = attached(foil.body, foil.at);
    try {
      hydro::check_foil(foil.foil);
    } catch (const std::invalid_argument& error) {
      log_.faults.add(log_.scene.places, path, error.what());
    }
    return {.name = foil.name,
            .body = at.body,
            .at_B = at.at,
            .span_B = foil.axis,
            .chord_B = foil.chord_axis,
            .foil = foil.foil};
  }

  void add_rudder(const scene::Rudder& rudder, std::size_t i) {
    engine::FoilSpec foil = foil_spec(rudder, fmt::format("rudders[{}]", i));
    foil.angle = id(Of::rudder_angle, i);
    for (std::size_t k = 0; k < log_.scene.propellers.size(); ++k)
      if (rudder.behind && log_.scene.propellers[k].name == *rudder.behind) foil.behind = k;
    spec_.foils.push_back(std::move(foil));
  }

  void add_sail(const scene::Sail& sail, std::size_t i) {
    engine::FoilSpec foil = foil_spec(sail, fmt::format("sails[{}]", i));
    foil.fluid = engine::FoilSpec::Fluid::air;
    foil.angle = id(Of::sail_angle, i);
    spec_.foils.push_back(std::move(foil));
  }

  BuiltScene& built_;
  engine::SimulationSpec& spec_;
  BuildLog& log_;
  std::map<std::tuple<Of, std::size_t, std::size_t>, engine::SetPointId> ids_;
};

}  // namespace

Eigen::Vector3d place_at_start(const engine::SimulationSpec& spec,
                               const engine::AttachmentPoint& point) {
  if (point.body == engine::kWorld) return point.at;
  const hydro::BodyState& state = spec.bodies[static_cast<std::size_t>(point.body)].initial;
  return state.position + state.orientation * point.at;
}

hydro::CatenarySolution catenary_at_start(const engine::SimulationSpec& spec,
                                          const engine::LineSpec& line) {
  const Eigen::Vector3d span = place_at_start(spec, line.first) - place_at_start(spec, line.second);
  return hydro::solve_catenary(engine::catenary_line(line, line.length), span.head<2>().norm(),
                               span.z(), line.on_bottom);
}

double tension_at_start(const engine::SimulationSpec& spec, const engine::LineSpec& line) {
  if (line.kind == engine::LineSpec::Kind::mooring) return catenary_at_start(spec, line).tension();
  const Eigen::Vector3d span = place_at_start(spec, line.first) - place_at_start(spec, line.second);
  const double pull = line.stiffness * (span.norm() - line.length);
  return line.kind == engine::LineSpec::Kind::rope ? std::max(0.0, pull) : pull;
}

engine::BodyId body_id(const scene::Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].name == name) return static_cast<engine::BodyId>(i);
  return engine::kWorld;
}

void build_rig(BuiltScene& built, BuildLog& log) { RigBuilder(built, log).all(); }

}  // namespace assembly

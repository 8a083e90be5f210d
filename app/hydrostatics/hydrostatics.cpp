#include "app/hydrostatics/hydrostatics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "app/assembly/build.h"
#include "app/assembly/build_interior.h"
#include "app/assembly/build_start.h"
#include "app/assembly/mesh_io.h"
#include "app/assembly/rigid_group.h"
#include "app/base/console.h"
#include "app/base/terminal_reporter.h"
#include "hydro/decompositions.h"
#include "hydro/interior/interior.h"
#include "hydro/interior/lids.h"
#include "hydro/interior/places.h"
#include "hydro/loads/loads.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh_check.h"

namespace app {
namespace {

void check_positive(const std::optional<double>& value, const std::string& option,
                    const std::string& unit) {
  if (value && !(*value > 0 && std::isfinite(*value)))
    throw scene::InputError(
        option, fmt::format("found {:g}, expected a positive number [{}]", *value, unit));
}

/// Returns the mass that floats at a draught with the mesh's z axis up [kg].
/// @param keel_B   Height from which the draught counts [m].
double mass_at_draught(const hydro::TriMesh& mesh_B, double keel_B, double draught,
                       double density) {
  const double lowest = mesh_B.vertices.row(2).minCoeff(), waterline = keel_B + draught;
  const double highest = mesh_B.vertices.row(2).maxCoeff();
  if (!(waterline > lowest && waterline < highest))
    throw scene::InputError(
        "--draught",
        fmt::format("found {:g}, expected between {:g} and {:g} m, where the waterline "
                    "is between the mesh's lowest and highest point",
                    draught, lowest - keel_B, highest - keel_B));
  return density * hydro::hydrostatics(mesh_B, -waterline).volume;
}

void check_mesh_options(const HydrostaticsOptions& o) {
  refuse_if(!o.overrides.empty(), "--set", "is for a scene, and this is a mesh");
  refuse_if(o.mass && o.draught, "--draught", "given beside --mass, expected only one of them");
  refuse_if(o.mass && !o.draughts.empty(), "--mass",
            "given beside several draughts, which have a displacement each");
  refuse_if(o.water && !o.draughts.empty(), "--water", "is for one draught, or a mass");
  refuse_if(!o.mass && !o.draught && o.draughts.empty(), "--mass",
            "missing, expected the body's mass, or its --draught");
  check_positive(o.mass, "--mass", "kg");
  check_positive(o.draught, "--draught", "m");
  refuse_if(o.keel && !std::isfinite(*o.keel), "--keel", "expected a finite number");
  check_positive(o.density, "--density", "kg/m^3");
  refuse_if(o.center_of_mass && !o.center_of_mass->allFinite(), "--com", "expected finite numbers");
  check_positive(o.water, "--water", "m^3");
}

/// The vertices of the sills to the sea.
std::vector<Eigen::Vector3d> sill_points(const hydro::TriMesh& mesh_B,
                                         const hydro::Pockets& division) {
  std::set<int> vertices;
  for (const hydro::SillEdge& edge : division.sills)
    if (edge.other == hydro::kSea) vertices.insert({edge.from, edge.to});
  std::vector<Eigen::Vector3d> points;
  for (const int v : vertices) points.emplace_back(mesh_B.vertices.col(v));
  return points;
}

/// Closes the mouths of an upright mesh, and puts water into its pockets, to equal parts.
void make_hollow(const std::optional<double>& water, FloatingBody& body) {
  const auto interior = hydro::is_convex(body.mesh_B)
                            ? nullptr
                            : hydro::make_interior(body.mesh_B, Eigen::Vector3d::UnitZ());
  refuse_if(water && !interior, "--water", "the upright mesh has no hollow that holds water");
  if (!interior) return;
  double capacity = 0;
  for (const hydro::Pocket& pocket : interior->division.pockets) capacity += pocket.capacity;
  if (water && *water >= capacity)
    throw scene::InputError("--water", fmt::format("found {:g}, expected less than the {:g} m^3 "
                                                   "that the upright mesh holds",
                                                   *water, capacity));
  body.flooding_points_B = sill_points(body.mesh_B, interior->division);
  for (std::size_t i = 0; water && i < interior->pockets.size(); ++i)
    body.tanks.push_back({.hull = interior->pockets[i],
                          .volume = *water * interior->division.pockets[i].capacity / capacity});
  body.mesh_B = hydro::with_lids(body.mesh_B, interior->division);
}

/// True if an opening leads into the sea.
bool leads_outside(const engine::BodySpec& spec, const hydro::Pockets& division,
                   const engine::Opening& opening) {
  const std::array<int, 2> faces = hydro::wall_at(spec.mesh_B, opening.at_B).face;
  return std::any_of(faces.begin(), faces.end(),
                     [&](int face) { return division.pocket_of_face[face] == hydro::kSea; });
}

/// The sills of a scene's body in its attitude at the start, and its openings to the sea.
std::vector<Eigen::Vector3d> flooding_points(const engine::BodySpec& spec) {
  if (spec.interior != engine::Interior::flooding || !spec.closed_mesh_B) return {};
  const Eigen::Vector3d up_B = spec.initial.orientation.toRotationMatrix().row(2);
  const auto interior = engine::pockets_at(spec, up_B);
  if (!interior) return {};
  const hydro::Pockets& division = interior->division;
  std::vector<Eigen::Vector3d> points = sill_points(spec.mesh_B, division);
  for (const engine::Opening& opening : spec.openings)
    if (leads_outside(spec, division, opening)) points.push_back(opening.at_B);
  return points;
}

FloatingBody body_of_mesh(const HydrostaticsOptions& o) {
  check_mesh_options(o);
  TerminalReporter reporter(false);
  const hydro::TriMesh mesh = assembly::read_solid(o.file, reporter, o.formats, o.frame);
  FloatingBody body{.name = o.file.stem().string(),
                    .com_M = o.center_of_mass.value_or(hydro::solid_properties(mesh).centroid),
                    .density = o.density.value_or(1000)};
  body.mesh_B = hydro::translated(mesh, -body.com_M);
  make_hollow(o.water, body);
  body.keel_M = o.keel;
  if (!o.draughts.empty()) return body;
  const double keel_B = o.keel ? *o.keel - body.com_M.z() : body.mesh_B.vertices.row(2).minCoeff();
  body.mass = o.mass ? *o.mass : mass_at_draught(body.mesh_B, keel_B, *o.draught, body.density);
  return body;
}

void check_scene_options(const HydrostaticsOptions& o) {
  const std::string message = "is for a mesh; a scene has its own, see --set";
  refuse_if(o.mass.has_value(), "--mass", message);
  refuse_if(o.draught.has_value(), "--draught", message);
  refuse_if(o.keel.has_value(), "--keel", "is for a mesh");
  refuse_if(o.density.has_value(), "--density", message);
  refuse_if(o.center_of_mass.has_value(), "--com", message);
  refuse_if(o.water.has_value(), "--water", "is for a mesh; a scene has interior_water");
  assembly::refuse_frame(o.frame);
}

/// Returns the body of a group whose axes and mesh frame the group has: the one that starts in
/// equilibrium, or else the first with buoyancy; none if no body of the group has buoyancy.
std::optional<engine::BodyId> lead_of(const assembly::RigidGroup& group, const scene::Scene& scene,
                                      const engine::SimulationSpec& spec) {
  std::optional<engine::BodyId> lead;
  for (const engine::BodyId id : group.bodies) {
    if (!assembly::has_buoyancy(spec.bodies[id])) continue;
    if (scene.bodies[id].start == scene::Start::equilibrium) return id;
    if (!lead) lead = id;
  }
  return lead;
}

/// Returns bodies that fixed joints hold together as one.
FloatingBody body_of_group(const assembly::RigidGroup& group, engine::BodyId lead,
                           const scene::Scene& scene, const assembly::BuiltScene& built) {
  assembly::FloatingGroup joined = assembly::floating_group(built.spec, group, lead);
  FloatingBody body{.name = built.spec.bodies[lead].name,
                    .mesh_B = std::move(joined.mesh_G),
                    .tanks = std::move(joined.tanks),
                    .com_M = built.centers_of_mass[lead],
                    .mass = joined.mass,
                    .density = scene.water->density,
                    .gravity = scene.gravity,
                    .start = scene.bodies[lead].orientation};
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    const engine::BodySpec& spec = built.spec.bodies[group.bodies[i]];
    const Eigen::Isometry3d& X_GB = joined.X_GB[i];
    if (group.bodies[i] == lead)
      body.com_M -= X_GB.translation();
    else
      body.name += " + " + spec.name;
    for (const Eigen::Vector3d& point_B : flooding_points(spec))
      body.flooding_points_B.emplace_back(X_GB * point_B);
  }
  return body;
}

std::vector<FloatingBody> bodies_of_scene(const HydrostaticsOptions& o) {
  check_scene_options(o);
  const auto read =
      std::make_shared<const scene::Scene>(scene::read(o.file, o.overrides, o.formats));
  const scene::Scene& scene = *read;
  scene::Faults faults;
  if (!scene.water) faults.add(scene.places, "water", "missing, and without water nothing floats");
  if (scene.gravity == 0)
    faults.add(scene.places, "gravity", "found 0, and without it nothing floats");
  faults.throw_if_any();
  const auto built =
      std::make_shared<const assembly::BuiltScene>(assembly::build_without_added_mass(scene));
  for (const std::string& note : built->notes)
    say(fmt::format("{}: note: {}", scene.file.string(), note));
  std::vector<FloatingBody> bodies;
  for (const assembly::RigidGroup& group : assembly::rigid_groups(built->spec)) {
    const auto lead = lead_of(group, scene, built->spec);
    if (!lead) continue;
    bodies.push_back(body_of_group(group, *lead, scene, *built));
    if (group.bodies.size() == 1)
      bodies.back().natural_periods = [read, built, lead](const hydro::MeanPose& rest) {
        return known_natural_periods(*read, *built, *lead, rest);
      };
  }
  if (bodies.empty()) throw scene::InputError(scene.file, "has no body with buoyancy");
  return bodies;
}

FloatingState state_of(const FloatingBody& body, const hydro::ImmersedMesh& mesh,
                       const Eigen::Quaterniond& orientation) {
  FloatingState state{
      hydro::afloat(mesh, body.displaced(), hydro::with_heading(orientation, 0), body.tanks)};
  state.stability = hydro::stability(mesh, state.flotation);
  return state;
}

/// The turn into the axes from which a body's heel counts; none if it has them.
std::optional<Eigen::Isometry3d> turn_upright(const FloatingBody& body) {
  const Eigen::RowVector3d up_B = body.start.toRotationMatrix().row(2);
  Eigen::Index axis = 2;
  up_B.cwiseAbs().maxCoeff(&axis);
  if (axis == 2 && up_B[2] > 0) return std::nullopt;
  const Eigen::Vector3d nearest = std::copysign(1.0, up_B[axis]) * Eigen::Vector3d::Unit(axis);
  const Eigen::Vector3d leaning = body.start * nearest;
  const Eigen::Quaterniond to_vertical = hydro::shortest_turn(leaning, Eigen::Vector3d::UnitZ());
  return Eigen::Isometry3d(hydro::with_heading(to_vertical * body.start, 0));
}

}  // namespace

void refuse_if(bool given, const std::string& option, const std::string& message) {
  if (given) throw scene::InputError(option, message);
}

FloatingBody in_upright_axes(const FloatingBody& body) {
  const auto turn = turn_upright(body);
  if (!turn) return body;
  FloatingBody turned = body;
  turned.mesh_B = hydro::transformed(body.mesh_B, *turn);
  turned.com_M = *turn * body.com_M;
  for (hydro::Tank& tank : turned.tanks)
    tank.hull =
        hydro::make_hull(hydro::transformed(tank.hull.mesh_B, *turn), hydro::Hull::Boundary::open);
  for (Eigen::Vector3d& point : turned.flooding_points_B) point = *turn * point;
  return turned;
}

double FloatingBody::water_inside() const {
  double sum = 0;
  for (const hydro::Tank& tank : tanks) sum += tank.volume;
  return sum;
}

std::vector<FloatingBody> floating_bodies(const HydrostaticsOptions& options) {
  if (scene::is_scene_file(options.file)) return bodies_of_scene(options);
  return {body_of_mesh(options)};
}

FloatingReport floating_report(const FloatingBody& body, const std::vector<double>& heels) {
  FloatingReport report{.body = body,
                        .upright = in_upright_axes(body),
                        .volume = hydro::solid_properties(body.mesh_B).volume};
  report.not_afloat = assembly::why_not_afloat({body.mass, body.density * body.water_inside()},
                                               report.volume, body.density);
  if (!report.not_afloat.empty()) return report;
  const auto mesh = std::make_shared<const hydro::ImmersedMesh>(body.mesh_B);
  const hydro::Flotation rest = hydro::equilibrium(*mesh, body.displaced(), body.start, body.tanks);
  report.start = state_of(body, *mesh, body.start);
  report.rest = state_of(body, *mesh, rest.orientation);
  report.orientation = hydro::with_heading(rest.orientation, hydro::euler_angles(body.start)[2]);
  if (body.natural_periods)
    report.natural_periods = body.natural_periods(
        {.orientation = hydro::with_heading(rest.orientation, 0), .height = rest.height});
  const FloatingBody& heeled = report.upright;
  report.upright_mesh =
      turn_upright(body) ? std::make_shared<const hydro::ImmersedMesh>(heeled.mesh_B) : mesh;
  report.righting_arms =
      hydro::righting_arms(*report.upright_mesh, heeled.displaced(), heels, heeled.tanks);
  report.intact = hydro::intact_stability(
      report.intact_body(), report.rest.flotation.effective_metacentric_heights()(0, 0));
  return report;
}

}  // namespace app

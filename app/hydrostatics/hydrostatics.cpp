#include "app/hydrostatics/hydrostatics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/assembly/build.h"
#include "app/assembly/build_start.h"
#include "app/assembly/mesh_io.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/terminal_reporter.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh_check.h"

namespace app {
namespace {

void refuse_if(bool given, const std::string& option, const std::string& message) {
  if (given) throw scene::InputError(option, message);
}

void check_positive(const std::optional<double>& value, const std::string& option,
                    const std::string& unit) {
  if (value && !(*value > 0 && std::isfinite(*value)))
    throw scene::InputError(
        option, fmt::format("found {:g}, expected a positive number [{}]", *value, unit));
}

/// Returns the mass that floats at a draught with the mesh's z axis up [kg].
double mass_at_draught(const hydro::TriMesh& mesh_B, double draught, double density) {
  const double height = mesh_B.vertices.row(2).maxCoeff() - mesh_B.vertices.row(2).minCoeff();
  if (draught >= height)
    throw scene::InputError(
        "--draught",
        fmt::format("found {:g}, expected less than the mesh's height, {:g} m", draught, height));
  const double com_height = -mesh_B.vertices.row(2).minCoeff() - draught;
  return density * hydro::hydrostatics(mesh_B, com_height).volume;
}

void check_mesh_options(const HydrostaticsOptions& o) {
  refuse_if(!o.overrides.empty(), "--set", "is for a scene, and this is a mesh");
  refuse_if(o.mass && o.draught, "--draught", "given beside --mass, expected only one of them");
  refuse_if(!o.mass && !o.draught, "--mass", "missing, expected the body's mass, or its --draught");
  check_positive(o.mass, "--mass", "kg");
  check_positive(o.draught, "--draught", "m");
  check_positive(o.density, "--density", "kg/m^3");
  refuse_if(o.center_of_mass && !o.center_of_mass->allFinite(), "--com", "expected finite numbers");
}

FloatingBody body_of_mesh(const HydrostaticsOptions& o) {
  check_mesh_options(o);
  TerminalReporter reporter(false);
  const hydro::TriMesh mesh = assembly::read_solid(o.file, reporter);
  FloatingBody body{.name = o.file.stem().string(),
                    .com_M = o.center_of_mass.value_or(hydro::solid_properties(mesh).centroid),
                    .density = o.density.value_or(1000)};
  body.mesh_B = hydro::translated(mesh, -body.com_M);
  body.mass = o.mass ? *o.mass : mass_at_draught(body.mesh_B, *o.draught, body.density);
  return body;
}

void check_scene_options(const HydrostaticsOptions& o) {
  const std::string message = "is for a mesh; a scene has its own, see --set";
  refuse_if(o.mass.has_value(), "--mass", message);
  refuse_if(o.draught.has_value(), "--draught", message);
  refuse_if(o.density.has_value(), "--density", message);
  refuse_if(o.center_of_mass.has_value(), "--com", message);
}

std::vector<FloatingBody> bodies_of_scene(const HydrostaticsOptions& o) {
  check_scene_options(o);
  const scene::Scene scene = scene::read(o.file, o.overrides);
  scene::Faults faults;
  if (!scene.water) faults.add(scene.places, "water", "missing, and without water nothing floats");
  if (scene.gravity == 0)
    faults.add(scene.places, "gravity", "found 0, and without it nothing floats");
  faults.throw_if_any();
  const assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  for (const std::string& note : built.notes)
    say(fmt::format("{}: note: {}", scene.file.string(), note));
  std::vector<FloatingBody> bodies;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const engine::BodySpec& spec = built.spec.bodies[i];
    if (!spec.coefficients.buoyancy) continue;
    bodies.push_back({.name = spec.name,
                      .mesh_B = spec.mesh_B,
                      .com_M = built.centers_of_mass[i],
                      .mass = spec.mass,
                      .density = scene.water->density,
                      .gravity = scene.gravity,
                      .start = scene.bodies[i].orientation});
  }
  if (bodies.empty()) throw scene::InputError(scene.file, "has no body with buoyancy");
  return bodies;
}

FloatingState state_of(const hydro::TriMesh& mesh_B, double displaced,
                       const Eigen::Quaterniond& orientation) {
  FloatingState state{hydro::afloat(mesh_B, displaced, hydro::with_heading(orientation, 0))};
  state.stability = hydro::stability(mesh_B, state.flotation);
  return state;
}

/// Checks that a body floats. @throws InputError with the reason for each body if none does.
void check_that_one_floats(const std::vector<FloatingReport>& reports,
                           const std::filesystem::path& file) {
  std::vector<scene::Fault> faults;
  for (const FloatingReport& report : reports) {
    if (report.not_afloat.empty()) return;
    faults.push_back({{file}, report.body.name, report.not_afloat});
  }
  throw scene::InputError(std::move(faults));
}

}  // namespace

std::vector<FloatingBody> floating_bodies(const HydrostaticsOptions& options) {
  if (scene::is_scene_file(options.file)) return bodies_of_scene(options);
  return {body_of_mesh(options)};
}

FloatingReport floating_report(const FloatingBody& body, const std::vector<double>& heels) {
  FloatingReport report{.body = body, .volume = hydro::solid_properties(body.mesh_B).volume};
  report.not_afloat = assembly::why_not_afloat(body.mass, report.volume, body.density);
  if (!report.not_afloat.empty()) return report;
  const double displaced = body.mass / body.density;
  const hydro::Flotation rest = hydro::equilibrium(body.mesh_B, displaced, body.start);
  report.start = state_of(body.mesh_B, displaced, body.start);
  report.rest = state_of(body.mesh_B, displaced, rest.orientation);
  report.orientation = hydro::with_heading(rest.orientation, hydro::euler_angles(body.start)[2]);
  report.righting_arms = hydro::righting_arms(body.mesh_B, displaced, heels);
  return report;
}

int hydrostatics(const HydrostaticsOptions& options) {
  refuse_if(options.json && options.csv, "--csv", "given beside --json, expected only one of them");
  std::vector<FloatingReport> reports;
  for (const FloatingBody& body : floating_bodies(options))
    reports.push_back(floating_report(body, options.heels));
  check_that_one_floats(reports, options.file);
  fmt::print("{}", options.json  ? floating_json(reports)
                   : options.csv ? floating_csv(reports)
                                 : floating_table(reports));
  flush_output();
  return kDone;
}

}  // namespace app

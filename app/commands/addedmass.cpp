#include "app/commands/addedmass.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/assembly/build.h"
#include "app/assembly/build_added_mass.h"
#include "app/assembly/mesh_io.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/json_rows.h"
#include "app/base/terminal_reporter.h"
#include "app/scene/diagnostics.h"
#include "hydro/added_mass/added_mass.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh_check.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

/// A body wholly submerged in water.
struct Submerged {
  std::string name;
  assembly::CenteredMesh solid;
  Eigen::Vector3d com_M = Eigen::Vector3d::Zero();
  double density = 1000;  ///< Density of the water [kg/m^3].
};

Submerged body_of_mesh(const AddedMassCommand& o) {
  if (!o.overrides.empty()) throw scene::InputError("--set", "is for a scene, and this is a mesh");
  TerminalReporter reporter(false);
  hydro::TriMesh mesh = assembly::read_solid(o.file, reporter, o.formats, o.frame);
  Submerged body{.name = o.file.stem().string(),
                 .com_M = hydro::solid_properties(mesh).centroid,
                 .density = o.density.value_or(1000)};
  body.solid.mesh_C = hydro::translated(std::move(mesh), -body.com_M);
  return body;
}

/// Moves a closed mesh to the centroid of its volume.
assembly::CenteredMesh centered(const hydro::TriMesh& mesh_B) {
  const Eigen::Vector3d centroid_B = hydro::solid_properties(mesh_B).centroid;
  return {hydro::translated(mesh_B, -centroid_B), -centroid_B};
}

std::vector<Submerged> bodies_of_scene(const AddedMassCommand& o) {
  assembly::refuse_frame(o.frame);
  const scene::Scene scene = scene::read(o.file, o.overrides, o.formats);
  const assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  for (const std::string& note : built.notes)
    say(fmt::format("{}: note: {}", scene.file.string(), note));
  const double density = o.density.value_or(scene.water ? scene.water->density : 1000);
  std::vector<Submerged> bodies;
  std::vector<scene::Fault> faults;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const engine::BodySpec& spec = built.spec.bodies[i];
    const std::vector<std::string> wrong = hydro::describe(hydro::check_mesh(spec.mesh_B));
    if (!wrong.empty()) faults.push_back({{scene.file}, spec.name, wrong.front()});
    // A body whose scene needs no closed mesh has no solid.
    const assembly::CenteredMesh& solid = built.solids[i];
    bodies.push_back({spec.name, solid.mesh_C.face_count() > 0 ? solid : centered(spec.mesh_B),
                      built.centers_of_mass[i], density});
  }
  if (!faults.empty()) throw scene::InputError(std::move(faults));
  return bodies;
}

std::vector<Submerged> bodies_of(const AddedMassCommand& o) {
  if (o.density && !(*o.density > 0 && std::isfinite(*o.density)))
    throw scene::InputError(
        "--density", fmt::format("found {:g}, expected a positive number [kg/m^3]", *o.density));
  if (!(o.options.tolerance > 0 && std::isfinite(o.options.tolerance)))
    throw scene::InputError(
        "--tolerance", fmt::format("found {:g}, expected a positive number", o.options.tolerance));
  if (scene::is_scene_file(o.file)) return bodies_of_scene(o);
  return {body_of_mesh(o)};
}

/// A solution about the body's centre of mass, and a flag for one from the store.
struct Found {
  hydro::AddedMassSolution solution;
  bool from_store = false;
};

Json to_json(const Submerged& body, const Found& found) {
  const hydro::AddedMassSolution& solution = found.solution;
  const hydro::Matrix6d matrix = body.density * solution.matrix;
  return {{"volume", hydro::solid_properties(body.solid.mesh_C).volume},
          {"com", {body.com_M.x(), body.com_M.y(), body.com_M.z()}},
          {"density", body.density},
          {"added_mass", json_rows(matrix)},
          {"error_estimate", solution.error_estimate},
          {"symmetry_error", solution.symmetry_error},
          {"panels", solution.panels},
          {"unknowns", solution.unknowns},
          {"from_store", found.from_store},
          {"seconds", solution.seconds},
          {"bytes", solution.bytes}};
}

/// Prints the matrix row by row, including entries below the symmetry error or round-off.
std::string table_of(const Submerged& body, const Found& found) {
  const hydro::AddedMassSolution& solution = found.solution;
  std::string text = fmt::format(
      "{}: volume {:.6g} m^3, centre of mass {:.6g} {:.6g} {:.6g} m, water {:g} kg/m^3\n",
      body.name, hydro::solid_properties(body.solid.mesh_C).volume, body.com_M.x(), body.com_M.y(),
      body.com_M.z(), body.density);
  text += fmt::format("{:>9}{:>14}{:>14}{:>14}{:>14}{:>14}{:>14}\n", "", "surge", "sway", "heave",
                      "roll", "pitch", "yaw");
  const char* const names[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
  const double largest = solution.matrix.cwiseAbs().maxCoeff();
  for (int i = 0; i < 6; ++i) {
    text += fmt::format("{:>9}", names[i]);
    for (int j = 0; j < 6; ++j) {
      const double value = solution.matrix(i, j);
      text += fmt::format("{:>14.6g}", std::abs(value) < 1e-9 * largest ? 0 : body.density * value);
    }
    text += "\n";
  }
  if (solution.error_estimate > 0)
    text += fmt::format("  error below {:.2g} %", 100 * solution.error_estimate);
  text += fmt::format("  asymmetry {:.2g} %, {} unknowns on {} panels, {:.2f} s, {:.0f} MB{}\n",
                      100 * solution.symmetry_error, solution.unknowns, solution.panels,
                      solution.seconds, solution.bytes / 1e6,
                      found.from_store ? ", from the store" : "");
  return text;
}

}  // namespace

int addedmass(const AddedMassCommand& command) {
  Json all = Json::object();
  std::string text;
  TerminalReporter reporter(false);
  assembly::AddedMassStore store(command.store ? assembly::cache_folder() : std::nullopt);
  for (const Submerged& body : bodies_of(command)) {
    const assembly::StoredAddedMass stored =
        assembly::solved_added_mass(body.name, body.solid.mesh_C, command.options, store, reporter);
    const Found found = {hydro::moved_origin(*stored.solution, body.solid.com_C),
                         stored.from_store};
    if (command.json)
      all[body.name] = to_json(body, found);
    else
      text += table_of(body, found);
  }
  print(command.json
            ? Json{{"bodies", all}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
            : text);
  flush_output();
  return kDone;
}

}  // namespace app

#include "app/assembly/radiation_database.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/databases/fit_to_body.h"
#include "hydro/airy_waves.h"

namespace assembly {
namespace {

bool has_file(const scene::Body& body) {
  return body.hydro.radiation.source == scene::Radiation::Source::file;
}

/// The database of an earlier body with the same keys, mesh and mean pose; none without one.
std::shared_ptr<const RadiationDatabase> known(const scene::Scene& scene,
                                               const engine::SimulationSpec& spec,
                                               const std::vector<RadiationChoice>& choices,
                                               std::size_t i) {
  for (std::size_t j = 0; j < i; ++j) {
    if (choices[j].database && choices[j].pose == choices[i].pose &&
        hydro::same_mesh(radiating_mesh(choices[i], spec.bodies[i]),
                         radiating_mesh(choices[j], spec.bodies[j])) &&
        scene.bodies[j].hydro.radiation.database == scene.bodies[i].hydro.radiation.database)
      return choices[j].database;
  }
  return nullptr;
}

/// Limits a database to `frequencies`. @return false after a fault
bool within_range(const scene::Scene& scene, std::size_t i, databases::Database& read,
                  scene::Faults& faults) {
  const auto& range = scene.bodies[i].hydro.radiation.database.frequencies;
  if (!range) return true;
  const double first = read.frequencies.front(), last = read.frequencies.back();
  const std::size_t left = databases::limit_frequencies((*range)[0], (*range)[1], read);
  if (left >= 2) return true;
  faults.add(scene.places, fmt::format("bodies[{}].hydro.radiation.frequencies", i),
             fmt::format("found [{:g}, {:g}], in which lie {} of the file's frequencies, {:.4g} to "
                         "{:.4g} rad/s; expected at least 2",
                         (*range)[0], (*range)[1], left, first, last));
  return false;
}

}  // namespace

void read_databases(const scene::Scene& scene, const engine::SimulationSpec& spec,
                    std::vector<RadiationChoice>& choices, scene::Faults& faults) {
  for (std::size_t i = 0; i < choices.size(); ++i) {
    RadiationChoice& choice = choices[i];
    if (!choice.pose || !has_file(scene.bodies[i])) continue;
    choice.database = known(scene, spec, choices, i);
    if (choice.database) continue;
    const scene::RadiationFile& source = scene.bodies[i].hydro.radiation.database;
    const hydro::Sea& sea = *spec.sea;
    try {
      databases::Database read = databases::read_database(source, sea.gravity);
      if (!within_range(scene, i, read, faults)) continue;
      choice.database = std::make_shared<const RadiationDatabase>(RadiationDatabase{
          .file = source.file,
          .format = read.format,
          .body = read.body,
          .found = databases::fit_to_body(read, source,
                                          {.mesh_B = radiating_mesh(choice, spec.bodies[i]),
                                           .pose = *choice.pose,
                                           .water = {.gravity = sea.gravity, .depth = sea.depth},
                                           .waves = hydro::has_airy_waves(sea)})});
    } catch (const scene::InputError& error) {
      for (const scene::Fault& fault : error.faults())
        faults.add(scene.places, fmt::format("bodies[{}].hydro.radiation.file", i),
                   scene::to_string(fault));
    }
  }
}

std::vector<std::string> database_notes(const engine::SimulationSpec& spec,
                                        const std::vector<RadiationChoice>& choices) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const auto& database = choices[i].database;
    if (!database) continue;
    const bool told = std::any_of(choices.begin(), choices.begin() + static_cast<std::ptrdiff_t>(i),
                                  [&](const auto& other) { return other.database == database; });
    if (told) continue;
    for (const std::string& note : database->found.notes)
      lines.push_back(
          fmt::format("{}: {}: {}", spec.bodies[i].name, database->file.filename().string(), note));
  }
  return lines;
}

}  // namespace assembly

#include "app/assembly/stored_solutions.h"

#include <set>

#include "app/assembly/added_mass_store.h"
#include "app/assembly/build_added_mass.h"
#include "app/assembly/build_radiation.h"
#include "app/assembly/radiation_store.h"
#include "engine/motion/body.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

/// Returns the files in which a store has the solutions of a scene, whether they are there or not.
std::set<fs::path> files_of(const scene::Scene& scene, const BuiltScene& built,
                            const fs::path& folder) {
  const RadiationStore radiation(folder);
  const AddedMassStore added_mass(folder);
  std::set<fs::path> files;
  if (!built.spec.sea) return files;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const engine::BodySpec& body = built.spec.bodies[i];
    const RadiationChoice& choice = built.radiation[i].choice;
    if (choice.pose && !choice.database && !choice.simulated)
      files.insert(radiation.file_of(radiation_problem(choice, body, *built.spec.sea)));
    if (!built.added_mass[i]) continue;
    files.insert(added_mass.file_of(built.solids[i].mesh_C,
                                    {.tolerance = scene.bodies[i].hydro.added_mass.tolerance}));
    if (built.added_mass[i]->surface)
      files.insert(added_mass.nodes_file_of(engine::outside_B(body)));
  }
  return files;
}

}  // namespace

void copy_solutions(const scene::Scene& scene, const BuiltScene& built, const fs::path& from,
                    const fs::path& to) {
  fs::create_directories(to);
  for (const fs::path& file : files_of(scene, built, from))
    if (is_there(file)) fs::copy_file(file, to / file.filename(), fs::copy_options::skip_existing);
}

}  // namespace assembly

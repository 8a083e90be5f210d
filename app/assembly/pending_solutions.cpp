#include "app/assembly/pending_solutions.h"

#include <fmt/format.h>

#include <set>

#include "app/assembly/build_added_mass.h"
#include "app/assembly/build_radiation.h"
#include "app/assembly/solve_time.h"
#include "app/base/progress.h"
#include "app/base/words.h"

namespace assembly {
namespace {

/// The names of solutions that a line tells at most.
constexpr std::size_t kMostNames = 3;

}  // namespace

std::vector<PendingSolution> pending_solutions(const scene::Scene& scene, const BuiltScene& built,
                                               const std::optional<std::filesystem::path>& folder,
                                               int threads) {
  std::vector<PendingSolution> pending;
  if (built.spec.integrator.method == engine::Integrator::Method::ode || !built.spec.sea)
    return pending;
  RadiationStore radiation(folder);
  AddedMassStore added_mass(folder);
  std::set<std::filesystem::path> files;
  const auto is_new = [&](const std::filesystem::path& file) {
    return file.empty() || files.insert(file).second;
  };
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const engine::BodySpec& body = built.spec.bodies[i];
    const RadiationChoice& choice = built.radiation[i].choice;
    if (choice.simulated) continue;
    if (choice.pose && !choice.database) {
      const RadiationProblem problem = radiation_problem(choice, body, *built.spec.sea);
      const auto triangles = static_cast<double>(problem.mesh_B.face_count());
      if (is_new(radiation.file_of(problem)) && !radiation.find(problem))
        pending.push_back({"radiation of " + body.name, radiation_seconds(triangles, threads)});
    } else if (added_mass_model(scene, built, i) == scene::AddedMass::Model::deep) {
      const hydro::TriMesh& mesh_C = built.solids[i].mesh_C;
      const hydro::AddedMassOptions options{.tolerance =
                                                scene.bodies[i].hydro.added_mass.tolerance};
      const auto triangles = static_cast<double>(mesh_C.face_count());
      if (is_new(added_mass.file_of(mesh_C, options)) && !added_mass.find(mesh_C, options))
        pending.push_back({"added mass of " + body.name, added_mass_seconds(triangles, threads)});
    }
  }
  return pending;
}

std::string pending_text(const std::vector<PendingSolution>& pending) {
  if (pending.empty()) return "";
  double seconds = 0;
  std::vector<std::string> names;
  for (const PendingSolution& solution : pending) {
    seconds += solution.seconds;
    if (names.size() < kMostNames) names.push_back(solution.what);
  }
  if (pending.size() > names.size())
    names.push_back(fmt::format("{} more", pending.size() - names.size()));
  return fmt::format("{}, once for all runs: some {}", app::enumerate(names, "and"),
                     app::rough_time(seconds));
}

}  // namespace assembly

#include "app/commands/check.h"

#include <fmt/format.h>

#include "app/assembly/build.h"
#include "app/assembly/pending_solutions.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/thread_count.h"
#include "app/run/body_tables.h"
#include "app/run/piece_warning.h"
#include "app/run/step_cost.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// Tells what a step costs, without added mass, which is not solved for here.
void describe_cost(engine::SimulationSpec spec) {
  spec.threads = thread_count(0);
  try {
    engine::Simulation simulation(std::move(spec));
    if (const std::optional<StepCost> cost = measured_cost(simulation))
      print(fmt::format("  cost without added mass: {}\n", cost_text(*cost, simulation.spec())));
  } catch (const engine::SimulationError&) {
    // A run tells it.
  }
}

void describe(const scene::Scene& scene, const assembly::BuiltScene& built) {
  Eigen::Index triangles = 0;
  for (const engine::BodySpec& body : built.spec.bodies) triangles += body.mesh_B.face_count();
  print(fmt::format("{}: ok: {}, {} triangles, {}\n", scene.file.string(),
                    counted(built.spec.bodies.size(), "body", "bodies"), triangles,
                    counted(built.spec.joints.size(), "joint", "joints")));
  for (const std::string& line : BodyTables(scene, built).sizes()) print(fmt::format("{}\n", line));
  describe_cost(built.spec);
  const std::string pending = assembly::pending_text(
      assembly::pending_solutions(scene, built, assembly::cache_folder(), thread_count(0)));
  if (!pending.empty()) print(fmt::format("  to solve before the first step: {}\n", pending));
  std::vector<assembly::RadiationChoice> radiation;
  for (const assembly::RadiationReport& report : built.radiation)
    radiation.push_back(report.choice);
  if (built.spec.sea)
    for (const std::string& line : assembly::radiation_lines(built.spec, radiation))
      print(fmt::format("{}: {}\n", scene.file.string(), line));
  for (const std::string& note : built.notes)
    print_message(fmt::format("{}: note: {}", scene.file.string(), note));
  for (const std::string& warning : built.warnings)
    print_message(fmt::format("{}: warning: {}", scene.file.string(), warning));
  if (const std::optional<std::string> warning = piece_warning(built.spec))
    print_message(fmt::format("{}: warning: {}", scene.file.string(), *warning));
}

}  // namespace

int check(const std::vector<std::filesystem::path>& scenes,
          const std::vector<scene::Override>& overrides, scene::MeshFormats formats) {
  std::vector<scene::Fault> faults;
  for (const std::filesystem::path& file : scenes) {
    try {
      const scene::Scene scene = scene::read(file, overrides, formats);
      describe(scene, assembly::build_without_added_mass(scene));
    } catch (const scene::InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  flush_output();
  if (!faults.empty()) throw scene::InputError(faults);
  return kDone;
}

int print_expanded(const std::vector<std::filesystem::path>& scenes,
                   const std::vector<scene::Override>& overrides) {
  for (const std::filesystem::path& file : scenes)
    print(fmt::format("{}{}", scenes.size() > 1 ? "---\n" : "",
                      scene::resolved_text(file, overrides)));
  flush_output();
  return kDone;
}

}  // namespace app

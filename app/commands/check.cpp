#include "app/commands/check.h"

#include <fmt/format.h>

#include "app/assembly/build.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/run/body_tables.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

void describe(const scene::Scene& scene, const assembly::BuiltScene& built) {
  Eigen::Index triangles = 0;
  for (const engine::BodySpec& body : built.spec.bodies) triangles += body.mesh_B.face_count();
  print(fmt::format("{}: ok: {}, {} triangles, {}\n", scene.file.string(),
                    counted(built.spec.bodies.size(), "body", "bodies"), triangles,
                    counted(built.spec.joints.size(), "joint", "joints")));
  for (const std::string& line : BodyTables(scene, built).sizes()) print(fmt::format("{}\n", line));
  std::vector<assembly::RadiationChoice> radiation;
  for (const assembly::RadiationReport& report : built.radiation)
    radiation.push_back(report.choice);
  if (built.spec.sea)
    for (const std::string& line : assembly::radiation_lines(built.spec, radiation))
      print(fmt::format("{}: {}\n", scene.file.string(), line));
  for (const std::string& note : built.notes)
    print(fmt::format("{}: note: {}\n", scene.file.string(), note));
  for (const std::string& warning : built.warnings)
    print(fmt::format("{}: warning: {}\n", scene.file.string(), warning));
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

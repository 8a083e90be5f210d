#include "app/commands/check.h"

#include <fmt/format.h>

#include "app/assembly/assemble.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

void describe(const Scene& scene, const Assembly& assembly) {
  Eigen::Index triangles = 0;
  for (const engine::BodySpec& body : assembly.spec.bodies) triangles += body.mesh_B.face_count();
  fmt::print("{}: ok: {}, {} triangles, {}\n", scene.file.string(),
             counted(assembly.spec.bodies.size(), "body", "bodies"), triangles,
             counted(assembly.spec.joints.size(), "joint", "joints"));
  for (const std::string& note : assembly.notes)
    fmt::print("{}: note: {}\n", scene.file.string(), note);
}

}  // namespace

int check(const std::vector<std::filesystem::path>& scenes,
          const std::vector<Override>& overrides) {
  std::vector<Fault> faults;
  for (const std::filesystem::path& file : scenes) {
    try {
      const Scene scene = read_scene(file, overrides);
      describe(scene, assemble(scene));
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  flush_output();
  if (!faults.empty()) throw InputError(faults);
  return kDone;
}

}  // namespace app

#include "app/assembly/mesh_io.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "app/assembly/mesh_mending.h"
#include "app/base/console.h"
#include "app/scene/diagnostics.h"
#include "hydro/mesh/mesh_check.h"

namespace assembly {

namespace fs = std::filesystem;
using hydro::TriMesh;

std::string note_of_dropped(const MeshFile& read) {
  if (read.dropped == 0) return "";
  return app::counted(static_cast<std::size_t>(read.dropped), "face without area was",
                      "faces without area were") +
         " dropped";
}

TriMesh read_mesh(const fs::path& file, scene::MeshFormats formats, const scene::MeshFrame& frame) {
  MeshFile read = read_welded(file, formats);
  return in_mesh_frame(std::move(read.mesh), applied_frame(read.frame, frame));
}

TriMesh read_solid(const fs::path& file, app::Reporter& reporter, scene::MeshFormats formats,
                   const scene::MeshFrame& frame) {
  MeshFile read = read_welded(file, formats);
  const std::string dropped = note_of_dropped(read);
  const MeshSource source{file, applied_frame(read.frame, frame)};
  hydro::RepairedMesh repaired = hydro::repaired(in_mesh_frame(std::move(read.mesh), source.frame));
  std::vector<scene::Fault> faults;
  for (const std::string& fault : hydro::describe(repaired.report))
    faults.push_back({{file}, "", fault});
  if (!faults.empty() && repaired.mesh.face_count() > 0)
    faults.back().message += "; " + remedy_text(repaired.mesh, file, RemedyWords::options);
  if (!faults.empty()) throw scene::InputError(std::move(faults));
  if (!dropped.empty()) reporter.note(file.string() + ": note: " + dropped);
  for (const std::string& note : repaired.notes) reporter.note(file.string() + ": note: " + note);
  if (!source.frame.changes_nothing())
    reporter.note(fmt::format("{}: note: {}", file.string(), description(source.frame)));
  const std::string warning = size_warning(repaired.mesh, source, "--unit ");
  if (!warning.empty()) reporter.warning(warning);
  return std::move(repaired.mesh);
}

void refuse_frame(const scene::MeshFrame& frame) {
  for (const auto& [given, option] :
       {std::pair(frame.up.has_value(), "--up"), std::pair(frame.unit.has_value(), "--unit"),
        std::pair(frame.scale != 1, "--scale")})
    if (given)
      throw scene::InputError(option, "is for a mesh; the meshes of a scene have keys, see --set");
}

}  // namespace assembly

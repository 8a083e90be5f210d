#include "app/assembly/mesh_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "app/assembly/mesh_mending.h"
#include "app/assembly/mesh_reader_process.h"
#include "app/base/console.h"
#include "app/scene/diagnostics.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/weld.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;
using hydro::TriMesh;

/// Distance within which vertices are one [m]: one step of a float, 2^-23, at the largest
/// coordinate, or at the size of a mesh that is farther away and not rounded to floats.
double weld_distance(const MeshFile& read) {
  const hydro::TriMesh& mesh = read.mesh;
  const double farthest = mesh.vertices.cwiseAbs().maxCoeff();
  const double size = hydro::bounding_box(mesh).sizes().maxCoeff();
  return 0x1p-23 * (read.rounding == Rounding::of_floats ? farthest : std::min(farthest, size));
}

}  // namespace

MeshFile read_welded(const fs::path& file, scene::MeshFormats formats) {
  MeshFile read = read_mesh_file(file, formats);
  if (read.mesh.face_count() == 0) throw scene::InputError(file, "the file holds no triangles");
  const Eigen::Index faces = read.mesh.face_count();
  read.mesh = welded(read.mesh, weld_distance(read));
  read.dropped = faces - read.mesh.face_count();
  if (read.mesh.face_count() == 0)
    throw scene::InputError(file, "all triangles of the file are degenerate");
  return read;
}

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

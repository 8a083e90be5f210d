#include "app/assembly/mesh_io.h"

#include <utility>
#include <vector>

#include "app/assembly/mesh_reader_process.h"
#include "app/scene/diagnostics.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/weld.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;
using hydro::TriMesh;

/// Welding distance relative to the largest coordinate: one step of a float, 2^-23.
constexpr double kWeld = 0x1p-23;

}  // namespace

TriMesh read_mesh(const fs::path& file, scene::MeshFormats formats) {
  const TriMesh parts = read_mesh_file(file, formats).mesh;
  if (parts.face_count() == 0) throw scene::InputError(file, "the file holds no triangles");
  TriMesh mesh = welded(parts, kWeld * parts.vertices.cwiseAbs().maxCoeff());
  if (mesh.face_count() == 0)
    throw scene::InputError(file, "all triangles of the file are degenerate");
  return mesh;
}

TriMesh read_solid(const fs::path& file, app::Reporter& reporter, scene::MeshFormats formats) {
  hydro::RepairedMesh repaired = hydro::repaired(read_mesh(file, formats));
  std::vector<scene::Fault> faults;
  for (const std::string& fault : hydro::describe(repaired.report))
    faults.push_back({{file}, "", fault});
  if (!faults.empty()) throw scene::InputError(std::move(faults));
  for (const std::string& note : repaired.notes) reporter.note(file.string() + ": note: " + note);
  return std::move(repaired.mesh);
}

}  // namespace assembly

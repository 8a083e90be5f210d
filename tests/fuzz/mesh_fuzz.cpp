#include "app/assembly/msh_reader.h"
#include "app/assembly/obj_reader.h"
#include "app/assembly/off_reader.h"
#include "app/assembly/panel_reader.h"
#include "app/assembly/ply_reader.h"
#include "app/assembly/stl_reader.h"
#include "tests/fuzz/fuzz_input.h"

/// @file
/// Mesh files of the formats that the program reads without a library. Each input is given to every
/// reader. What is read must be whole: finite vertices, and faces that name them.

namespace {

void expect_whole(const hydro::TriMesh& mesh) {
  if (!mesh.vertices.allFinite()) std::abort();
  for (const int v : mesh.faces.reshaped())
    if (v < 0 || v >= mesh.vertex_count()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path name = "hull";
  for (const auto read :
       {assembly::read_obj, assembly::read_off, assembly::read_ply, assembly::read_stl,
        assembly::read_gdf, assembly::read_nemoh_mesh, assembly::read_pnl, assembly::read_msh})
    fuzz::expect_content_or_faults(
        name.string(), [&] { expect_whole(read(name, fuzz::text_of(data, size)).mesh); });
  return 0;
}

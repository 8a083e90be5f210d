#pragma once

#include <filesystem>

#include "app/assembly/mesh_frame.h"
#include "app/scene/shape.h"
#include "hydro/mesh/mesh.h"

namespace assembly {

/// A mesh as its file has it: vertices are repeated, nothing is turned or scaled.
struct MeshFile {
  hydro::TriMesh mesh;
  StatedFrame frame;
};

/// True if files of this extension are read by default.
bool is_common_mesh_format(const std::filesystem::path& file);

/// Reads the triangles of a mesh file by assimp, in this process: a damaged file may crash it, hang
/// it, or fill its memory. It is called in a process of its own, by read_mesh_file, which ends
/// after it: what assimp holds is not freed.
/// @throws InputError if the file cannot be read, is of another format or breaks a limit
MeshFile parse_mesh(const std::filesystem::path& file, scene::MeshFormats formats);

}  // namespace assembly

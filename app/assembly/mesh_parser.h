#pragma once

#include <filesystem>

#include "app/assembly/mesh_frame.h"
#include "app/scene/shape.h"

namespace assembly {

/// True if files of this extension are read by default.
bool is_common_mesh_format(const std::filesystem::path& file);

/// Reads the triangles of a mesh file, in this process: OBJ, STL, PLY, OFF and files of panels by
/// readers of this program, whose coordinates are doubles, and other formats by assimp, which
/// stores floats. A damaged file may make assimp crash, run on or fill the memory. The function is
/// called in a process of its own, by read_welded, which ends after it: what assimp holds is not
/// freed.
/// @throws InputError if the file cannot be read, is of another format or breaks a limit
MeshFile parse_mesh(const std::filesystem::path& file, scene::MeshFormats formats);

}  // namespace assembly

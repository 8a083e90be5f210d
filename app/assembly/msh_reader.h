#pragma once

#include <filesystem>
#include <string_view>

#include "app/assembly/mesh_frame.h"

namespace assembly {

/// Reads the triangles and quadrangles of a Gmsh file of text, of version 2.2 or 4.1. Elements of
/// other kinds and higher order are left out.
/// @param file    Named in faults.
/// @throws InputError with the line of the fault
MeshFile read_msh(const std::filesystem::path& file, std::string_view bytes);

}  // namespace assembly

#pragma once

#include <filesystem>
#include <string_view>

#include "app/assembly/mesh_frame.h"

namespace assembly {

/// Reads the triangles of an STL file. It is binary if its size is that which the count at byte 80
/// announces, and else text, with any number of solids. The normals are left out: those of the
/// corners' order hold. A binary file stores floats.
/// @param file    Named in faults.
/// @throws InputError with the line of the fault, or the byte in a binary file
MeshFile read_stl(const std::filesystem::path& file, std::string_view bytes);

}  // namespace assembly

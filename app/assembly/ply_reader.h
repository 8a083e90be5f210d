#pragma once

#include <filesystem>
#include <string_view>

#include "app/assembly/mesh_frame.h"

namespace assembly {

/// Reads the faces of a PLY file, as text or binary in either order of bytes: `x`, `y` and `z` of
/// `vertex`, and `vertex_indices` (or `vertex_index`) of `face` and of `tristrips`, in which −1
/// begins another strip. Other elements and properties are left out. In a file of text each
/// element has a line of its own.
/// @param file    Named in faults.
/// @throws InputError with the line of the fault, or the byte in a binary file
MeshFile read_ply(const std::filesystem::path& file, std::string_view bytes);

}  // namespace assembly

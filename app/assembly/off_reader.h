#pragma once

#include <filesystem>
#include <string_view>

#include "app/assembly/mesh_frame.h"

namespace assembly {

/// Reads the faces of an OFF file of text, also of one with normals, colours or coordinates of a
/// texture (STCNOFF), which are left out, and one with weights (4OFF), by which the coordinates
/// are divided. The first word may be missing.
/// @param file    Named in faults.
/// @throws InputError with the line of the fault
MeshFile read_off(const std::filesystem::path& file, std::string_view bytes);

}  // namespace assembly

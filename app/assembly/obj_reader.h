#pragma once

#include <filesystem>
#include <string_view>

#include "app/assembly/mesh_frame.h"

namespace assembly {

/// Reads the faces of a Wavefront OBJ file: `v` and `f` of all objects and groups. Indices may be
/// negative, counted back from the last vertex so far. The fourth number of a vertex with four is
/// its weight, by which the others are divided; more numbers are a colour. Lines of other words, as
/// materials, normals and curves, are left out.
/// @param file    Named in faults.
/// @throws InputError with the line of the fault
MeshFile read_obj(const std::filesystem::path& file, std::string_view bytes);

}  // namespace assembly

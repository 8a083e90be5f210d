#pragma once

#include <filesystem>

#include "hydro/mesh/mesh.h"

namespace assembly {

/// True if a mesh can be written to a file of this name: .obj or .stl.
bool is_writable_mesh(const std::filesystem::path& file);

/// Writes a mesh in metres: as text of OBJ, whose numbers are read back to the same bits, or as a
/// binary STL file, whose coordinates are rounded to floats.
/// @throws std::runtime_error that names the file and says why it cannot be written
void write_mesh(const std::filesystem::path& file, const hydro::TriMesh& mesh);

}  // namespace assembly

#pragma once

#include <filesystem>

#include "hydro/mesh.h"

namespace app {

/// Reads the triangles of a mesh file in any format that assimp reads, all its parts as one mesh,
/// in the file's own frame and units, vertices that coincide welded into one.
/// @throws InputError if the file cannot be read, has no triangle or a vertex that is not finite.
hydro::TriMesh read_mesh(const std::filesystem::path& file);

}  // namespace app

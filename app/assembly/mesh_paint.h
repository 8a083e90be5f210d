#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>

#include "hydro/mesh/mesh.h"

namespace assembly {

/// The colours of a mesh file. Its triangles are those of the file, neither welded nor repaired.
struct MeshPaint {
  hydro::TriMesh mesh;      ///< In the axes and unit of the file.
  Eigen::Matrix3Xf colors;  ///< Displayed colour of each triangle, RGB 0 … 1; negative: none.
};

/// Reads the colours of an OBJ file with its materials (MTL), of glTF and of PLY by assimp, in a
/// process of its own: the base colours of materials, times the mean of those of the vertices.
/// Textures are left out.
/// @return none if the file has no colours, is of another format or cannot be read by assimp
std::optional<MeshPaint> read_paint(const std::filesystem::path& file);

}  // namespace assembly

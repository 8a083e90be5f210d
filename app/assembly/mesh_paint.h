#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/assembly/texture_source.h"
#include "hydro/mesh/mesh.h"

namespace assembly {

/// The colours of a mesh file. Its F triangles are those of the file, neither welded nor repaired.
struct MeshPaint {
  hydro::TriMesh mesh;      ///< In the axes and unit of the file.
  Eigen::Matrix3Xf colors;  ///< Displayed colour of each triangle, RGB 0 … 1; negative: none.

  std::vector<TextureSource> textures;  ///< If there are none, what follows is empty.
  Eigen::VectorXi texture_of;           ///< Texture of each triangle; −1: none.
  /// 2×3F: Texture coordinates of the corners of one triangle after the other, from the lower left
  /// corner of the image.
  Eigen::Matrix2Xf coordinates;
  Eigen::Matrix3Xf tints;  ///< 3×F: Displayed colours that multiply the textures.
  bool of_light = false;   ///< True: light is multiplied (glTF); false: displayed values (MTL).
};

/// Reads the colours of an OBJ file with its materials (MTL), of glTF and of PLY by assimp, in a
/// process of its own: the base colours of materials, times the mean of those of the vertices, and
/// where their textures are. A texture of a material without texture coordinates is left out.
/// @return none if the file has neither, is of another format or cannot be read by assimp
std::optional<MeshPaint> read_paint(const std::filesystem::path& file);

}  // namespace assembly

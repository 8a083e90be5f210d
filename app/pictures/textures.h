#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/assembly/texture_source.h"
#include "app/render/image.h"

namespace app {

/// Largest number of pixels of a texture that is read: such an image takes 0.3 GB.
inline constexpr double kMostTexturePixels = 1e8;

/// Longest side of a texture that is drawn [px]; longer ones are halved until they fit. All
/// graphics devices take this size.
inline constexpr int kLongestTextureSide = 4096;

/// Decoded textures.
struct ReadTextures {
  std::vector<std::shared_ptr<const render::Image>> images;  ///< Null where one cannot be read.
  std::vector<std::string> warnings;  ///< Name the mesh file and the texture.
};

/// Decodes the textures of a mesh file, PNG or JPEG, each in a process of its own
/// (isolated_reader.h) with 10 s and another second per megabyte of the file.
ReadTextures read_textures(const std::vector<assembly::TextureSource>& sources,
                           const std::filesystem::path& mesh_file);

}  // namespace app

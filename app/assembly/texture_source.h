#pragma once

#include <filesystem>
#include <string>

namespace assembly {

/// An image that a mesh file lays over triangles, as it is stored: PNG or JPEG.
struct TextureSource {
  std::string name;            ///< As messages name it.
  std::filesystem::path file;  ///< Beside or below the mesh file; empty if there is no such file.
  std::string bytes;           ///< The image itself where the mesh file has it.
};

}  // namespace assembly

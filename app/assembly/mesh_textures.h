#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/assembly/mesh_file_access.h"
#include "app/assembly/texture_source.h"

struct aiMaterial;
struct aiScene;

namespace assembly {

/// The texture of a material.
struct MaterialTexture {
  int number = -1;       ///< Among those of the file; −1: none.
  unsigned channel = 0;  ///< Set of texture coordinates.
};

/// Collects the textures of a mesh file that assimp has read, each once.
class TextureCollector {
 public:
  /// @param access   Tells which files may be read; it must outlive this, as the scene.
  TextureCollector(const std::filesystem::path& file, const aiScene& scene,
                   const MeshFileAccess& access)
      : folder_(file.parent_path()), scene_(scene), access_(access) {}

  MaterialTexture texture_of(const aiMaterial& material);

  const std::vector<TextureSource>& sources() const { return sources_; }

 private:
  /// Finds the file that a mesh file names: by its path from the mesh file's folder, with escapes
  /// of an address (`%20`) or without, else by its name alone in that folder.
  std::filesystem::path found(const std::string& name) const;
  TextureSource source_of(const std::string& path) const;

  std::filesystem::path folder_;
  const aiScene& scene_;
  const MeshFileAccess& access_;
  std::vector<TextureSource> sources_;
  std::map<std::string, int> numbers_;  ///< By the path in the material.
};

}  // namespace assembly

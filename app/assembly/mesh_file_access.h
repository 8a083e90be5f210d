#pragma once

#include <assimp/IOSystem.hpp>
#include <filesystem>

namespace assembly {

/// What assimp may open while it reads a mesh: the file itself and, for formats that name others,
/// regular files in its folder and below. Nothing is written. A pipe or a device, which could block
/// or never end, is as good as missing; so is a link that leads out of the folder.
class MeshFileAccess : public Assimp::IOSystem {
 public:
  /// @param with_others   True: the format names other files that hold parts of the mesh.
  MeshFileAccess(const std::filesystem::path& file, bool with_others);

  bool Exists(const char* path) const override;
  char getOsSeparator() const override { return '/'; }
  /// @return null if the file may not or cannot be read
  Assimp::IOStream* Open(const char* path, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  bool allows(const char* path) const;

  std::filesystem::path file_;    ///< Canonical.
  std::filesystem::path folder_;  ///< Canonical; of the name by which the file was given.
  bool with_others_;
};

}  // namespace assembly

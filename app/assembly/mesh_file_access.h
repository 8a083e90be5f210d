#pragma once

#include <assimp/IOSystem.hpp>
#include <cstdint>
#include <filesystem>
#include <set>

namespace assembly {

/// Files that assimp may open while it reads a mesh: the file itself and regular files in its
/// folder and below, which some formats name. Nothing is written. A pipe or a device, which could
/// block or never end, is as good as missing; so is a link that leads out of the folder.
class MeshFileAccess : public Assimp::IOSystem {
 public:
  explicit MeshFileAccess(const std::filesystem::path& file);

  bool Exists(const char* path) const override;
  char getOsSeparator() const override { return '/'; }
  /// @return null if the file may not or cannot be read
  Assimp::IOStream* Open(const char* path, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

  /// Size of all files that have been opened.
  std::uintmax_t bytes_opened() const;

 private:
  /// The file's canonical path; empty if it may not be read.
  std::filesystem::path allowed(const char* path) const;

  std::filesystem::path file_;              ///< Canonical.
  std::filesystem::path folder_;            ///< Canonical; of the name by which the file was given.
  std::set<std::filesystem::path> opened_;  ///< Canonical.
};

}  // namespace assembly

#pragma once

#include <filesystem>

#include "app/base/locked_file.h"

namespace app {

/// A folder that one run writes to. Other runs are refused meanwhile, so that their files do not
/// mix.
class OutputFolder {
 public:
  enum class Use {
    alone,
    shared  ///< Shared with other users of this value, which keep their files apart.
  };

  /// Creates and locks the folder, and removes temporary files that killed processes left in it.
  /// @throws InputError if it cannot be created or is in use for a second
  explicit OutputFolder(const std::filesystem::path& path, Use use = Use::alone);

  const std::filesystem::path& path() const { return path_; }

  /// True if the folder has been neither removed nor replaced, so that its files can be found.
  bool is_in_place() const;
  /// @throws OutputError if it has been
  void check_place() const;

 private:
  std::filesystem::path path_;
  LockedFile lock_;  ///< The folder itself.
};

}  // namespace app

#pragma once

#include <filesystem>

#include "app/base/locked_file.h"

namespace app {

/// A folder that one run writes to. Others that want it meanwhile are refused, so that no two runs
/// mix their files.
class OutputFolder {
 public:
  enum class Use {
    alone,
    shared  ///< With others that say so, too: they keep apart what they write by themselves.
  };

  /// Makes the folder and holds it. @throws InputError if it cannot be made or is in use.
  explicit OutputFolder(const std::filesystem::path& path, Use use = Use::alone);

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  LockedFile lock_;  ///< The folder itself.
};

}  // namespace app

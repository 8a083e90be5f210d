#pragma once

#include <filesystem>
#include <stdexcept>

namespace app {

/// A result that cannot be written, most often since the disk is full.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

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
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;  ///< File descriptor of the folder; the system drops the lock with the process.
};

}  // namespace app

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace app {

/// A new file beside another, in whose place it comes when it is done; until then it is removed
/// again. Parts of files with the same extension that a killed process left behind a day ago or
/// more are removed, too.
class PartFile {
 public:
  /// @throws std::runtime_error, as all below, that names the file and says why it cannot be
  /// written
  explicit PartFile(const std::filesystem::path& file);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  /// Under which it may be written by others, too.
  const std::string& name() const { return name_; }
  void write(std::string_view bytes) const;
  /// To be called last.
  void rename();

 private:
  std::filesystem::path file_;
  std::string name_;
  int handle_ = -1;
  bool renamed_ = false;
};

/// Writes a file, and folders above it that are missing, so that it is there with all its bytes or
/// stays as it was, whatever happens meanwhile: a full disk, a cut of power, another process that
/// does the same.
/// @throws std::runtime_error that names the file and says why it cannot be written
void write_whole(const std::filesystem::path& file, std::string_view bytes);

}  // namespace app

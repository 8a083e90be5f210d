#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace app {

/// A temporary file beside another one, which `rename` replaces by it; without that call the
/// destructor removes it. The file is locked until then, by which others know that its process is
/// alive. The constructor also removes temporary files for the same extension that killed processes
/// left in the folder.
class PartFile {
 public:
  /// @throws std::runtime_error, as `write` and `rename` do, that names the file and the reason
  explicit PartFile(const std::filesystem::path& file);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  /// Path of the temporary file; other code may write to it.
  const std::string& name() const { return name_; }
  void write(std::string_view bytes) const;
  /// Flushes the file to the disk and moves it to its final name. No call may follow.
  void rename();

 private:
  /// Makes and locks the file. @return false if there is another one of this name
  bool make();

  std::filesystem::path file_;
  std::string name_;
  int handle_ = -1;
  bool renamed_ = false;
};

/// Removes temporary files that killed processes left in a folder. On a file system without locks
/// they are those of yesterday and before.
/// @param extension   Extension of the files that they were for; empty: any.
void remove_left_parts(const std::filesystem::path& folder, const std::string& extension = "");

/// Writes a file and the missing folders above it. The file is complete or unchanged even after a
/// full disk, a power failure or a concurrent write by another process.
/// @throws std::runtime_error that names the file and says why it cannot be written
void write_whole(const std::filesystem::path& file, std::string_view bytes);

}  // namespace app

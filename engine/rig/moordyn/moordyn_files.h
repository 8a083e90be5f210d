#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

/// @file
/// The files between this program and MoorDyn: the copy of an input file that MoorDyn reads, and
/// the log that it writes beside it.

namespace engine {

/// A folder for temporary files that is removed with its content.
class TemporaryFolder {
 public:
  /// @throws MoorDynFault if it cannot be made
  TemporaryFolder();
  ~TemporaryFolder() { remove(); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  void remove();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Writes the text of an input file into a folder, beside links to what lies beside the file of the
/// scene. @return the copy @throws MoorDynFault if it cannot be written
std::filesystem::path write_copy(const std::filesystem::path& file, const std::string& text,
                                 const std::filesystem::path& folder);

/// The log that MoorDyn writes beside a copy.
std::filesystem::path log_of(const std::filesystem::path& copy);

/// The lines of MoorDyn's log.
struct Messages {
  std::vector<std::string> errors, warnings;
};

/// Reads on in a log. Messages lose the place in MoorDyn's source, and name the scene's file where
/// they name its copy.
Messages messages_in(std::istream& log, const std::filesystem::path& copy,
                     const std::filesystem::path& file);

}  // namespace engine

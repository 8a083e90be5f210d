#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/base/file_lock.h"
#include "app/base/reporter.h"
#include "hydro/mesh/mesh.h"

/// @file
/// Files of solutions in the user's cache folder.
///
/// A file begins with everything that its solution depends on (format, version of the method,
/// options, the whole mesh), which must equal the request bit for bit; a hash of it is the file's
/// name. The solution and a checksum follow. A file is written under another name, flushed to the
/// disk and renamed, so that several processes may use a folder and every file is complete.

namespace assembly {

/// The files of one kind of solution.
class SolutionFiles {
 public:
  /// @param folder   None: nothing is read or written.
  /// @param what     The solution in messages: `the added mass`.
  SolutionFiles(std::optional<std::filesystem::path> folder, std::string what)
      : folder_(std::move(folder)), what_(std::move(what)) {}

  /// The file of an identity; empty without a folder.
  /// @param kind   Extension of the file's name.
  std::filesystem::path file_of(const std::string& identity, const char* kind) const;

  /// The content of a file; none if it is missing or, with a warning, unusable.
  /// @param size   Expected size of the content [bytes]; none accepts any size.
  std::optional<std::string> read(const std::string& identity, const char* kind,
                                  std::optional<std::size_t> size, app::Reporter& reporter) const;

  /// Writes a file, or warns that it cannot be written.
  void write(const std::string& identity, const char* kind, const std::string& content,
             app::Reporter& reporter) const;

  const std::optional<std::filesystem::path>& folder() const { return folder_; }

 private:
  std::optional<std::filesystem::path> folder_;
  std::string what_;
};

/// Appends a mesh to an identity.
void append_mesh(std::string& bytes, const hydro::TriMesh& mesh);

/// True if there is such a file.
bool is_there(const std::filesystem::path& file);

/// Returns the solution that `find` finds, or else that of `solve`. If several processes need it at
/// once, one solves and the others wait.
/// @param file   File of the solution; empty without a folder.
/// @param what   The solution in messages: `added mass of hull`.
/// @param find   Returns an optional solution.
template <class Find, class Solve>
auto found_or_solved(const std::filesystem::path& file, const std::string& what,
                     app::Reporter& reporter, Find&& find, Solve&& solve) {
  const bool had_file = is_there(file);
  if (auto found = find()) return *found;
  // The process that holds the lock solves; the others wait.
  reporter.working_on(what + ": another process solves for it");
  const app::FileLock lock(file.empty() ? file : std::filesystem::path(file.string() + ".lock"));
  if (lock.waited() || is_there(file) != had_file)
    if (auto found = find()) {
      reporter.done("");
      return *found;
    }
  return solve();
}

/// Returns $PLIMSOLL_CACHE, else `plimsoll` in $XDG_CACHE_HOME or ~/.cache; none without a home
/// folder. An empty variable counts as unset, and so does an XDG_CACHE_HOME that is not absolute.
std::optional<std::filesystem::path> cache_folder();

}  // namespace assembly

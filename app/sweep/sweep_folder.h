#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/logs/output_folder.h"
#include "app/logs/run_files.h"

namespace app {

/// Definition of a sweep, as the user wrote it. A folder keeps the results of one sweep.
struct SweepIdentity {
  std::filesystem::path scene;
  std::vector<std::string> sets;
  std::vector<std::string> varied;
  std::optional<std::size_t> samples;
  std::uint64_t seed = 0;
};

/// Folder of a run, locked against other processes while the run is done.
class RunSlot {
 public:
  /// Makes the folder or empties it. @throws InputError if it cannot be made or is in use
  explicit RunSlot(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path messages_file() const { return path_ / kMessagesFile; }
  /// Returns the file descriptor of the messages, for writing.
  int messages() const { return messages_.descriptor(); }

 private:
  std::filesystem::path path_;
  LockedFile messages_;
};

/// Folder of a sweep: its definition `sweep.json`, its table `sweep.csv`, and `runs/0000`….
class SweepFolder {
 public:
  /// @throws InputError as OutputFolder does
  SweepFolder(const std::filesystem::path& path, OutputFolder::Use use);

  /// Removes the files of the sweep in this folder, if there is one. @throws InputError if it
  /// cannot be removed
  void clear() const;

  /// Returns true if the folder holds this sweep, in part or whole. @throws InputError if it holds
  /// another sweep, or if the scene or a file that it names has changed
  bool holds(const SweepIdentity& identity) const;

  /// Records that the folder holds this sweep. @param files   Files that the scenes name.
  /// @throws InputError if there are runs that belong to no sweep, unless another process may have
  ///     begun this sweep meanwhile
  void begin(const SweepIdentity& identity, const std::set<std::filesystem::path>& files) const;

  const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path table_file() const { return path() / "sweep.csv"; }
  std::filesystem::path script_file() const { return path() / "sweep.sbatch"; }
  std::filesystem::path run_folder(std::size_t run) const;
  std::filesystem::path outcome_file(std::size_t run) const;

 private:
  std::filesystem::path manifest_file() const { return path() / "sweep.json"; }

  OutputFolder folder_;
  bool alone_;
};

}  // namespace app

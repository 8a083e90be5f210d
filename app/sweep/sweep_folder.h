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

/// What a sweep was asked for, as it was written; a folder keeps the results of one.
struct SweepIdentity {
  std::filesystem::path scene;
  std::vector<std::string> sets;
  std::vector<std::string> varied;
  std::optional<std::size_t> samples;
  std::uint64_t seed = 0;
};

/// A run's folder while the run is done: others that want it meanwhile are refused.
class RunSlot {
 public:
  /// Makes the folder or empties it. @throws InputError if it cannot be made or is in use
  explicit RunSlot(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path messages_file() const { return path_ / kMessagesFile; }
  /// Of the messages, for writing.
  int messages() const { return messages_.descriptor(); }

 private:
  std::filesystem::path path_;
  LockedFile messages_;
};

/// The folder of a sweep: `sweep.json`, which says what it is of, `sweep.csv`, and `runs/0000`….
class SweepFolder {
 public:
  /// @throws InputError as OutputFolder does
  SweepFolder(const std::filesystem::path& path, OutputFolder::Use use);

  /// Removes what the sweep that is there has left. @throws InputError if it cannot be removed
  void clear() const;

  /// Whether it holds this sweep, done in part or whole. @throws InputError if it holds another, or
  /// the scene or a file that it names is no longer the same
  bool holds(const SweepIdentity& identity) const;

  /// Says that it holds this sweep from now on. @param files   Those that the scenes name.
  /// @throws InputError if there are runs of no sweep, which may be someone else's, and no other
  ///     process can have begun it meanwhile
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

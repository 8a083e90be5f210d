#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// @file
/// Faults of an input and their places. They are collected while it is read and thrown together.

namespace scene {

/// A place in a file, counted from 1.
struct Place {
  std::filesystem::path file;  ///< Empty: not known.
  int line = 0;                ///< From 1; 0: not known.
  int column = 0;              ///< From 1; 0: not known.
};

/// The place of the value of each key, by key path (`bodies[1].mesh.file`). The empty path stands
/// for the whole input.
using Places = std::map<std::string, Place>;

/// `Place::file` of a value that was given on the command line instead of in a file.
inline const char* const kOverridePlace = "--set";

/// A single fault of an input.
struct Fault {
  Place place;           ///< Where the value is.
  std::string key_path;  ///< `bodies[1].mass`; empty for a fault of the whole file.
  std::string message;   ///< The value that was found and what was expected.
};

/// Formats a fault as `FILE:LINE:COLUMN: KEY.PATH: message` without the parts that are unknown. A
/// fault of an override reads `--set KEY.PATH: message`. Control characters stand as escapes.
std::string to_string(const Fault& fault);

/// Reports every fault of an input; `what()` has one line per fault.
class InputError : public std::runtime_error {
 public:
  /// Makes an error of several faults.
  /// @param faults   At least one.
  explicit InputError(std::vector<Fault> faults);
  /// A single fault of a file as a whole.
  InputError(const std::filesystem::path& file, const std::string& message);
  /// All faults, in the order in which they are reported.
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// Returns the place of `key_path`, or else of the smallest enclosing block that `places` has
/// (`bodies[1].mass` → `bodies[1]` → `bodies` → the whole).
Place place_of(const Places& places, std::string key_path);

/// Collects faults in order to throw them together.
class Faults {
 public:
  /// Adds a fault that has its place.
  void add(Fault fault) { faults_.push_back(std::move(fault)); }
  /// Adds a fault of one key, at the place that place_of() gives.
  void add(const Places& places, const std::string& key_path, const std::string& message);
  /// True if no fault was added.
  bool empty() const { return faults_.empty(); }
  /// Throws the faults that were added.
  /// @throws InputError with all faults in the order of the file, those of overrides first. Nothing
  ///     is thrown if there is no fault.
  void throw_if_any() const;

 private:
  std::vector<Fault> faults_;
};

}  // namespace scene

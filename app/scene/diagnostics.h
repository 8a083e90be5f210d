#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// @file
/// What is wrong with an input, and where: collected while it is read, thrown all at once.

namespace scene {

/// A place in a file, counted from 1.
struct Place {
  std::filesystem::path file;
  int line = 0;
  int column = 0;
};

/// The place of the value of each key, by key path (`bodies[1].mesh.file`); the whole stands under
/// the empty path.
using Places = std::map<std::string, Place>;

/// `Place::file` of a value that was given on the command line instead of in a file.
inline const char* const kOverridePlace = "--set";

/// One thing that is wrong with an input file.
struct Fault {
  Place place;
  std::string key_path;  ///< `bodies[1].mass`; empty if the file as a whole is meant.
  std::string message;   ///< What was found and what would be right.
};

/// `FILE:LINE:COLUMN: KEY.PATH: message`; parts that are not known are left out. A fault of an
/// override reads `--set KEY.PATH: message`.
std::string to_string(const Fault& fault);

/// A wrong input, with every fault that was found. `what()` has one fault a line.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);
  /// A single fault of a file as a whole.
  InputError(const std::filesystem::path& file, const std::string& message);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// Where `key_path` stands, or else the smallest block around it that stands in `places`
/// (`bodies[1].mass` → `bodies[1]` → `bodies` → the whole).
Place place_of(const Places& places, std::string key_path);

/// Collects faults, to throw them all at once.
class Faults {
 public:
  void add(Fault fault) { faults_.push_back(std::move(fault)); }
  /// A fault of one key, at its place or that of the smallest block around it.
  void add(const Places& places, const std::string& key_path, const std::string& message);
  bool empty() const { return faults_.empty(); }
  /// @throws InputError with all faults in the order of the file, those of overrides first; does
  ///     nothing if there is none.
  void throw_if_any() const;

 private:
  std::vector<Fault> faults_;
};

}  // namespace scene

#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/scene.h"

namespace app {

/// One thing that is wrong with an input file.
struct Fault {
  Place place;
  std::string key_path;  ///< `bodies[1].mass`; empty if the file as a whole is meant.
  std::string message;   ///< What was found and what would be right.
};

/// `FILE:LINE:COLUMN: KEY.PATH: message`; parts that are not known are left out.
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

}  // namespace app

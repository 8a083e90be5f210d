#pragma once

#include <stdexcept>

namespace app {

/// Why a file cannot be written although it is open.
inline const char* const kGone = "it was removed or replaced during the run";

/// A result cannot be written, most often because the disk is full.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace app

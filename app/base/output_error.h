#pragma once

#include <stdexcept>

namespace app {

/// A result cannot be written, most often because the disk is full.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace app

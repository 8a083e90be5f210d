#pragma once

#include <string>

/// @file
/// Receives the progress of long computations.

namespace app {

/// Receives the progress of a long computation. Each function does nothing unless it is overridden,
/// so a plain Reporter is quiet.
class Reporter {
 public:
  virtual ~Reporter() = default;

  /// The computation begins with `what`, which lasts until the next call or until `done`.
  virtual void working_on(const std::string& what);
  /// The part that `working_on` named has ended.
  /// @param result   Result of that part; empty if it is not reported.
  virtual void done(const std::string& result);
  /// The input is right, but its author should know something about it.
  virtual void note(const std::string& message);
  /// Something failed that the computation can do without.
  virtual void warning(const std::string& message);
};

/// Returns a reporter that ignores everything.
Reporter& quiet();

}  // namespace app

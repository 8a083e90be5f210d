#pragma once

#include <string>

namespace app {

/// Is told how a long computation goes on. Each function does nothing unless it is overridden, so
/// that a Reporter itself is a quiet one.
class Reporter {
 public:
  virtual ~Reporter() = default;

  /// The computation begins with `what`, which lasts until the next call or until `done`.
  virtual void working_on(const std::string& what);
  /// The computation goes on to something that is not worth telling. @param result   What the last
  /// part came to; empty if nothing is to be said of it.
  virtual void done(const std::string& result);
  /// The input is right, but its author should know something about it.
  virtual void note(const std::string& message);
  /// Something failed that the computation can do without.
  virtual void warning(const std::string& message);
};

/// A reporter that tells nothing to nobody.
Reporter& quiet();

}  // namespace app

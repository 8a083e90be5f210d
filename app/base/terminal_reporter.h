#pragma once

#include <string>

#include "app/base/progress.h"
#include "app/base/reporter.h"

namespace app {

/// Reports to standard error: the current work on a progress line, notes and warnings on separate
/// lines.
class TerminalReporter : public Reporter {
 public:
  /// @param quiet   True if only warnings are shown.
  explicit TerminalReporter(bool quiet) : quiet_(quiet), line_(quiet) {}

  void working_on(const std::string& what) override;
  void done(const std::string& result) override;
  void note(const std::string& message) override;
  void warning(const std::string& message) override;

 private:
  bool quiet_;
  ProgressLine line_;
};

}  // namespace app

#pragma once

#include <string>

#include "app/base/progress.h"
#include "app/base/reporter.h"

namespace app {

/// Tells on standard error: what is being done on a line that keeps itself up to date, if that is a
/// terminal; notes and warnings on lines of their own.
class TerminalReporter : public Reporter {
 public:
  /// @param quiet   Warnings only.
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

#include "app/base/terminal_reporter.h"

#include "app/base/console.h"

namespace app {

void TerminalReporter::working_on(const std::string& what) { line_.show(what); }

void TerminalReporter::done(const std::string& result) {
  line_.clear();
  if (line_.enabled() && !result.empty()) say(result);
}

void TerminalReporter::note(const std::string& message) {
  if (!quiet_) say(message);
}

void TerminalReporter::warning(const std::string& message) { say("warning: " + message); }

}  // namespace app

#pragma once

#include <chrono>
#include <string>

namespace app {

/// One line on standard error that keeps itself up to date; nothing where that is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();

  /// Shows the line, at most ten times a second.
  void show(const std::string& text);

  /// Takes the line off the screen.
  void clear();

 private:
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace app

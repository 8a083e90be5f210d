#pragma once

#include <chrono>
#include <string>

namespace app {

/// One line on standard error that keeps itself up to date; nothing where that is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();

  /// True if there is a screen to show a line on and the last one has stood for a tenth of a
  /// second.
  bool due() const { return enabled_ && std::chrono::steady_clock::now() >= next_; }

  /// Shows the line.
  void show(const std::string& text);

  /// Takes the line off the screen.
  void clear();

 private:
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace app

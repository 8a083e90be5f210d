#pragma once

#include <chrono>
#include <string>

namespace app {

/// Formats a time as `42 s`, `12 min` or `3.5 h`.
std::string rough_time(double seconds);

/// `teapot_drop: 1.20 of 6 s   20 %  3.2 x real time  2 s left`
/// @param time       Simulated time so far [s], > 0.
/// @param duration   Duration of the scene [s].
/// @param wall       Wall time so far [s], > 0.
std::string progress_text(const std::string& name, double time, double duration, double wall);

/// A progress line on standard error, shown only if that is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();

  /// True if there is a terminal to show the line on.
  bool enabled() const { return enabled_; }

  /// True if the line is enabled and was last shown at least 0.1 s ago.
  bool due() const { return enabled_ && std::chrono::steady_clock::now() >= next_; }

  /// Shows the line, cut to the width of the terminal.
  void show(const std::string& text);

  /// Erases the line.
  void clear();

 private:
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace app

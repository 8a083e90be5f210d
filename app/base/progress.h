#pragma once

#include <chrono>
#include <string>

namespace app {

/// `teapot_drop: 1.20 of 6 s   20 %  3.2 x real time  2 s left`
/// @param time       Simulated so far [s], > 0.
/// @param duration   [s]
/// @param wall       That it took [s], > 0.
std::string progress_text(const std::string& name, double time, double duration, double wall);

/// One line on standard error that keeps itself up to date; nothing where that is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();

  /// True if there is a screen to show a line on.
  bool enabled() const { return enabled_; }

  /// True if there is a screen to show a line on and the last one has stood for a tenth of a
  /// second.
  bool due() const { return enabled_ && std::chrono::steady_clock::now() >= next_; }

  /// Shows the line, as much of it as the screen is wide.
  void show(const std::string& text);

  /// Takes the line off the screen.
  void clear();

 private:
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace app

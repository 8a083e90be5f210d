#pragma once

namespace app {

/// Time after a signal that what is under way may take to end by itself [s]. With what is left to
/// do then, a command ends within half a second.
inline constexpr double kStepPatience = 0.2;

/// While a guard lives, the first Ctrl-C, SIGTERM or SIGHUP is only recorded; a second one ends the
/// program.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  bool interrupted() const;
  /// True from kStepPatience after the signal on. Any thread may ask.
  bool overdue() const;
};

}  // namespace app

#pragma once

namespace app {

/// While a guard lives, the first Ctrl-C, SIGTERM or SIGHUP is only recorded; a second one ends the
/// program.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  bool interrupted() const;
};

}  // namespace app

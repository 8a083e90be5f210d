#pragma once

namespace app {

/// Number of steps that a simulation takes so that its time follows the clock.
///
/// On a machine that cannot keep up, a backlog of more than kLongestDebt is dropped, and the
/// simulation runs slower than asked for.
class PlaybackClock {
 public:
  static constexpr double kSlowest = 1.0 / 16, kFastest = 16;
  static constexpr double kLongestDebt = 0.25;  ///< Largest backlog, in clock time [s].

  /// @param step   Time step of the simulation [s].
  explicit PlaybackClock(double step) : step_(step) {}

  /// Returns the steps to take after an advance of the clock [s].
  long steps_due(double clock);

  /// Returns the clock time until the next step is due [s]; the value has no meaning while paused.
  double until_next() const;

  /// Records the steps taken in an interval of the clock [s], for `reached`.
  void note(double clock, long steps);
  /// Ratio of simulated to clock time over at least the last half second without pauses; 0 before.
  double reached() const { return reached_; }

  double speed() const { return speed_; }  ///< Ratio asked for.
  void faster();                           ///< Doubles the speed.
  void slower();                           ///< Halves the speed.

  bool paused() const { return paused_; }
  void pause_or_go_on();
  /// Asks for a single step; has an effect only while paused.
  void step_once();
  /// Drops the backlog when the simulation restarts.
  void restart();

 private:
  double step_;
  double speed_ = 1;
  bool paused_ = false;
  long single_ = 0;
  double owed_ = 0;  ///< Backlog of simulated time [s].
  double reached_ = 0;
  double noted_clock_ = 0, noted_time_ = 0;  ///< Since `reached_` was last found [s].
};

}  // namespace app

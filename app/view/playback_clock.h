#pragma once

namespace app {

/// How many steps a simulation takes so that its time follows the clock's.
///
/// A machine that cannot keep up gets no more steps for it: what it owes beyond kLongestDebt is
/// forgiven, and the simulation goes slower than asked for.
class PlaybackClock {
 public:
  static constexpr double kSlowest = 1.0 / 16, kFastest = 16;
  static constexpr double kLongestDebt = 0.25;  ///< Of the clock [s].

  /// @param step   Of the simulation [s].
  explicit PlaybackClock(double step) : step_(step) {}

  /// Steps to take now that the clock has gone on by so much [s].
  long steps_due(double clock);

  /// Clock time until the next step, if none is taken before [s]; none is due while paused.
  double until_next() const;

  /// Notes what was done in a time of the clock [s], for `reached`.
  void note(double clock, long steps);
  /// Simulated time over the clock's in the last half second or more, pauses left out; 0 before.
  double reached() const { return reached_; }

  double speed() const { return speed_; }  ///< Simulated time over the clock's, as asked for.
  void faster();                           ///< Twice.
  void slower();                           ///< Half.

  bool paused() const { return paused_; }
  void pause_or_go_on();
  /// Asks for a single step; only while paused.
  void step_once();
  /// Owes nothing any more: the simulation starts anew.
  void restart();

 private:
  double step_;
  double speed_ = 1;
  bool paused_ = false;
  long single_ = 0;
  double owed_ = 0;  ///< Simulated time [s].
  double reached_ = 0;
  double noted_clock_ = 0, noted_time_ = 0;  ///< Since the last look [s].
};

}  // namespace app

#pragma once

#include <cassert>
#include <cmath>
#include <utility>

namespace app {

/// Selects from ascending times the first at or after each of 0, every, 2·every, ….
class Schedule {
 public:
  /// @param every   Interval [s], > 0; 0 selects every time.
  explicit Schedule(double every) : every_(every) {}

  /// True if a scheduled time has been reached since the last call.
  bool due(double time) {
    if (every_ <= 0) return true;
    const double reached = std::floor(time / every_ + kSlack);
    if (reached < next_) return false;
    next_ = reached + 1;
    return true;
  }

 private:
  /// Fraction of an interval by which a time may fall short; it covers the rounding of step·count.
  static constexpr double kSlack = 1e-6;
  double every_;
  double next_ = 0;
};

/// True if a picture of a sequence at equal intervals may show the time: it lies before the end, as
/// the frames of a film do, or is 0.
inline bool is_frame_time(double time, double end) { return time == 0 || time < end * (1 - 1e-9); }

/// Selects from ascending times those that have a picture: the first at or after each of 0, every,
/// 2·every, … before the end, and the first at or after the end.
class FrameSchedule {
 public:
  /// @param every   Interval of pictures [s].
  /// @param end     End of the scene [s].
  FrameSchedule(double every, double end) : schedule_(every), end_(end) {}

  bool due(double time) {
    if (is_frame_time(time, end_)) return schedule_.due(time);
    return !std::exchange(ended_, true);
  }

 private:
  Schedule schedule_;
  double end_;
  bool ended_ = false;
};

/// Largest number of steps of a run; it allows more than a day at a step of a microsecond.
inline constexpr double kMostSteps = 1e11;

/// Returns the number of steps that cover a duration, at most kMostSteps; the last step may end
/// beyond it. The slack covers the rounding of a duration that is a whole number of steps.
inline long step_count(double duration, double step) {
  assert(duration / step <= kMostSteps);
  return std::lround(std::ceil(duration / step * (1 - 1e-12)));
}

}  // namespace app

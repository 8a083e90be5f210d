#pragma once

#include <cassert>
#include <cmath>

namespace app {

/// Times 0, every, 2·every, …: says of ascending times which are the first at or after one of them.
class Schedule {
 public:
  /// @param every   [s], > 0; 0 stands for every time that is asked about.
  explicit Schedule(double every) : every_(every) {}

  /// True if a time has been reached that was not reached when last asked.
  bool due(double time) {
    if (every_ <= 0) return true;
    const double reached = std::floor(time / every_ + kSlack);
    if (reached < next_) return false;
    next_ = reached + 1;
    return true;
  }

 private:
  /// Part of an interval by which a time may fall short: the rounding of step·count.
  static constexpr double kSlack = 1e-6;
  double every_;
  double next_ = 0;
};

/// Pictures are of times before the end, as frames of a film are; a scene without duration has one.
inline bool is_frame_time(double time, double end) { return time == 0 || time < end * (1 - 1e-9); }

/// Says of ascending times which have a picture.
class FrameSchedule {
 public:
  /// @param every   [s]; @param end   Of the scene [s].
  FrameSchedule(double every, double end) : schedule_(every), end_(end) {}

  bool due(double time) { return is_frame_time(time, end_) && schedule_.due(time); }

 private:
  Schedule schedule_;
  double end_;
};

/// Most steps of a run: a day and more at a microsecond each.
inline constexpr double kMostSteps = 1e11;

/// Steps that make up a duration; the last one may reach beyond it. The slack is the rounding of
/// a duration that is a whole number of steps. At most kMostSteps.
inline long step_count(double duration, double step) {
  assert(duration / step <= kMostSteps);
  return std::lround(std::ceil(duration / step * (1 - 1e-12)));
}

}  // namespace app

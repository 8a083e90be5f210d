#include "app/view/playback_clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

constexpr double kLook = 0.5;    // interval over which `reached` is found [s]
constexpr double kSlack = 1e-9;  // tolerance for the rounding of the backlog, in steps

}  // namespace

long PlaybackClock::steps_due(double clock) {
  if (paused_) return std::exchange(single_, 0);
  const double most = std::max(step_, kLongestDebt * speed_);
  owed_ = std::min(owed_ + speed_ * clock, most);
  const double steps = std::floor(owed_ / step_ + kSlack);
  owed_ -= steps * step_;
  return static_cast<long>(steps);
}

double PlaybackClock::until_next() const { return std::max(0.0, (step_ - owed_) / speed_); }

void PlaybackClock::note(double clock, long steps) {
  if (paused_) return;
  noted_clock_ += clock;
  noted_time_ += static_cast<double>(steps) * step_;
  if (noted_clock_ < kLook) return;
  reached_ = noted_time_ / noted_clock_;
  noted_clock_ = noted_time_ = 0;
}

void PlaybackClock::faster() { speed_ = std::min(2 * speed_, kFastest); }

void PlaybackClock::slower() { speed_ = std::max(speed_ / 2, kSlowest); }

void PlaybackClock::pause_or_go_on() {
  paused_ = !paused_;
  single_ = 0;
  owed_ = noted_clock_ = noted_time_ = 0;
}

void PlaybackClock::step_once() {
  if (paused_) ++single_;
}

void PlaybackClock::restart() {
  single_ = 0;
  owed_ = reached_ = noted_clock_ = noted_time_ = 0;
}

}  // namespace app

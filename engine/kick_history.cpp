#include "engine/kick_history.h"

#include <algorithm>
#include <cmath>

namespace engine {
namespace {

/// What is left of a pace after a piece that shows none. Half a period of an oscillation passes
/// between two greatest accelerations.
constexpr double kRemembered = 0.9;

}  // namespace

void KickHistory::add(const Vector6d& acceleration_B, double piece, double radius) {
  for (std::size_t i = 2; i > 0; --i) {
    age_[i] = age_[i - 1] + piece;
    size_[i] = size_[i - 1];
  }
  age_[0] = piece / 2;
  size_[0] = size(acceleration_B, radius);
  if (count_ > 0) {
    const Vector6d slope = 1 / (age_[1] - age_[0]) * (acceleration_B - acceleration_);
    bend_ = 1 / (age_[2] - age_[0]) * (slope - slope_);
    slope_ = slope;
  }
  acceleration_ = acceleration_B;
  count_ = std::min(count_ + 1, kTrend);
  largest_ = *std::max_element(size_.begin(), size_.end());
  pace_ *= kRemembered;
  if (count_ < kTrend) return;
  const double bend = size(bend_, radius);
  // What the line through the earlier two misses the last by.
  resolved_ = bend * (age_[1] - age_[0]) * (age_[2] - age_[0]) <= kResolved * largest_;
  if (resolved_ && largest_ > 0) pace_ = std::max(pace_, std::sqrt(2 * bend / largest_));
}

KickHistory::Trend KickHistory::trend() const {
  // Newton's form, with the time from the end of the last piece.
  return {acceleration_ + age_[0] * slope_ + age_[0] * age_[1] * bend_,
          slope_ + (age_[0] + age_[1]) * bend_};
}

}  // namespace engine

#include "engine/acceleration_history.h"

#include <algorithm>
#include <cmath>

namespace engine {
void AccelerationHistory::add(const Vector6d& acceleration_B, double piece, double radius) {
  for (std::size_t i = 2; i > 0; --i) {
    age_[i] = age_[i - 1] + piece;
    size_[i] = size_[i - 1];
  }
  age_[0] = piece / 2;
  size_[0] = scaled_norm(acceleration_B, radius);
  if (count_ > 0) {
    const Vector6d slope = 1 / (age_[1] - age_[0]) * (acceleration_B - acceleration_);
    second_derivative_ = 1 / (age_[2] - age_[0]) * (slope - slope_);
    slope_ = slope;
  }
  acceleration_ = acceleration_B;
  count_ = std::min(count_ + 1, kTrend);
  largest_ = *std::max_element(size_.begin(), size_.end());
  dominant_frequency_ *= kFrequencyKept;
  if (count_ < kTrend) return;
  const double bend = scaled_norm(second_derivative_, radius);
  // What the line through the earlier two misses the last by.
  resolved_ = bend * (age_[1] - age_[0]) * (age_[2] - age_[0]) <= kResolved * largest_;
  if (resolved_ && largest_ > 0)
    dominant_frequency_ = std::max(dominant_frequency_, std::sqrt(2 * bend / largest_));
}

AccelerationHistory::Trend AccelerationHistory::trend() const {
  // Newton's form, with the time from the end of the last piece.
  return {acceleration_ + age_[0] * slope_ + age_[0] * age_[1] * second_derivative_,
          slope_ + (age_[0] + age_[1]) * second_derivative_};
}

}  // namespace engine

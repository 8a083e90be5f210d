#include "engine/motion/acceleration_history.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/base/constants.h"

namespace engine {

void AccelerationHistory::add(const Vector6d& acceleration_B, double h, double radius) {
  age_ = {h / 2, age_[0] + h, age_[1] + h};
  size_ = {scaled_norm(acceleration_B, radius), size_[0], size_[1]};
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
  const double curvature = scaled_norm(second_derivative_, radius);
  // The line through the earlier two misses the last one by this curvature.
  resolved_ = curvature * (age_[1] - age_[0]) * (age_[2] - age_[0]) <= kResolved * largest_;
  if (resolved_ && largest_ > 0)
    dominant_frequency_ = std::max(dominant_frequency_, std::sqrt(2 * curvature / largest_));
}

void AccelerationHistory::shift(const Vector6d& jump_B, double radius) {
  assert(!empty());
  acceleration_ += jump_B;
  size_[0] = scaled_norm(acceleration_, radius);
  largest_ = *std::max_element(size_.begin(), size_.end());
}

AccelerationHistory::Trend AccelerationHistory::trend() const {
  assert(count_ >= 3);
  // Newton's form of the parabola, whose time counts from the end of the last substep.
  return {acceleration_ + age_[0] * slope_ + age_[0] * age_[1] * second_derivative_,
          slope_ + (age_[0] + age_[1]) * second_derivative_};
}

}  // namespace engine

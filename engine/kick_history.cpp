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
    acceleration_[i] = acceleration_[i - 1];
    age_[i] = age_[i - 1] + piece;
  }
  acceleration_[0] = acceleration_B;
  age_[0] = piece / 2;
  count_ = std::min(count_ + 1, kTrend);
  pace_ *= kRemembered;
  largest_ = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i)
    largest_ = std::max(largest_, size(acceleration_[i], radius));
  if (count_ < kTrend) return;
  const double bend = size(curvature(), radius);
  // What the line through the earlier two misses the last by.
  resolved_ = bend * (age_[1] - age_[0]) * (age_[2] - age_[0]) <= kResolved * largest_;
  if (resolved_ && largest_ > 0) pace_ = std::max(pace_, std::sqrt(2 * bend / largest_));
}

Vector6d KickHistory::expected(double ahead) const {
  if (count_ == 0) return Vector6d::Zero();
  if (count_ == 1) return acceleration_[0] + (age_[0] + ahead) * slope_;
  const Vector6d slope = (acceleration_[0] - acceleration_[1]) / (age_[1] - age_[0]);
  return acceleration_[0] + (age_[0] + ahead) * slope;
}

Vector6d KickHistory::curvature() const {
  const Vector6d late = (acceleration_[0] - acceleration_[1]) / (age_[1] - age_[0]);
  const Vector6d early = (acceleration_[1] - acceleration_[2]) / (age_[2] - age_[1]);
  return (late - early) / (age_[2] - age_[0]);
}

KickHistory::Trend KickHistory::trend() const {
  // Newton's form, with the time from the end of the last piece.
  const Vector6d slope = (acceleration_[0] - acceleration_[1]) / (age_[1] - age_[0]);
  const Vector6d bend = curvature();
  return {acceleration_[0] + age_[0] * slope + age_[0] * age_[1] * bend,
          slope + (age_[0] + age_[1]) * bend};
}

}  // namespace engine

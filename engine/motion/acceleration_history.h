#pragma once

#include <array>

#include "engine/base/spatial_vector.h"

/// @file
/// Extrapolates a body's acceleration from its last three substeps.

namespace engine {

/// Accelerations a = Δu/h of a body, in body axes, each taken halfway through its substep.
class AccelerationHistory {
 public:
  static constexpr int kTrend = 3;  ///< Accelerations that make a trend.

  bool empty() const { return count_ == 0; }
  void clear() { *this = {}; }

  /// Adds the acceleration of a substep of length h [s].
  /// @param radius   Radius of the body [m]: norms multiply angular accelerations with it.
  void add(const Vector6d& acceleration_B, double h, double radius);

  /// Sets the rate of the first acceleration, which is zero otherwise.
  void set_slope(const Vector6d& slope_B) {
    if (count_ == 1) slope_ = slope_B;
  }

  /// Moves the known accelerations, of which there are some, by that of a load which begins now.
  void shift(const Vector6d& jump_B, double radius);

  /// Acceleration `ahead` [s] after the last substep, on the line through the last two, or through
  /// the only one with the slope that was set; zero without any.
  Vector6d expected(double ahead) const { return acceleration_ + (age_[0] + ahead) * slope_; }

  /// Norm of the largest acceleration of those known [m/s^2].
  double largest() const { return largest_; }

  /// True if three are known and the earlier two predict the last to kResolved of the largest.
  bool resolved() const { return resolved_; }

  /// Largest recent frequency √(|a''|/|a|) of a resolved motion [rad/s]; 0 if none is known.
  double dominant_frequency() const { return dominant_frequency_; }

  /// Value and rate, at the end of the last substep, of the parabola through the last three.
  struct Trend {
    Vector6d value;
    Vector6d slope;
  };
  /// Three accelerations must be known.
  Trend trend() const;

  /// Calls f with all members, for an archive that writes or reads them.
  template <class F>
  void visit_parts(const F& f) {
    f(acceleration_, slope_, second_derivative_, age_, size_, count_, largest_, resolved_,
      dominant_frequency_);
  }

 private:
  Vector6d acceleration_ = Vector6d::Zero();       ///< The last one.
  Vector6d slope_ = Vector6d::Zero();              ///< Rate by the last two, or as it was set.
  Vector6d second_derivative_ = Vector6d::Zero();  ///< a''/2 by the last three.
  std::array<double, 3> age_ = {};                 ///< Times since them, the last one first [s].
  std::array<double, 3> size_ = {};                ///< Their norms, in the same order.
  int count_ = 0;
  double largest_ = 0;
  bool resolved_ = false;
  double dominant_frequency_ = 0;
};

}  // namespace engine

#pragma once

#include <array>

#include "engine/constants.h"
#include "engine/spatial_vector.h"

/// @file
/// Extrapolates a body's acceleration from its last three substeps.

namespace engine {

/// The accelerations a = Δu/h of the last accelerations, in body axes, each taken halfway through
/// its piece.
class AccelerationHistory {
 public:
  static constexpr int kTrend = 3;  ///< Kicks that show a trend.

  bool empty() const { return count_ == 0; }
  void clear() { *this = {}; }

  /// After a piece of this length [s].
  /// @param radius   Of the body: angular accelerations count with it [m].
  void add(const Vector6d& acceleration_B, double piece, double radius);

  /// With the first one: how it changes a second, as far as that is known.
  void set_slope(const Vector6d& slope_B) {
    if (count_ == 1) slope_ = slope_B;
  }

  /// On the line through the last two, `ahead` [s] after the end of the last piece. With one, by
  /// the slope that was set; zero without any.
  Vector6d expected(double ahead) const { return acceleration_ + (age_[0] + ahead) * slope_; }

  /// The largest of those known, an angular one counting with the radius [m/s^2].
  double largest() const { return largest_; }

  /// True if there are three and the last was foretold to kResolved of the largest.
  bool resolved() const { return resolved_; }

  /// The frequency of a motion that is resolved, √(|a''|/|a|) where that was greatest of late; 0 if
  /// none is known [rad/s].
  double dominant_frequency() const { return dominant_frequency_; }

  /// Of the parabola through the last three at the end of the last piece.
  struct Trend {
    Vector6d value;
    Vector6d slope;  ///< A second.
  };
  /// Only if there are three.
  Trend trend() const;

  /// Calls f with every part, for one that saves or reads the history.
  template <class F>
  void visit_parts(const F& f) {
    f(acceleration_, slope_, second_derivative_, age_, size_, count_, largest_, resolved_,
      dominant_frequency_);
  }

 private:
  Vector6d acceleration_ = Vector6d::Zero();       ///< Of the last update.
  Vector6d slope_ = Vector6d::Zero();              ///< Through the last two, or as it was set.
  Vector6d second_derivative_ = Vector6d::Zero();  ///< a''/2 by the last three.
  std::array<double, 3> age_ = {};                 ///< The last one first [s].
  std::array<double, 3> size_ = {};                ///< In the same order.
  int count_ = 0;
  double largest_ = 0;
  bool resolved_ = false;
  double dominant_frequency_ = 0;
};

}  // namespace engine

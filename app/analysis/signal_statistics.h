#pragma once

#include <optional>
#include <vector>

/// @file
/// Statistics of a signal over time.

namespace app {

/// A straight line through a signal: `mean + slope (t − middle)`.
struct LineFit {
  double middle = 0;  ///< Mean of the times [s].
  double mean = 0;    ///< Mean of the signal.
  double slope = 0;   ///< Per second.

  double at(double time) const { return mean + slope * (time - middle); }
};

/// Fits a line by least squares. @param times   At least one.
LineFit fitted_line(const std::vector<double>& times, const std::vector<double>& values);

/// Returns the values minus the line through them.
std::vector<double> without_trend(const std::vector<double>& times,
                                  const std::vector<double>& values);

/// The swings of a signal between two upward passages through its mean line.
struct Crossings {
  int count = 0;           ///< Number of cycles.
  double period = 0;       ///< Mean T_z [s].
  double significant = 0;  ///< Mean of the highest third of the heights from trough to crest.
  double largest = 0;      ///< The largest height.
};

struct SignalStatistics {
  double mean = 0;
  double deviation = 0;  ///< Standard deviation about the mean.
  double drift = 0;      ///< Slope of the line through the signal, per second.
  double min = 0, max = 0;
  double at_min = 0, at_max = 0;       ///< Their times [s].
  std::optional<Crossings> crossings;  ///< None unless there are two passages.
};

/// @param times   Ascending, at least one.
SignalStatistics statistics_of(const std::vector<double>& times, const std::vector<double>& values);

}  // namespace app

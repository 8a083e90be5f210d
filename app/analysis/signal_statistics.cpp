#include "app/analysis/signal_statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace app {
namespace {

double mean_of(const std::vector<double>& values) {
  return std::reduce(values.begin(), values.end()) / static_cast<double>(values.size());
}

/// Finds the cycles of a signal without a trend.
std::optional<Crossings> crossings_of(const std::vector<double>& times,
                                      const std::vector<double>& values) {
  std::vector<double> passages, heights;
  double low = 0, high = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i - 1] < 0 && values[i] >= 0) {
      const double s = values[i - 1] / (values[i - 1] - values[i]);
      if (!passages.empty()) heights.push_back(high - low);
      passages.push_back(times[i - 1] + s * (times[i] - times[i - 1]));
      low = high = 0;
    }
    low = std::min(low, values[i]);
    high = std::max(high, values[i]);
  }
  if (heights.empty()) return std::nullopt;
  std::ranges::sort(heights, std::greater());
  const std::size_t third = std::max<std::size_t>(1, (heights.size() + 1) / 3);
  const auto end = heights.begin() + static_cast<std::ptrdiff_t>(third);
  return Crossings{
      .count = static_cast<int>(heights.size()),
      .period = (passages.back() - passages.front()) / static_cast<double>(heights.size()),
      .significant = std::reduce(heights.begin(), end) / static_cast<double>(third),
      .largest = heights.front()};
}

}  // namespace

LineFit fitted_line(const std::vector<double>& times, const std::vector<double>& values) {
  LineFit line{.middle = mean_of(times), .mean = mean_of(values)};
  double product = 0, square = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    product += (times[i] - line.middle) * (values[i] - line.mean);
    square += (times[i] - line.middle) * (times[i] - line.middle);
  }
  if (square > 0) line.slope = product / square;
  return line;
}

std::vector<double> without_trend(const std::vector<double>& times,
                                  const std::vector<double>& values) {
  const LineFit line = fitted_line(times, values);
  std::vector<double> rest;
  for (std::size_t i = 0; i < times.size(); ++i) rest.push_back(values[i] - line.at(times[i]));
  return rest;
}

SignalStatistics statistics_of(const std::vector<double>& times,
                               const std::vector<double>& values) {
  const LineFit line = fitted_line(times, values);
  SignalStatistics s;
  s.mean = line.mean;
  s.drift = line.slope;
  for (const double value : values) s.deviation += (value - s.mean) * (value - s.mean);
  s.deviation = std::sqrt(s.deviation / static_cast<double>(values.size()));
  const auto [least, most] = std::ranges::minmax_element(values);
  s.min = *least;
  s.max = *most;
  s.at_min = times[static_cast<std::size_t>(least - values.begin())];
  s.at_max = times[static_cast<std::size_t>(most - values.begin())];
  s.crossings = crossings_of(times, without_trend(times, values));
  return s;
}

}  // namespace app

#include "app/analysis/decay_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr double kSmallest = 0.01;  ///< Part of the largest swing below which one is noise [-].
constexpr double kGrowth = 1.02;    ///< Largest ratio of a swing of a decay to the one before it.
constexpr double kAlike = 1.5;      ///< Largest ratio of two half periods of a decay.
constexpr std::size_t kLeastExtremes = 7;  ///< Extremes of three cycles.

struct Extreme {
  double time = 0;
  double value = 0;
};

/// Returns the top of the parabola through a row and its neighbours; the row itself at the ends.
Extreme refined(const std::vector<double>& t, const std::vector<double>& x, std::size_t i) {
  if (i == 0 || i + 1 == x.size()) return {t[i], x[i]};
  const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
  const double left = (x[i] - x[i - 1]) / before, right = (x[i + 1] - x[i]) / after;
  const double curvature = (right - left) / (before + after);
  if (curvature == 0) return {t[i], x[i]};
  const double slope = (left * after + right * before) / (before + after);
  const double shift = std::clamp(-slope / (2 * curvature), -before, after);
  return {t[i] + shift, x[i] + (slope + curvature * shift) * shift};
}

/// True if the signal starts at rest: it leaves its first value with the square of the time.
bool starts_at_rest(const std::vector<double>& x) {
  constexpr double kSquare = 3;  // a parabola gives 4, a line 2
  return x.size() > 2 && std::abs(x[2] - x[0]) > kSquare * std::abs(x[1] - x[0]);
}

/// Returns the extremes between which the signal moves by more than a threshold.
std::vector<Extreme> extremes_of(const std::vector<double>& t, const std::vector<double>& x) {
  const auto [least, most] = std::ranges::minmax_element(x);
  const double threshold = kSmallest * (*most - *least);
  std::vector<std::size_t> rows;
  std::size_t low = 0, high = 0;
  int direction = 0;  // of the signal: 1 rises, -1 falls, 0 is not known yet
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] > x[high]) high = i;
    if (x[i] < x[low]) low = i;
    if (direction != -1 && x[high] - x[i] > threshold) {
      rows.push_back(high);
      direction = -1;
      low = i;
    } else if (direction != 1 && x[i] - x[low] > threshold) {
      rows.push_back(low);
      direction = 1;
      high = i;
    }
    if (direction == -1) high = i;
    if (direction == 1) low = i;
  }
  std::vector<Extreme> extremes;
  for (const std::size_t row : rows)
    if (row > 0 || starts_at_rest(x)) extremes.push_back(refined(t, x, row));
  return extremes;
}

/// Keeps the extremes up to which the signal decays with about one period.
void keep_decay(std::vector<Extreme>& extremes) {
  std::size_t kept = std::min<std::size_t>(2, extremes.size());
  for (; kept < extremes.size(); ++kept) {
    const Extreme &p = extremes[kept - 2], &q = extremes[kept - 1], &r = extremes[kept];
    const double ratio = (r.time - q.time) / (q.time - p.time);
    if (std::abs(r.value - q.value) > kGrowth * std::abs(q.value - p.value)) break;
    if (ratio > kAlike || ratio < 1 / kAlike) break;
  }
  extremes.resize(kept);
}

std::vector<DecayCycle> cycles_of(const std::vector<Extreme>& e) {
  std::vector<DecayCycle> cycles;
  for (std::size_t i = 0; i + 3 < e.size(); ++i) {
    const auto amplitude = [&](std::size_t k) { return std::abs(e[k + 1].value - e[k].value) / 2; };
    const double first = amplitude(i), last = amplitude(i + 2);
    cycles.push_back({.start = e[i].time,
                      .period = e[i + 2].time - e[i].time,
                      .amplitude = amplitude(i + 1),
                      .decrement = std::log(first / last)});
  }
  return cycles;
}

/// Fits the decrement over the amplitude by least squares, weighted by the amplitude: the smaller
/// it is, the larger the share of the noise.
void fit_damping(DecayFit& fit) {
  double w = 0, wa = 0, wd = 0, waa = 0, wad = 0;
  for (const DecayCycle& c : fit.cycles) {
    const double weight = c.amplitude;
    w += weight;
    wa += weight * c.amplitude;
    wd += weight * c.decrement;
    waa += weight * c.amplitude * c.amplitude;
    wad += weight * c.amplitude * c.decrement;
  }
  const double determinant = w * waa - wa * wa;
  const double slope = determinant > 1e-9 * w * waa ? (w * wad - wa * wd) / determinant : 0;
  fit.decrement = (wd - slope * wa) / w;
  fit.quadratic = 3 * slope / 8;
  fit.damping_ratio = fit.decrement / std::hypot(fit.decrement, 2 * std::numbers::pi);
  fit.linear = 2 * fit.decrement / fit.period;
}

}  // namespace

std::optional<DecayFit> fitted_decay(const std::vector<double>& times,
                                     const std::vector<double>& values) {
  if (values.size() < kLeastExtremes) return std::nullopt;
  std::vector<Extreme> e = extremes_of(times, values);
  const std::size_t all = e.size();
  keep_decay(e);
  const bool decays = e.size() >= kLeastExtremes && 2 * e.size() > all &&
                      std::abs(e[e.size() - 1].value - e[e.size() - 2].value) <
                          std::abs(e[1].value - e[0].value) * 0.95;
  if (!decays) return std::nullopt;
  DecayFit fit{.cycles = cycles_of(e)};
  for (const DecayCycle& c : fit.cycles) fit.period += c.period;
  fit.period /= static_cast<double>(fit.cycles.size());
  const std::size_t n = e.size();
  fit.equilibrium = (e[n - 3].value + 2 * e[n - 2].value + e[n - 1].value) / 4;
  fit_damping(fit);
  return fit;
}

}  // namespace app

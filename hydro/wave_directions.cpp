#include "hydro/wave_directions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hydro {
namespace {

constexpr int kDirectionSteps = 3600;

/// Angle, −π … π, below which the fraction `part` of cos^2s(θ/2) lies.
double spread_angle(const std::vector<double>& cumulative, double part) {
  const double target = part * cumulative.back();
  const auto above = std::lower_bound(cumulative.begin(), cumulative.end(), target);
  const auto i = std::max<std::ptrdiff_t>(above - cumulative.begin(), 1);
  const double fraction = (target - cumulative[i - 1]) / (cumulative[i] - cumulative[i - 1]);
  return -M_PI + 2 * M_PI * (static_cast<double>(i - 1) + fraction) / kDirectionSteps;
}

std::vector<double> cumulative_spread(double s) {
  std::vector<double> cumulative(kDirectionSteps + 1, 0.0);
  for (int i = 0; i < kDirectionSteps; ++i) {
    const double theta = -M_PI + 2 * M_PI * (i + 0.5) / kDirectionSteps;
    cumulative[i + 1] = cumulative[i] + std::pow(std::cos(theta / 2), 2 * s);
  }
  return cumulative;
}

}  // namespace

std::vector<double> spread_directions(double spreading, int count, UniformNumbers& uniform) {
  std::vector<double> angles(count, 0.0);
  if (spreading <= 0) return angles;
  const std::vector<double> cumulative = cumulative_spread(spreading);
  for (int i = 0; i < count; ++i) angles[i] = spread_angle(cumulative, (i + uniform()) / count);
  for (int i = count - 1; i > 0; --i)
    std::swap(angles[i], angles[static_cast<int>(uniform() * (i + 1))]);
  return angles;
}

}  // namespace hydro

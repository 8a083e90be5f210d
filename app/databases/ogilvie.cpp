#include "app/databases/ogilvie.h"

#include <algorithm>
#include <cmath>

namespace databases {
namespace {

using Eigen::Index;
using hydro::Matrix6d;

/// Parts of an interval between two frequencies; odd, so that its middle is that of a part.
constexpr int kParts = 9;
/// Part of the highest frequency below which the relation is evaluated: B above it counts little.
constexpr double kUsed = 0.7;
/// The power laws end at this multiple of the highest frequency, by these factors.
constexpr double kTailEnd = 50, kTailStep = 1.1;

/// A matrix over the frequency, as straight lines between its points.
struct Curve {
  std::vector<double> at;
  std::vector<Matrix6d> values;
  void add(double frequency, const Matrix6d& value) {
    at.push_back(frequency);
    values.push_back(value);
  }
};

/// Slopes of the parabolas through three neighbours.
std::vector<Matrix6d> slopes_of(const std::vector<double>& x, const std::vector<Matrix6d>& y) {
  const std::size_t n = x.size();
  std::vector<Matrix6d> slopes(n);
  const auto chord = [&](std::size_t i) -> Matrix6d {
    return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
    slopes[i] = (right * chord(i - 1) + left * chord(i)) / (left + right);
  }
  slopes[0] = 2 * chord(0) - slopes[1];
  slopes[n - 1] = 2 * chord(n - 2) - slopes[n - 2];
  return slopes;
}

/// The cubic through two points with their slopes, at a part t of the way.
Matrix6d cubic(const Matrix6d& a, const Matrix6d& b, const Matrix6d& slope_a,
               const Matrix6d& slope_b, double h, double t) {
  const double s = 1 - t;
  return s * s * (1 + 2 * t) * a + t * t * (1 + 2 * s) * b +
         h * s * t * (s * slope_a - t * slope_b);
}

/// Exponents p of a decay as ν^−p, by the last two frequencies, for each entry.
Matrix6d tail_exponents(const std::vector<double>& x, const std::vector<Matrix6d>& B) {
  const std::size_t n = x.size();
  hydro::Vector6d p = hydro::Vector6d::Ones();
  for (Index i = 0; i < 6; ++i) {
    const double before = B[n - 2](i, i), last = B[n - 1](i, i);
    if (before > 0 && last > 0)
      p[i] = std::clamp(std::log(before / last) / std::log(x[n - 1] / x[n - 2]), 1.0, 8.0);
  }
  return 0.5 * (p.replicate<1, 6>() + p.transpose().replicate<6, 1>());
}

Curve damping_curve(const std::vector<double>& x, const std::vector<Matrix6d>& B) {
  const std::vector<Matrix6d> slopes = slopes_of(x, B);
  Curve curve;
  curve.add(0, Matrix6d::Zero());
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    for (int part = 0; part < kParts; ++part) {
      const double t = static_cast<double>(part) / kParts, h = x[i + 1] - x[i];
      curve.add(x[i] + t * h, cubic(B[i], B[i + 1], slopes[i], slopes[i + 1], h, t));
    }
  const Matrix6d p = tail_exponents(x, B);
  for (double factor = 1; factor < kTailEnd; factor *= kTailStep)
    curve.add(factor * x.back(),
              B.back().cwiseProduct((-std::log(factor) * p).array().exp().matrix()));
  return curve;
}

/// ⨍ B(ν)/(ν² − ω²) dν over straight lines, for ω at none of their ends.
Matrix6d principal_value(const Curve& B, double omega) {
  Matrix6d sum = Matrix6d::Zero();
  for (std::size_t i = 0; i + 1 < B.at.size(); ++i) {
    const double a = B.at[i], b = B.at[i + 1];
    const Matrix6d slope = (B.values[i + 1] - B.values[i]) / (b - a);
    const Matrix6d offset = B.values[i] - a * slope;
    const double minus = std::log(std::abs((b - omega) / (a - omega)));
    const double plus = std::log((b + omega) / (a + omega));
    sum += offset * (minus - plus) / (2 * omega) + slope * (minus + plus) / 2;
  }
  return sum;
}

}  // namespace

std::optional<InfiniteAddedMass> infinite_added_mass(const std::vector<double>& frequencies,
                                                     const std::vector<Matrix6d>& added_mass,
                                                     const std::vector<Matrix6d>& damping) {
  if (frequencies.size() < 6) return std::nullopt;
  const Curve B = damping_curve(frequencies, damping);
  const std::vector<Matrix6d> slopes = slopes_of(frequencies, added_mass);
  std::vector<Matrix6d> found;
  for (std::size_t i = 0; i + 1 < frequencies.size(); ++i) {
    const double h = frequencies[i + 1] - frequencies[i], omega = frequencies[i] + h / 2;
    if (omega > kUsed * frequencies.back()) break;
    const Matrix6d A = cubic(added_mass[i], added_mass[i + 1], slopes[i], slopes[i + 1], h, 0.5);
    found.emplace_back(A - 2 / M_PI * principal_value(B, omega));
  }
  if (found.empty()) return std::nullopt;
  InfiniteAddedMass result;
  const auto count = static_cast<double>(found.size());
  for (const Matrix6d& each : found) result.matrix += each / count;
  for (const Matrix6d& each : found) result.spread += (each - result.matrix).cwiseAbs2() / count;
  result.spread = result.spread.cwiseSqrt().eval();
  return result;
}

}  // namespace databases

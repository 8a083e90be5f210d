#include "hydro/radiation/green_function.h"

#include <math.h>  // j0 to y1, which <cmath> need not have

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "hydro/radiation/chebyshev_table.h"
#include "hydro/radiation/gauss_rule.h"

namespace hydro {
namespace {

using std::numbers::pi;

using Interval = ChebyshevInterval;
using Table = ChebyshevTable<18>;

/// The table of a function on a rectangle.
Table tabulated(Interval first, Interval second, const std::function<double(double, double)>& f) {
  Table::Samples samples;
  for (int i = 0; i < samples.rows(); ++i)
    for (int j = 0; j < samples.cols(); ++j)
      samples(i, j) = f(Table::place(first, i), Table::place(second, j));
  return {first, second, samples};
}

/// Distance in ρ up to which (2) is told with its logarithm taken out.
constexpr double kNear = 10;
/// Y/ρ above which points are near the axis through the source, and ρ from which on the series (4)
/// tells them.
constexpr double kAxis = 0.8, kSeries = 24;

/// F + 2 J₀ e^{−Y} ln((ρ + Y)/2), for ρ > 0.
double smooth_part(double rho, double mu) {
  const double y = rho * mu;
  // On the axis the two logarithms cancel: the limit is taken from beside it.
  const double x = std::max(rho * std::sqrt(std::max(0.0, 1 - mu * mu)), 1e-7 * rho);
  const double decay = std::exp(-y);
  return -2 * pi * decay * ::y0(x) - 2 * wave_green_integral(x, y) +
         2 * ::j0(x) * decay * std::log((rho + y) / 2);
}

/// (2)'s integral at the distance 10/ρ.
double far_integral(double inverse, double mu) {
  const double rho = kNear / inverse;
  return wave_green_integral(rho * std::sqrt(1 - mu * mu), rho * mu);
}

struct Tables {
  std::array<Interval, 6> rings = {
      {{1e-3, 1}, {1, 3}, {3, 6}, {6, kNear}, {kNear, 16}, {16, kSeries}}};
  std::array<Table, 6> near = {
      tabulated(rings[0], {0, 1}, smooth_part),     tabulated(rings[1], {0, 1}, smooth_part),
      tabulated(rings[2], {0, 1}, smooth_part),     tabulated(rings[3], {0, 1}, smooth_part),
      tabulated(rings[4], {kAxis, 1}, smooth_part), tabulated(rings[5], {kAxis, 1}, smooth_part)};
  Interval inverse = {1e-6, 1};
  Table far = tabulated(inverse, {0, kAxis}, far_integral);
};

const Tables& tables() {
  static const Tables made;
  return made;
}

/// Two parts of F and their slopes by X.
struct Real {
  double value, by_x;
};

/// F by its analytic part, with ρ_X = X/ρ and μ_X = −μX/ρ².
Real with_logarithm(const Table& table, double x, double y, double rho) {
  const double mu = y / rho;
  const Table::Sample s = table.at(rho, mu);
  const double decay = std::exp(-y), logarithm = std::log((rho + y) / 2);
  const double j = ::j0(x);
  return {s.value - 2 * decay * j * logarithm,
          s.by_first * x / rho - s.by_second * mu * x / (rho * rho) +
              2 * decay * (::j1(x) * logarithm - j * x / (rho * (rho + y)))};
}

Real far_away(const Tables& t, double x, double y, double rho) {
  const double mu = y / rho, inverse = kNear / rho;
  const Table::Sample s = t.far.at(inverse, mu);
  const double decay = 2 * pi * std::exp(-y);
  const double slope = -s.by_first * inverse * x / (rho * rho) - s.by_second * mu * x / (rho * rho);
  return {-decay * ::y0(x) - 2 * s.value, decay * ::y1(x) - 2 * slope};
}

/// F = −2 Σ n! P_n(μ)/ρ^{n+1}, whose slope by X is 2X Σ n! P'_{n+1}(μ)/ρ^{n+3}.             (4)
Real series(double x, double y, double rho) {
  constexpr int kTerms = 16;
  const double mu = y / rho;
  double legendre = 1, next = mu;    // P_n and P_{n+1}
  double slope = 0, next_slope = 1;  // their slopes
  double power = 1 / rho, value = 0, by_x = 0;
  for (int n = 0; n < kTerms; ++n) {
    value += power * legendre;
    by_x += power * next_slope;
    const double after = ((2 * n + 3) * mu * next - (n + 1) * legendre) / (n + 2);
    const double after_slope = slope + (2 * n + 3) * next;
    legendre = next;
    next = after;
    slope = next_slope;
    next_slope = after_slope;
    power *= (n + 1) / rho;
  }
  return {-2 * value, 2 * x / (rho * rho) * by_x};
}

Real real_part(double x, double y) {
  const Tables& t = tables();
  const double rho = std::max(std::hypot(x, y), t.rings[0].low);
  if (rho > kNear && y < kAxis * rho) return far_away(t, x, y, rho);
  if (rho > kSeries) return series(x, y, rho);
  std::size_t ring = 0;
  while (rho > t.rings[ring].high) ++ring;
  return with_logarithm(t.near[ring], x, y, rho);
}

/// ∫ f over [a, b] by `count` intervals of Gauss' rule of eight points.
template <class Function>
double gauss(double a, double b, int count, const Function& f) {
  double sum = 0;
  const double half = (b - a) / (2 * count);
  for (int i = 0; i < count; ++i) {
    const double middle = a + (2 * i + 1) * half;
    for (std::size_t k = 0; k < kGaussAt.size(); ++k)
      sum += kGaussWeight[k] * (f(middle - half * kGaussAt[k]) + f(middle + half * kGaussAt[k]));
  }
  return sum * half;
}

}  // namespace

double wave_green_integral(double x, double y) {
  // With y − v = x sinh u the root is gone: ∫ e^{x sinh u − y} du, up to v = 0; beyond v = 40 is
  // round-off.
  const double high = std::asinh(y / x), low = std::asinh((y - 40) / x);
  return gauss(low, high, 64, [&](double u) { return std::exp(x * std::sinh(u) - y); });
}

WaveGreen wave_green(double x, double y) {
  const Real real = real_part(x, y);
  const double decay = 2 * pi * std::exp(-y);
  return {{real.value, decay * ::j0(x)}, {real.by_x, -decay * ::j1(x)}};
}

}  // namespace hydro

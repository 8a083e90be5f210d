#include "hydro/radiation/finite_depth_green.h"

#include <math.h>  // j0 and j1, which <cmath> need not have

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hydro/airy_waves.h"
#include "hydro/radiation/gauss_rule.h"
#include "hydro/radiation/green_function.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

/// Exponent beyond which an exponential is left out.
constexpr double kFaint = 25;

/// The integrands of (2) and (3) without the Bessel function, and their residues.
struct Integrands {
  double K, k, h;

  /// (μ + K)/D
  double ratio(double mu, double E) const {
    if (std::isinf(K)) return -1 / (1 + E);
    return (mu + K) / (mu - K - (mu + K) * E);
  }
  double bottom(double mu, double v) const {
    const double E = std::exp(-2 * mu * h);
    return ratio(mu, E) * (std::exp(-mu * (2 * h - v)) + std::exp(-mu * (2 * h + v)));
  }
  double rest(double mu, double v) const {
    const double E = std::exp(-2 * mu * h);
    const double image = std::isinf(K) ? -1 : (mu + K) / (mu - K);
    return ratio(mu, E) * (std::exp(-mu * (2 * h + v)) + image * E * std::exp(-mu * (2 * h - v)));
  }
  /// Residue of both at μ = k.
  double residue(double v) const {
    const double E = std::exp(-2 * k * h), difference = (k + K) * E;  // k − K
    return difference * (std::exp(-k * v) + std::exp(k * v)) / (1 - E + 2 * h * difference);
  }
  /// Residue of (3) at μ = K.
  double deep_residue(double v) const { return -2 * K * std::exp(-K * (2 * h - v)); }
};

struct WaveNumberRule {
  std::vector<double> at, weight;
  double pole_end = 0;  ///< Wave number up to which the poles are taken out.
};

/// @param longest   Length of the intervals.
void add_rule(double from, double to, double longest, WaveNumberRule& rule) {
  const int count = std::max(1, static_cast<int>(std::ceil((to - from) / longest)));
  for (int i = 0; i < count; ++i) {
    const double half = (to - from) / (2 * count), middle = from + (2 * i + 1) * half;
    for (std::size_t n = 0; n < kGaussAt.size(); ++n)
      for (const double sign : {-1.0, 1.0}) {
        rule.at.push_back(middle + sign * half * kGaussAt[n]);
        rule.weight.push_back(half * kGaussWeight[n]);
      }
  }
}

/// Points of μ for (2) and (3), with the poles at ends of intervals.
WaveNumberRule make_rule(const Integrands& f, double end, double reach) {
  constexpr double kApart = 1e-4;  // Nearer poles are well within one interval.
  const double longest = 1 / std::max(f.h, reach / 2);
  WaveNumberRule rule;
  double from = 0;
  if (f.k > 0) {
    rule.pole_end = 2 * f.k;
    const double fine = std::min(longest, f.k / 2);
    const double break_at = f.k - f.K > kApart * f.k ? f.K : 0;
    if (break_at > 0) add_rule(0, break_at, fine, rule);
    add_rule(break_at, f.k, fine, rule);
    add_rule(f.k, 2 * f.k, fine, rule);
    from = 2 * f.k;
    while (from < end && from / 2 < longest) {  // (2) is like 1/μ from k to 1/h.
      add_rule(from, 1.5 * from, longest, rule);
      from *= 1.5;
    }
  }
  if (from < end) add_rule(from, end, longest, rule);
  return rule;
}

/// The samples' sum over the rule, with poles subtracted.
struct BesselSamples {
  const WaveNumberRule& rule;
  const VectorXd& distances;
  const MatrixXd& bessel;  ///< J₀(μR) times the weight: a row for each distance.

  MatrixXd integrals(const MatrixXd& integrand) const { return bessel * integrand; }

  /// Adds the Cauchy principal value of the pole, less what the rule made of it.
  void add_pole(double pole, const Eigen::RowVectorXd& residues, MatrixXd& sum) const {
    double factor = std::log((rule.pole_end - pole) / pole);
    for (std::size_t q = 0; q < rule.at.size() && rule.at[q] < rule.pole_end; ++q)
      factor -= rule.weight[q] / (rule.at[q] - pole);
    const VectorXd j = (pole * distances).unaryExpr([](double x) { return ::j0(x); });
    sum += factor * j * residues;
  }
};

}  // namespace

FiniteDepthGreen::FiniteDepthGreen(double deep_wave_number, double depth, double reach,
                                   double draught)
    : deep_(deep_wave_number), depth_(depth) {
  const double end = kFaint / (2 * depth - draught);
  Integrands f{.K = deep_, .k = 0, .h = depth};
  if (std::isfinite(deep_)) {
    wave_number_ = hydro::wave_number(std::sqrt(deep_), depth, 1).value();
    const double k = wave_number_, tanh = std::tanh(k * depth);
    amplitude_ = 2 * pi * k / (tanh + k * depth * (1 - tanh) * (1 + tanh));
    if (k < end) f.k = k;
  }
  const double longest = std::min(depth, f.k > 0 ? 4 / f.k : depth);
  const int count = std::max(1, static_cast<int>(std::ceil(reach / longest)));
  piece_ = std::max(reach, 1e-6 * depth) / count;
  const WaveNumberRule rule = make_rule(f, end, piece_ * count);
  const ChebyshevInterval low{0, draught}, high{2 * (depth - draught), 2 * depth};
  const Index points = static_cast<Index>(rule.at.size());
  MatrixXd bottom(points, kOrder), rest(points, kOrder);
  Eigen::RowVectorXd residue_low(kOrder), residue_high(kOrder), deep_residue(kOrder);
  for (int j = 0; j < kOrder; ++j) {
    const double v = Table::place(low, j), w = Table::place(high, j);
    for (Index q = 0; q < points; ++q) {
      bottom(q, j) = f.bottom(rule.at[static_cast<std::size_t>(q)], v);
      rest(q, j) = f.rest(rule.at[static_cast<std::size_t>(q)], w);
    }
    residue_low[j] = f.residue(v);
    residue_high[j] = f.residue(w);
    deep_residue[j] = f.deep_residue(w);
  }
  for (int i = 0; i < count; ++i) {
    const ChebyshevInterval range{i * piece_, (i + 1) * piece_};
    VectorXd distances(kOrder);
    MatrixXd bessel(kOrder, points);
    for (int n = 0; n < kOrder; ++n) {
      distances[n] = Table::place(range, n);
      for (Index q = 0; q < points; ++q) {
        const auto at = static_cast<std::size_t>(q);
        bessel(n, q) = rule.weight[at] * ::j0(rule.at[at] * distances[n]);
      }
    }
    const BesselSamples samples{rule, distances, bessel};
    MatrixXd P = samples.integrals(bottom), Q = samples.integrals(rest);
    if (f.k > 0) {
      samples.add_pole(f.k, residue_low, P);
      samples.add_pole(f.k, residue_high, Q);
      samples.add_pole(f.K, deep_residue, Q);
    }
    pieces_.push_back({Table(range, low, P), Table(range, high, Q)});
  }
}

SmoothGreen FiniteDepthGreen::at(double distance, double z_x, double z_y) const {
  const auto piece = std::min(pieces_.size() - 1, static_cast<std::size_t>(distance / piece_));
  const double apart = z_y - z_x;
  const Table::Sample P = pieces_[piece].bottom.at(distance, std::abs(apart));
  const Table::Sample Q = pieces_[piece].rest.at(distance, z_x + z_y + 2 * depth_);
  SmoothGreen green{.value = P.value + Q.value,
                    .by_distance = P.by_first + Q.by_first,
                    .by_height = (apart < 0 ? -1 : 1) * P.by_second + Q.by_second};
  if (std::isinf(deep_)) return green;
  const WaveGreen deep = wave_green(deep_ * distance, -deep_ * (z_x + z_y));
  green.value += deep_ * deep.value.real();
  green.by_distance += deep_ * deep_ * deep.by_x.real();
  green.by_height += deep_ * deep_ * deep.value.real();
  const double k = wave_number_, floor = 1 + std::exp(-2 * k * depth_);
  const auto depth_function = [&](double z, double sign) {
    return (std::exp(k * z) + sign * std::exp(-k * (z + 2 * depth_))) / floor;
  };
  const double wave = amplitude_ * depth_function(z_x, 1), j = ::j0(k * distance);
  green.value.imag(wave * depth_function(z_y, 1) * j);
  green.by_distance.imag(-wave * depth_function(z_y, 1) * k * ::j1(k * distance));
  green.by_height.imag(wave * k * depth_function(z_y, -1) * j);
  return green;
}

}  // namespace hydro

#include "hydro/radiation/oscillator_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/LevenbergMarquardt>

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr int kMostPerMotion = 3;         ///< Oscillators.
constexpr std::size_t kMostSamples = 40;  ///< Frequencies that are fitted, more or less.
constexpr int kTrialEvaluations = 50;  ///< Of the residuals, from each start; in a large fit half.
constexpr int kMostEvaluations = 200;  ///< From the best ends of those; in a large fit half.
constexpr std::size_t kKeptFits = 3;   ///< That are carried on, and grow.
constexpr Index kLargeFit = 60;        ///< Parameters from which only one is.
constexpr double kSmallGain = 1e-5;    ///< Part of the sum of squares that ends a search [-].
constexpr double kUseful = 0.9;        ///< Ratio of errors by which one more is of use [-].
constexpr double kWeakest = 0.01;      ///< Damping of an oscillator at the start of a fit [-].
// Errors above the mean frequency of the damping count by its ratio to theirs to this power. A body
// moves little there, and the data of a solver has its largest errors there: panels that are
// coarse against the waves, and irregular frequencies, which nothing passive follows.
constexpr double kTailWeight = 1;
constexpr double kLargestPeak = 1.5;  ///< Of a response between the data, over the data's [-].
constexpr int kBetween = 8;           ///< Parts between two frequencies that are looked at.

/// What is fitted: frequencies over `unit`, H over `scale` along rows and columns.
struct Samples {
  double unit = 1;  ///< The mean frequency of the damping, by its logarithm [rad/s].
  VectorXd scale;   ///< The root of the largest |H_ii|.
  std::vector<double> frequencies;
  std::vector<MatrixXcd> H;
  std::vector<double> weights;

  Index motions() const { return scale.size(); }
};

Samples make_samples(const std::vector<double>& frequencies, const std::vector<MatrixXcd>& H) {
  Samples samples;
  samples.scale = VectorXd::Zero(H.front().rows());
  for (const MatrixXcd& at : H) samples.scale = samples.scale.cwiseMax(at.diagonal().cwiseAbs());
  samples.scale = samples.scale.cwiseSqrt();
  const VectorXd inverse = samples.scale.cwiseInverse();
  double weight = 0, sum = 0;
  const std::size_t stride = (H.size() + kMostSamples - 1) / kMostSamples;
  for (std::size_t k = 0; k < H.size(); k += stride) {
    samples.frequencies.push_back(frequencies[k]);
    samples.H.push_back(inverse.asDiagonal() * H[k] * inverse.asDiagonal());
    const double damping = samples.H.back().real().diagonal().cwiseMax(0).sum();
    weight += damping;
    sum += damping * std::log(frequencies[k]);
  }
  samples.unit =
      weight > 0 ? std::exp(sum / weight) : std::sqrt(frequencies.front() * frequencies.back());
  for (double& frequency : samples.frequencies) {
    frequency /= samples.unit;
    samples.weights.push_back(std::pow(std::max(1.0, frequency), -kTailWeight));
  }
  return samples;
}

/// m log-frequencies, the columns of L from its diagonal down, the rows of B.
struct Layout {
  Index m, n;

  Index damping() const { return m; }
  Index port() const { return m + m * (m + 1) / 2; }
  Index size() const { return port() + m * n; }
};

bool is_large(const Layout& layout) { return layout.size() > kLargeFit; }

MatrixXd lower(const Layout& layout, const VectorXd& x) {
  MatrixXd L = MatrixXd::Zero(layout.m, layout.m);
  Index at = layout.damping();
  for (Index j = 0; j < layout.m; ++j)
    for (Index i = j; i < layout.m; ++i) L(i, j) = x[at++];
  return L;
}

MatrixXd port(const Layout& layout, const VectorXd& x) {
  return x.tail(layout.m * layout.n).reshaped<Eigen::RowMajor>(layout.m, layout.n);
}

Oscillators oscillators(const Layout& layout, const VectorXd& x) {
  const MatrixXd L = lower(layout, x);
  return {.frequencies = x.head(layout.m).array().exp(),
          .damping = L * L.transpose(),
          .port = port(layout, x)};
}

/// (s² + s D + Ω²)⁻¹ B
MatrixXcd displacements(const Oscillators& o, double frequency) {
  const Complex s(0, frequency);
  MatrixXcd matrix = s * o.damping;
  matrix.diagonal().array() += s * s + o.frequencies.array().square();
  return matrix.partialPivLu().solve(o.port.cast<Complex>());
}

/// The residuals Ĥ − H, real and imaginary parts of the entries on and below the diagonal, weighted
/// so that the sum of squares is that of all entries.
class Residuals : public Eigen::DenseFunctor<double> {
 public:
  Residuals(const Samples& samples, const Layout& layout)
      : DenseFunctor(static_cast<int>(layout.size()),
                     static_cast<int>(std::max(count(samples), layout.size()))),
        samples_(samples),
        layout_(layout) {}

  int operator()(const VectorXd& x, VectorXd& residuals) const {
    const Oscillators o = oscillators(layout_, x);
    residuals.setZero();
    double* out = residuals.data();
    for (std::size_t k = 0; k < samples_.H.size(); ++k) {
      const MatrixXcd off =
          samples_.weights[k] * (response(o, samples_.frequencies[k]) - samples_.H[k]);
      put([&off](Index i, Index j) { return off(i, j); }, out);
    }
    return 0;
  }

  /// The derivatives by the parameters. With X = (s² + sD + Ω²)⁻¹ B,
  ///
  ///     dĤ = s (dBᵀ X + Xᵀ dB) − s Xᵀ (dΩ² + s dD) X.
  int df(const VectorXd& x, MatrixXd& jacobian) const {
    const Oscillators o = oscillators(layout_, x);
    const MatrixXd L = lower(layout_, x);
    jacobian.setZero();
    for (std::size_t k = 0; k < samples_.H.size(); ++k) {
      const double weight = samples_.weights[k];
      const Complex s(0, samples_.frequencies[k]);
      const MatrixXcd X = displacements(o, samples_.frequencies[k]);
      const MatrixXcd Y = L.transpose() * X;
      Index column = 0;
      const auto add = [&](const auto& entry) {
        double* out = &jacobian(static_cast<Index>(k) * rows(samples_), column++);
        put(entry, out);
      };
      for (Index j = 0; j < layout_.m; ++j) {
        const Complex factor = -2.0 * weight * s * o.frequencies[j] * o.frequencies[j];
        add([&](Index a, Index b) { return factor * X(j, a) * X(j, b); });
      }
      for (Index j = 0; j < layout_.m; ++j)
        for (Index i = j; i < layout_.m; ++i)
          add([&](Index a, Index b) {
            return -weight * s * s * (X(i, a) * Y(j, b) + Y(j, a) * X(i, b));
          });
      for (Index j = 0; j < layout_.m; ++j)
        for (Index i = 0; i < layout_.n; ++i)
          add([&](Index a, Index b) {
            return weight * s * ((a == i ? X(j, b) : Complex(0)) + (b == i ? X(j, a) : Complex(0)));
          });
    }
    return 0;
  }

 private:
  /// Of one frequency.
  static Index rows(const Samples& samples) { return samples.motions() * (samples.motions() + 1); }
  static Index count(const Samples& samples) {
    return static_cast<Index>(samples.H.size()) * rows(samples);
  }

  template <class Entry>
  void put(const Entry& entry, double*& out) const {
    for (Index i = 0; i < layout_.n; ++i)
      for (Index j = 0; j <= i; ++j) {
        const Complex value = (i == j ? 1.0 : std::sqrt(2.0)) * entry(i, j);
        *out++ = value.real();
        *out++ = value.imag();
      }
  }

  const Samples& samples_;
  Layout layout_;
};

/// Moré's form of Levenberg and Marquardt's method. @param evaluations   Of the residuals at most.
VectorXd least_squares(Residuals residuals, VectorXd x, int evaluations) {
  Eigen::LevenbergMarquardt<Residuals> method(residuals);
  method.setMaxfev(evaluations);
  method.setFtol(kSmallGain);
  method.setFactor(10);
  method.minimize(x);
  return x;
}

struct Fit {
  VectorXd x;
  double error = std::numeric_limits<double>::infinity();  ///< RMS over frequencies and motions.
};

double rms_error(const Samples& samples, const Oscillators& o) {
  double sum = 0;
  for (std::size_t k = 0; k < samples.H.size(); ++k)
    sum += std::pow(samples.weights[k], 2) *
           (response(o, samples.frequencies[k]) - samples.H[k]).squaredNorm();
  const Index n = samples.motions();
  return std::sqrt(sum / static_cast<double>(samples.H.size()) / static_cast<double>(n * n));
}

/// True if the response has a peak between the data that the data does not show.
bool has_spurious_peak(const Samples& samples, const Oscillators& o) {
  for (std::size_t k = 1; k < samples.frequencies.size(); ++k)
    for (int i = 1; i < kBetween; ++i) {
      const double part = static_cast<double>(i) / kBetween;
      const double frequency =
          (1 - part) * samples.frequencies[k - 1] + part * samples.frequencies[k];
      if (response(o, frequency).diagonal().cwiseAbs().maxCoeff() > kLargestPeak) return true;
    }
  return false;
}

/// From the start, by so many evaluations at most.
Fit fit_from(const Samples& samples, const Layout& layout, const VectorXd& start, int evaluations) {
  const VectorXd x = least_squares({samples, layout}, start, evaluations);
  const Oscillators found = oscillators(layout, x);
  if (!x.allFinite() || has_spurious_peak(samples, found)) return {};
  return {.x = x, .error = rms_error(samples, found)};
}

struct Added {
  double frequency;
  double damping;           ///< Over the frequency.
  Eigen::RowVectorXd port;  ///< Over the root of the damping.
};

/// Parameters of the oscillators with one more, which is not coupled to them.
VectorXd with_one_more(const Layout& before, const VectorXd& x, const Added& added) {
  const Layout after{.m = before.m + 1, .n = before.n};
  MatrixXd L = MatrixXd::Zero(after.m, after.m);
  L.topLeftCorner(before.m, before.m) = lower(before, x);
  L(before.m, before.m) = std::sqrt(added.damping * added.frequency);
  VectorXd result(after.size());
  result.head(before.m) = x.head(before.m);
  result[before.m] = std::log(added.frequency);
  Index at = after.damping();
  for (Index j = 0; j < after.m; ++j)
    for (Index i = j; i < after.m; ++i) result[at++] = L(i, j);
  result.segment(after.port(), before.m * before.n) = x.tail(before.m * before.n);
  result.tail(after.n) = L(before.m, before.m) * added.port;
  return result;
}

std::size_t sample_near(const Samples& samples, double frequency) {
  const auto& all = samples.frequencies;
  return static_cast<std::size_t>(std::lower_bound(all.begin(), all.end() - 1, frequency) -
                                  all.begin());
}

/// An oscillator that alone would supply most of the damping that these lack at its frequency, but
/// not less than `least`.
Added supplement(const Samples& samples, const Oscillators& o, double frequency, double least) {
  const std::size_t k = sample_near(samples, frequency);
  MatrixXd lacking = samples.H[k].real();
  if (o.frequencies.size() > 0) lacking -= response(o, samples.frequencies[k]).real();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(lacking);
  const double value = std::max(least, eigen.eigenvalues().tail<1>()[0]);
  return {.frequency = frequency,
          .damping = 1,
          .port = std::sqrt(value) * eigen.eigenvectors().rightCols<1>().transpose()};
}

/// Parameters of m oscillators that are spread over the frequencies from 1/reach to reach.
VectorXd spread_oscillators(const Samples& samples, Index m, double reach, double damping) {
  Layout layout{.m = 0, .n = samples.motions()};
  VectorXd x(0);
  for (; layout.m < m; ++layout.m) {
    const double place = (2.0 * static_cast<double>(layout.m) + 1) / static_cast<double>(m) - 1;
    Added added = supplement(samples, {}, std::pow(reach, place), kWeakest);
    added.damping = damping;
    added.port /= std::sqrt(static_cast<double>(m));
    x = with_one_more(layout, x, added);
  }
  return x;
}

/// Parameters to begin a fit of one oscillator more than `last` with, which has m.
std::vector<VectorXd> starts(const Samples& samples, Index m, const std::vector<Fit>& last) {
  const Layout before{.m = m, .n = samples.motions()};
  std::vector<VectorXd> result;
  for (const Fit& fit : last) {
    const Oscillators o = oscillators(before, fit.x);
    for (const double frequency : {1.0, 0.5, 2.0})
      for (const double least : {kWeakest, 1.0})
        result.push_back(with_one_more(before, fit.x, supplement(samples, o, frequency, least)));
  }
  if (is_large({.m = m + 1, .n = before.n})) return result;
  for (const double reach : {1.5, 3.0})
    for (const double damping : {0.5, 1.5})
      result.push_back(spread_oscillators(samples, m + 1, reach, damping));
  return result;
}

void sort_by_error(std::vector<Fit>& fits) {
  std::stable_sort(fits.begin(), fits.end(),
                   [](const Fit& a, const Fit& b) { return a.error < b.error; });
}

/// The best fits with one oscillator more than those of `last`, which have m; may be none.
std::vector<Fit> grown(const Samples& samples, Index m, const std::vector<Fit>& last) {
  const Layout layout{.m = m + 1, .n = samples.motions()};
  const bool large = is_large(layout);
  std::vector<Fit> fits;
  for (const VectorXd& start : starts(samples, m, last)) {
    const Fit fit =
        fit_from(samples, layout, start, large ? kTrialEvaluations / 2 : kTrialEvaluations);
    if (std::isfinite(fit.error)) fits.push_back(fit);
  }
  sort_by_error(fits);
  const std::size_t kept = large ? 1 : kKeptFits;
  if (fits.size() > kept) fits.resize(kept);
  for (Fit& fit : fits) {
    const Fit better =
        fit_from(samples, layout, fit.x, large ? kMostEvaluations / 2 : kMostEvaluations);
    if (better.error < fit.error) fit = better;
  }
  sort_by_error(fits);
  return fits;
}

}  // namespace

MatrixXcd response(const Oscillators& o, double frequency) {
  return Complex(0, frequency) * (o.port.transpose() * displacements(o, frequency));
}

Oscillators fit_oscillators(const std::vector<double>& frequencies, const std::vector<MatrixXcd>& H,
                            double wanted) {
  const Samples samples = make_samples(frequencies, H);
  const Index n = samples.motions();
  std::vector<Fit> best = {{.x = VectorXd(0)}};
  Index m = 0;
  for (Index more = 1; more <= kMostPerMotion * n && best.front().error > wanted; ++more) {
    std::vector<Fit> fits = grown(samples, more - 1, best);
    if (fits.empty()) break;
    if (!(fits.front().error < kUseful * best.front().error) && more > n) break;
    best = std::move(fits);
    m = more;
  }
  Oscillators result = oscillators({.m = m, .n = n}, best.front().x);
  result.frequencies *= samples.unit;
  result.damping *= samples.unit;
  result.port = std::sqrt(samples.unit) * result.port * samples.scale.asDiagonal();
  return result;
}

}  // namespace hydro

#include "hydro/radiation/oscillator_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "hydro/decompositions.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

/// δ [-]. A larger one blurs the response: the error of a sphere's fit, 0.15 % of the largest value
/// in the root mean square, becomes 0.4 % at 0.05.
constexpr double kSpacing = 0.025;
constexpr double kOverlap = 1.2;  ///< ζ/δ [-]; ripples grow below 1, blur above.
/// Unknown residues of a fit; one that would have more has a larger δ. Time and memory grow as the
/// third and second power of their number: 6 s and 10 MB at this one.
constexpr int kMostUnknowns = 1200;
/// Ratio of the outermost Ω to the outermost ω, above and below [-].
constexpr double kBeyond = 1.5;
// Errors above the mean frequency of the damping count by its ratio to theirs to this power. A body
// moves little there, and the data of a solver has its largest errors there: panels that are
// coarse against the waves, and irregular frequencies, which nothing passive follows.
constexpr double kTailWeight = 1;
constexpr double kFirstBarrier = 1e-2;  ///< μ at the start [-].
constexpr double kBarrier = 1e-10;      ///< μ [-]. It adds less than 1e-7 to the mean square.
constexpr double kBarrierStep = 0.01;   ///< Factor of μ from one minimum to the next [-].
constexpr double kFirstPeak = 0.05;     ///< Peak of each oscillator at the start [-].
/// Newton's decrement over μ that ends the search of a minimum [-]: as the convergence is
/// quadratic, the step that is taken then leaves the square of it.
constexpr double kConverged = 1e-6;
constexpr double kLeastPeak = 1e-3;  ///< Peak below which an oscillator is left out [-].

/// The samples to fit: H over `scale` along rows and columns.
struct Samples {
  VectorXd scale;  ///< The root of the largest |H_ii|.
  std::vector<double> frequencies;
  std::vector<MatrixXcd> H;
  std::vector<double> weights;

  Index motions() const { return scale.size(); }
};

/// The rule of (4).
struct Comb {
  VectorXd frequencies;  ///< Ω
  VectorXd damping;      ///< d
  double spacing;        ///< δ
};

Comb make_comb(double lowest, double highest, Index motions) {
  const double from = std::log(lowest / kBeyond), to = std::log(highest * kBeyond);
  const Index most = kMostUnknowns / (motions * (motions + 1) / 2);
  const Index count = std::min(most, static_cast<Index>(std::ceil((to - from) / kSpacing)) + 1);
  Comb comb{.frequencies = VectorXd::LinSpaced(count, from, to).array().exp(),
            .spacing = (to - from) / static_cast<double>(count - 1)};
  comb.damping = 2 * kOverlap * comb.spacing * comb.frequencies;
  return comb;
}

/// s d_k / (s² + d_k s + Ω_k²) at s = iω, which is 1 at its peak.
Complex unit_response(const Comb& comb, Index k, double frequency) {
  const Complex s(0, frequency);
  const Complex damped = s * comb.damping[k];
  return damped / (s * s + damped + comb.frequencies[k] * comb.frequencies[k]);
}

/// Adds the values between the frequencies k and k + 1, at most `spacing` apart in their logarithm.
void add_between(const std::vector<double>& frequencies, const std::vector<MatrixXcd>& H,
                 std::size_t k, double spacing, Samples& samples) {
  const double gap = std::log(frequencies[k + 1] / frequencies[k]);
  const int parts = static_cast<int>(std::ceil(gap / spacing));
  const std::size_t first = std::clamp<std::size_t>(k, 1, H.size() - 3) - 1;
  for (int part = 1; part < parts; ++part) {
    const double frequency = frequencies[k] * std::exp(gap * part / parts);
    MatrixXcd sum = MatrixXcd::Zero(H[k].rows(), H[k].cols());
    for (std::size_t i = first; i < first + 4; ++i) {
      double weight = 1;
      for (std::size_t j = first; j < first + 4; ++j)
        if (j != i)
          weight *=
              std::log(frequency / frequencies[j]) / std::log(frequencies[i] / frequencies[j]);
      sum += weight * H[i];
    }
    samples.frequencies.push_back(frequency);
    samples.H.push_back(sum);
  }
}

/// The mean frequency of the damping, by its logarithm [rad/s].
double mean_frequency(const Samples& samples) {
  double weight = 0, sum = 0;
  for (std::size_t i = 0; i < samples.H.size(); ++i) {
    const double damping = samples.H[i].real().diagonal().cwiseMax(0).sum();
    weight += damping;
    sum += damping * std::log(samples.frequencies[i]);
  }
  return weight > 0 ? std::exp(sum / weight)
                    : std::sqrt(samples.frequencies.front() * samples.frequencies.back());
}

Samples make_samples(const std::vector<double>& frequencies, const std::vector<MatrixXcd>& H,
                     double spacing) {
  Samples samples;
  samples.scale = VectorXd::Zero(H.front().rows());
  for (const MatrixXcd& at : H) samples.scale = samples.scale.cwiseMax(at.diagonal().cwiseAbs());
  samples.scale = samples.scale.cwiseSqrt();
  const VectorXd inverse = samples.scale.cwiseInverse();
  for (std::size_t k = 0; k < H.size(); ++k) {
    samples.frequencies.push_back(frequencies[k]);
    samples.H.push_back(H[k]);
    if (k + 1 < H.size() && H.size() >= 4) add_between(frequencies, H, k, spacing, samples);
  }
  for (MatrixXcd& at : samples.H)
    at = at.cwiseProduct((inverse * inverse.transpose()).cast<Complex>()).eval();
  const double mean = mean_frequency(samples);
  for (const double frequency : samples.frequencies)
    samples.weights.push_back(std::pow(std::max(1.0, frequency / mean), -kTailWeight));
  return samples;
}

/// Symmetric n × n matrices as vectors: the diagonal, and √2 times what is below it.
class SymmetricBasis {
 public:
  explicit SymmetricBasis(Index motions) {
    for (int i = 0; i < motions; ++i)
      for (int j = 0; j <= i; ++j) entries_.push_back({i, j, i == j ? 1 : std::sqrt(2.0)});
  }

  Index size() const { return static_cast<Index>(entries_.size()); }

  template <class Matrix>
  VectorXd to_vector(const Matrix& matrix) const {
    VectorXd result(size());
    Index at = 0;
    for (const Entry& e : entries_) result[at++] = e.factor * matrix(e.row, e.column);
    return result;
  }

  /// In the first rows and columns of `rest`.
  template <class Vector>
  Matrix6d to_matrix(const Vector& vector, const Matrix6d& rest) const {
    Matrix6d result = rest;
    Index at = 0;
    for (const Entry& e : entries_)
      result(e.row, e.column) = result(e.column, e.row) = vector[at++] / e.factor;
    return result;
  }

  /// Adds the matrix of X ↦ factor P X P.
  template <class Block>
  void add_congruence(const Matrix6d& P, double factor, Block&& block) const {
    for (Index a = 0; a < size(); ++a)
      for (Index b = 0; b < size(); ++b) {
        const auto [i, j, of_column] = entries_[static_cast<std::size_t>(a)];
        const auto [k, l, of_row] = entries_[static_cast<std::size_t>(b)];
        const double both = (P(k, i) * P(j, l) + P(k, j) * P(i, l)) / 2;
        block(b, a) += factor * of_column * of_row * both;
      }
  }

 private:
  struct Entry {
    int row, column;
    double factor;
  };
  std::vector<Entry> entries_;
};

/// The function (5) of the peaks X_k = R_k / d_k, a column of `vectors` each.
class BarrierProblem {
 public:
  BarrierProblem(const Samples& samples, const Comb& comb) : basis_(samples.motions()) {
    const auto count = static_cast<Index>(samples.H.size());
    const double part =
        1 / (std::sqrt(static_cast<double>(count)) * static_cast<double>(samples.motions()));
    MatrixXd unit(2 * count, comb.frequencies.size()), wanted(2 * count, basis_.size());
    for (Index i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double weight = part * samples.weights[at];
      for (Index k = 0; k < unit.cols(); ++k) {
        const Complex response = unit_response(comb, k, samples.frequencies[at]);
        unit(i, k) = weight * response.real();
        unit(count + i, k) = weight * response.imag();
      }
      wanted.row(i) = weight * basis_.to_vector(samples.H[at].real());
      wanted.row(count + i) = weight * basis_.to_vector(samples.H[at].imag());
    }
    squares_ = unit.transpose() * unit;
    products_ = wanted.transpose() * unit;
  }

  MatrixXd start() const {
    return basis_.to_vector(Matrix6d(kFirstPeak * Matrix6d::Identity()))
        .replicate(1, squares_.cols());
  }

  /// X_k in the first rows and columns, and zeros.
  Matrix6d peak(const MatrixXd& vectors, Index k) const {
    return basis_.to_matrix(vectors.col(k), Matrix6d::Zero());
  }

  /// Infinite where a residue is not positive.
  double value(const MatrixXd& vectors, double mu) const {
    double barrier = 0;
    for (Index k = 0; k < vectors.cols(); ++k) {
      const Cholesky6 factor = factorized(vectors, k);
      if (!factor.positive_definite()) return std::numeric_limits<double>::infinity();
      for (int i = 0; i < 6; ++i) barrier -= 2 * std::log(factor.lower()(i, i));
    }
    const MatrixXd slope = vectors * squares_ / 2 - products_;
    return slope.cwiseProduct(vectors).sum() + mu * barrier;
  }

  /// Takes a step of Newton's method, shortened until the value falls by a part of what its slope
  /// promises. Near the minimum the whole step is safe, as logarithms of determinants are
  /// self-concordant, and the fall is below round-off.
  /// @return Newton's decrement, twice the fall that a full step of a quadratic has.
  double take_step(MatrixXd& vectors, double mu) const {
    const Index q = basis_.size(), count = vectors.cols();
    MatrixXd gradient = vectors * squares_ - products_;
    MatrixXd hessian = MatrixXd::Zero(q * count, q * count);
    for (Index l = 0; l < count; ++l)
      for (Index k = l; k < count; ++k)
        hessian.block(q * k, q * l, q, q).diagonal().setConstant(squares_(k, l));
    for (Index k = 0; k < count; ++k) {
      const Matrix6d inverse = factorized(vectors, k).inverse();
      gradient.col(k) -= mu * basis_.to_vector(inverse);
      basis_.add_congruence(inverse, mu, hessian.block(q * k, q * k, q, q));
    }
    MatrixXd change(q, count);
    change.reshaped() = -solve_positive(hessian, gradient.reshaped());
    const double decrement = -gradient.cwiseProduct(change).sum(), before = value(vectors, mu);
    double part = 1;
    while (decrement > kNear * mu &&
           !(value(vectors + part * change, mu) <= before - kFall * part * decrement))
      part *= kShorter;
    vectors += part * change;
    return decrement;
  }

 private:
  static constexpr double kNear = 0.01;    ///< Decrement over μ of a safe whole step [-].
  static constexpr double kFall = 1e-4;    ///< [-]
  static constexpr double kShorter = 0.7;  ///< Factor of a step [-].

  /// X_k with ones for the motions that are missing: these change neither its determinant nor its
  /// inverse.
  Cholesky6 factorized(const MatrixXd& vectors, Index k) const {
    return Cholesky6(basis_.to_matrix(vectors.col(k), Matrix6d::Identity()));
  }

  SymmetricBasis basis_;
  MatrixXd squares_;   ///< Products of the unit responses with each other.
  MatrixXd products_;  ///< The same with H, a column for each unit response.
};

/// The peaks at the minimum of (5).
MatrixXd minimise(const BarrierProblem& problem) {
  constexpr int kMostSteps = 100;  // For each μ; about ten are taken.
  MatrixXd vectors = problem.start();
  for (double mu = kFirstBarrier; mu > kBarrier / 2; mu *= kBarrierStep)
    for (int step = 0; step < kMostSteps; ++step)
      if (problem.take_step(vectors, mu) < kConverged * mu) break;
  return vectors;
}

}  // namespace

MatrixXcd response(const Oscillators& o, double frequency) {
  const Complex s(0, frequency);
  MatrixXd real = o.port, imag = o.port;
  for (Index k = 0; k < o.port.rows(); ++k) {
    const Complex each = s / (s * s + s * o.damping[k] + o.frequencies[k] * o.frequencies[k]);
    real.row(k) *= each.real();
    imag.row(k) *= each.imag();
  }
  MatrixXcd result(o.port.cols(), o.port.cols());
  result.real() = o.port.transpose() * real;
  result.imag() = o.port.transpose() * imag;
  return result;
}

Oscillators fit_oscillators(const std::vector<double>& frequencies,
                            const std::vector<MatrixXcd>& H) {
  assert(!frequencies.empty() && frequencies.size() == H.size());
  const Index n = H.front().rows();
  assert(n <= 6);
  const Comb comb = make_comb(frequencies.front(), frequencies.back(), n);
  const Samples samples = make_samples(frequencies, H, comb.spacing);
  const BarrierProblem problem(samples, comb);
  const MatrixXd vectors = minimise(problem);
  std::vector<Index> kept;  // The Ω of each row.
  MatrixXd port(vectors.cols() * n, n);
  for (Index k = 0; k < vectors.cols(); ++k) {
    const EigenDecomposition6 eigen = eigen_decomposition(problem.peak(vectors, k));
    for (Index j = 0; j < 6; ++j) {
      if (eigen.values[j] < kLeastPeak) continue;
      port.row(static_cast<Index>(kept.size())) =
          std::sqrt(comb.damping[k] * eigen.values[j]) *
          samples.scale.cwiseProduct(eigen.vectors.col(j).head(n)).transpose();
      kept.push_back(k);
    }
  }
  return {.frequencies = comb.frequencies(kept),
          .damping = comb.damping(kept),
          .port = port.topRows(static_cast<Index>(kept.size()))};
}

}  // namespace hydro

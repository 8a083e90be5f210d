#include "hydro/water/periodic_waves.h"

#include <Eigen/QR>
#include <cmath>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "hydro/airy_waves.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXcf;
using Eigen::MatrixXf;

/// β of the window.
constexpr double kWindow = 7.4;

/// Heights of the layers over `PeriodicSquare::deepest`.
constexpr double kLayerHeights[] = {0, -0.1, -0.5, -1.5};

/// Fourier transform in both directions, forwards or backwards.
void transform(MatrixXcf& field, bool forward) {
  Eigen::FFT<float> fft;
  MatrixXcf result(field.rows(), field.cols());
  for (int pass = 0; pass < 2; ++pass) {
    for (Index c = 0; c < field.cols(); ++c)
      if (field.col(c).isZero(0))  // As most columns of sources are.
        result.col(c).setZero();
      else if (forward)
        fft.fwd(result.col(c).data(), field.col(c).data(), field.rows());
      else
        fft.inv(result.col(c).data(), field.col(c).data(), field.rows());
    field = result.transpose();
  }
}

/// The window at a distance in cells.
double window(double cells) {
  const double s = cells / 2;
  return s * s < 1 ? std::exp(kWindow * (std::sqrt(1 - s * s) - 1)) : 0;
}

/// Transform of the window at a phase a cell [rad].
double window_transform(double phase) {
  constexpr int kSteps = 200;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double u = 2 * (2 * (i + 0.5) / kSteps - 1);
    sum += window(u) * std::cos(phase * u);
  }
  return sum * 4 / kSteps;
}

/// Number of a wave along a side, -n/2 … n/2 − 1, by its index.
Index wave_of(Index index, Index n) { return index < n / 2 ? index : index - n; }

/// C(k, z) of (2).
double decay(double k, double z, double depth) {
  if (!(k * depth < 20)) return std::exp(k * z);
  return std::cosh(k * (z + depth)) / std::cosh(k * depth);
}

}  // namespace

PeriodicWaves::PeriodicWaves(const PeriodicSquare& square) : square_(square) {
  const Index n = square_.cells;
  zeta_ = MatrixXcd::Zero(n, n);
  for (MatrixXcf& pair : sources_) pair = MatrixXcf::Zero(n, n);
  make_modes();
  make_layers();
}

void PeriodicWaves::make_modes() {
  const Index n = square_.cells;
  const double unit = 2 * M_PI / square_.side(), largest = M_PI / square_.cell;
  omega_.resize(n, n);
  for (MatrixXf& gain : gain_) gain.resize(n, n);
  Eigen::VectorXd spread(n);
  for (Index i = 0; i < n; ++i)
    spread[i] =
        window_transform(2 * M_PI * static_cast<double>(wave_of(i, n)) / static_cast<double>(n));
  for (Index column = 0; column < n; ++column)
    for (Index row = 0; row < n; ++row) {
      const double kx = unit * static_cast<double>(wave_of(column, n));
      const double ky = unit * static_cast<double>(wave_of(row, n));
      const double k = std::hypot(kx, ky);
      omega_(row, column) = k > 0 ? intrinsic_frequency(k, square_.depth, square_.gravity) : 0;
      const bool kept = k > 0 && column != n / 2 && row != n / 2;
      const double filter = kept ? std::exp(-std::pow(k / (0.85 * largest), 8)) : 0;
      const double scale = filter / (spread[row] * spread[column] * square_.cell * square_.cell);
      for (int l = 0; l < kLayers; ++l)
        gain_[l](row, column) =
            static_cast<float>(scale * decay(k, kLayerHeights[l] * square_.deepest, square_.depth));
    }
}

/// Finds c_l over the height: c_0 = 1 − Σ c_l, the rest by least squares in deep water.
void PeriodicWaves::make_layers() {
  constexpr int kWaves = 60;
  const double D = square_.deepest;
  const double lowest = 0.2 / D, highest = std::max(20 / D, M_PI / (2 * square_.cell));
  Eigen::MatrixXd layers(kWaves, kLayers), points(kWaves, kHeights);
  for (int i = 0; i < kWaves; ++i) {
    const double k = lowest * std::pow(highest / lowest, i / (kWaves - 1.0));
    for (int l = 0; l < kLayers; ++l) layers(i, l) = std::exp(k * kLayerHeights[l] * D);
    for (int j = 0; j < kHeights; ++j)
      points(i, j) = std::exp(k * kLayerHeights[kLayers - 1] * D * j / (kHeights - 1));
  }
  const Eigen::MatrixXd others = layers.rightCols<kLayers - 1>().colwise() - layers.col(0);
  shares_.resize(kLayers, kHeights);
  shares_.bottomRows<kLayers - 1>() =
      others.householderQr().solve((points.colwise() - layers.col(0)).eval());
  shares_.row(0) = 1 - shares_.bottomRows<kLayers - 1>().colwise().sum().array();
}

std::array<double, PeriodicWaves::kLayers> PeriodicWaves::shares_at(double z) const {
  const double lowest = kLayerHeights[kLayers - 1] * square_.deepest;
  const double place = std::clamp(z / lowest, 0.0, 1.0) * (kHeights - 1);
  const auto below = std::min(static_cast<Index>(place), Index{kHeights - 2});
  const double part = place - static_cast<double>(below);
  // Below the lowest layer the waves of the length of the square decide.
  const double beyond = z < lowest ? std::exp(2 * M_PI / square_.side() * (z - lowest)) : 1;
  std::array<double, kLayers> shares;
  for (int l = 0; l < kLayers; ++l)
    shares[l] = beyond * ((1 - part) * shares_(l, below) + part * shares_(l, below + 1));
  return shares;
}

/// e^{−iωt} of all wave numbers.
MatrixXcd PeriodicWaves::turn_in(double time) const {
  return (omega_.array() * -time).unaryExpr([](double phase) { return std::polar(1.0, phase); });
}

void PeriodicWaves::advance(double time) {
  if (time == 0) return;
  if (time != turned_for_) turn_ = turn_in(time);
  turned_for_ = time;
  zeta_.array() *= turn_.array();
}

void PeriodicWaves::add_source(double x, double y, double z, double volume) {
  const Index n = square_.cells;
  const auto shares = shares_at(z);
  const double first_x = std::floor(x) - 1, first_y = std::floor(y) - 1;
  std::array<double, 4> along_x, along_y;
  std::array<Index, 4> column, row;
  for (int i = 0; i < 4; ++i) {
    along_x[i] = window(x - first_x - i);
    along_y[i] = window(y - first_y - i);
    column[i] = static_cast<Index>(static_cast<long>(first_x) + i) & (n - 1);
    row[i] = static_cast<Index>(static_cast<long>(first_y) + i) & (n - 1);
  }
  for (int pair = 0; pair < 2; ++pair) {
    const std::complex<float> given(static_cast<float>(volume * shares[2 * pair]),
                                    static_cast<float>(volume * shares[2 * pair + 1]));
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        sources_[pair](row[j], column[i]) += static_cast<float>(along_x[i] * along_y[j]) * given;
  }
}

void PeriodicWaves::take_sources() {
  const Index n = square_.cells;
  for (int pair = 0; pair < 2; ++pair) {
    MatrixXcf& both = sources_[pair];
    transform(both, true);
    const MatrixXf &first = gain_[2 * pair], &second = gain_[2 * pair + 1];
    for (Index column = 0; column < n; ++column)
      for (Index row = 0; row < n; ++row) {
        // Two real fields in one transform: f̂ = (d(k) + d*(−k))/2, ĝ = (d(k) − d*(−k))/2i.
        const std::complex<float> d = both(row, column);
        const std::complex<float> e = std::conj(both(-row & (n - 1), -column & (n - 1)));
        const std::complex<float> f = 0.5f * (d + e), g_i = 0.5f * (d - e);
        const std::complex<float> g(g_i.imag(), -g_i.real());
        zeta_(row, column) += first(row, column) * f + second(row, column) * g;
      }
  }
  for (MatrixXcf& pair : sources_) pair.setZero();
}

void PeriodicWaves::damp(const Eigen::VectorXf& factor_x, const Eigen::VectorXf& factor_y) {
  MatrixXcf field = zeta_.cast<std::complex<float>>();
  transform(field, false);
  field = factor_y.asDiagonal() * field * factor_x.asDiagonal();
  transform(field, true);
  zeta_ = field.cast<std::complex<double>>();
}

MatrixXf PeriodicWaves::elevation(double later) const {
  MatrixXcf field =
      later == 0
          ? MatrixXcf(zeta_.cast<std::complex<float>>())
          : MatrixXcf(
                (zeta_.array() * turn_in(later).array()).matrix().cast<std::complex<float>>());
  transform(field, false);
  return field.real();
}

double PeriodicWaves::energy() const {
  const double n2 = static_cast<double>(zeta_.size());
  return square_.gravity / 2 * square_.side() * square_.side() * zeta_.squaredNorm() / (n2 * n2);
}

}  // namespace hydro

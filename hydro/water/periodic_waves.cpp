#include "hydro/water/periodic_waves.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
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
std::vector<double> layer_heights(int layers) {
  if (layers == 4) return {0, -0.1, -0.5, -1.5};
  return {0, -0.06, -0.27, -0.65, -1.15};
}

/// The window at a distance in cells.
double window(double cells) {
  const double s = cells / 2;
  return s * s < 1 ? std::exp(kWindow * (std::sqrt(1 - s * s) - 1)) : 0;
}

/// Its slope by the cell. At the window's ends, where it is nearly nothing, it is bounded.
double window_slope(double cells) {
  const double s = cells / 2;
  if (s * s >= 1) return 0;
  return -kWindow / 2 * s / std::sqrt(std::max(1 - s * s, 0.04)) * window(cells);
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

/// Slopes of the window along one axis at the 4 cells about a place, by the cell.
std::array<double, 4> window_slopes(double x) {
  std::array<double, 4> slopes;
  const double first = std::floor(x) - 1;
  for (int i = 0; i < 4; ++i) slopes[i] = window_slope(x - first - i);
  return slopes;
}

}  // namespace

PeriodicWaves::PeriodicWaves(const PeriodicSquare& square)
    : square_(square), transform_(square.cells) {
  const Index n = square_.cells;
  zeta_ = MatrixXcd::Zero(n, n);
  for (const double height : layer_heights(square_.layers))
    heights_.push_back(height * square_.deepest);
  sources_.assign((heights_.size() + 1) / 2, MatrixXcf::Zero(n, n));
  make_modes();
  make_layers();
}

void PeriodicWaves::make_modes() {
  const Index n = square_.cells;
  const double unit = 2 * M_PI / square_.side(), largest = M_PI / square_.cell;
  omega_.resize(n, n);
  gain_.assign(heights_.size(), MatrixXf(n, n));
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
      const double scale = filter / (spread[row] * spread[column]);
      for (std::size_t l = 0; l < heights_.size(); ++l)
        gain_[l](row, column) = static_cast<float>(scale * decay(k, heights_[l], square_.depth));
    }
}

/// Finds c_l over the height: c_0 = 1 − Σ c_l, the rest by least squares in deep water, and dc_l/dz
/// in the same way.
void PeriodicWaves::make_layers() {
  constexpr int kWaves = 60;
  const auto count = static_cast<Index>(heights_.size());
  const double D = square_.deepest;
  const double lowest = 0.2 / D, highest = std::min(20 / D, M_PI / square_.cell);
  Eigen::MatrixXd layers(kWaves, count), points(kWaves, kHeights), slopes(kWaves, kHeights);
  for (int i = 0; i < kWaves; ++i) {
    const double k = lowest * std::pow(highest / lowest, i / (kWaves - 1.0));
    for (Index l = 0; l < count; ++l)
      layers(i, l) = std::exp(k * heights_[static_cast<std::size_t>(l)]);
    for (int j = 0; j < kHeights; ++j)
      points(i, j) = std::exp(k * heights_.back() * j / (kHeights - 1));
    slopes.row(i) = k * points.row(i);
  }
  const Eigen::MatrixXd others = layers.rightCols(count - 1).colwise() - layers.col(0);
  const Eigen::HouseholderQR<Eigen::MatrixXd> fit(others);
  const auto shares_of = [&](const Eigen::MatrixXd& wanted, double sum) {
    Eigen::MatrixXd shares(count, kHeights);
    shares.bottomRows(count - 1) = fit.solve((wanted.colwise() - sum * layers.col(0)).eval());
    shares.row(0) = sum - shares.bottomRows(count - 1).colwise().sum().array();
    return shares;
  };
  shares_ = shares_of(points, 1);
  slopes_ = shares_of(slopes, 0);
}

PeriodicWaves::Shares PeriodicWaves::look_up(const Eigen::MatrixXd& table, double z) const {
  const double lowest = heights_.back();
  const double place = std::clamp(z / lowest, 0.0, 1.0) * (kHeights - 1);
  const auto below = std::min(static_cast<Index>(place), Index{kHeights - 2});
  const double part = place - static_cast<double>(below);
  // Below the lowest layer the waves of the length of the square decide.
  const double beyond = z < lowest ? std::exp(2 * M_PI / square_.side() * (z - lowest)) : 1;
  Shares found{};
  for (Index l = 0; l < table.rows(); ++l)
    found[static_cast<std::size_t>(l)] =
        beyond * ((1 - part) * table(l, below) + part * table(l, below + 1));
  return found;
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

/// The 4 × 4 cells about a place, and the window there.
struct PeriodicWaves::Cells {
  std::array<Index, 4> column, row;
  std::array<double, 4> along_x, along_y;
};

PeriodicWaves::Cells PeriodicWaves::cells_about(double x, double y) const {
  const Index n = square_.cells;
  const double first_x = std::floor(x) - 1, first_y = std::floor(y) - 1;
  Cells cells;
  for (int i = 0; i < 4; ++i) {
    cells.along_x[i] = window(x - first_x - i);
    cells.along_y[i] = window(y - first_y - i);
    cells.column[i] = static_cast<Index>(static_cast<long>(first_x) + i) & (n - 1);
    cells.row[i] = static_cast<Index>(static_cast<long>(first_y) + i) & (n - 1);
  }
  return cells;
}

void PeriodicWaves::add_source(double x, double y, double z, double volume) {
  const Shares shares = shares_at(z);
  const Cells cells = cells_about(x, y);
  for (std::size_t pair = 0; pair < sources_.size(); ++pair) {
    const double second = 2 * pair + 1 < heights_.size() ? shares[2 * pair + 1] : 0;
    const std::complex<float> given(static_cast<float>(volume * shares[2 * pair]),
                                    static_cast<float>(volume * second));
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        sources_[pair](cells.row[j], cells.column[i]) +=
            static_cast<float>(cells.along_x[i] * cells.along_y[j]) * given;
  }
}

/// Finds `raised_` by the noted sources, which are forgotten.
void PeriodicWaves::transform_sources() {
  const Index n = square_.cells;
  raised_.setZero(n, n);
  const auto scale = static_cast<float>(0.5 / (square_.cell * square_.cell));
  for (std::size_t pair = 0; pair < sources_.size(); ++pair) {
    MatrixXcf& both = sources_[pair];
    transform_.forward(both, other_);
    // Two real fields f and g in one transform d: f̂ = (d(k) + d*(−k))/2, ĝ = (d(k) − d*(−k))/2i.
    // An odd last one has none beside it.
    const MatrixXf& first = gain_[2 * pair];
    const MatrixXf* second = 2 * pair + 1 < gain_.size() ? &gain_[2 * pair + 1] : nullptr;
    for (Index column = 0; column <= n / 2; ++column)
      for (Index row = 0; row < n; ++row) {
        const std::complex<float> d = both(row, column);
        const std::complex<float> e = std::conj(both(-row & (n - 1), -column & (n - 1)));
        const std::complex<float> f = d + e, g = d - e;
        std::complex<float> sum = first(row, column) * f;
        if (second) sum += (*second)(row, column) * std::complex<float>(g.imag(), -g.real());
        raised_(row, column) += scale * sum;
      }
    both.setZero();
  }
  for (Index column = n / 2 + 1; column < n; ++column)
    for (Index row = 0; row < n; ++row)
      raised_(row, column) = std::conj(raised_(-row & (n - 1), n - column));
}

void PeriodicWaves::take_sources() {
  transform_sources();
  zeta_ += raised_.cast<std::complex<double>>();
}

void PeriodicWaves::drop_sources() {
  for (MatrixXcf& pair : sources_) pair.setZero();
}

void PeriodicWaves::read_sources(FieldBelow& field) {
  transform_sources();
  const auto factor = [&](double omega) {
    return std::complex<float>(
        1, omega > 0 ? static_cast<float>(square_.gravity / (omega * omega)) : 0);
  };
  field.transform_ = raised_.array() * omega_.unaryExpr(factor).array();
  find_layers(field);
}

/// η̂ + iψ̂
void PeriodicWaves::find_raise_and_potential(MatrixXcf& transform) const {
  const Index n = square_.cells;
  transform.resize(n, n);
  for (Index column = 0; column < n; ++column)
    for (Index row = 0; row < n; ++row) {
      const double omega = omega_(row, column), s = omega > 0 ? square_.gravity / omega : 0;
      const std::complex<double> mirrored = std::conj(zeta_(-row & (n - 1), -column & (n - 1)));
      transform(row, column) =
          std::complex<float>(0.5 * ((1 + s) * zeta_(row, column) + (1 - s) * mirrored));
    }
}

/// Subtracts (V·∇)φ/g from the elevation. With d = η̂ + iψ̂ at k and the conjugate e at −k, ψ̂ = (d
/// − e)/2i.
void PeriodicWaves::take_advance(const Eigen::Vector2d& velocity, MatrixXcf& transform) const {
  const Index n = square_.cells;
  const Eigen::Vector2d by_g = 2 * M_PI / square_.side() / square_.gravity * velocity;
  const MatrixXcf given = transform;
  for (Index column = 0; column < n; ++column)
    for (Index row = 0; row < n; ++row) {
      const double along = by_g.x() * static_cast<double>(wave_of(column, n)) +
                           by_g.y() * static_cast<double>(wave_of(row, n));
      const std::complex<float> mirrored = std::conj(given(-row & (n - 1), -column & (n - 1)));
      transform(row, column) -= static_cast<float>(along / 2) * (given(row, column) - mirrored);
    }
}

void PeriodicWaves::read(FieldBelow& field, const Eigen::Vector2d& velocity) const {
  find_raise_and_potential(field.transform_);
  if (!velocity.isZero(0)) take_advance(velocity, field.transform_);
  find_layers(field);
}

void PeriodicWaves::find_layers(FieldBelow& field) const {
  field.waves_ = this;
  field.layers_.resize(gain_.size());
  for (std::size_t l = 0; l < gain_.size(); ++l) {
    field.layers_[l] = gain_[l].cwiseProduct(field.transform_);
    transform_.inverse(field.layers_[l], field.other_);
  }
}

FieldBelow::Sample FieldBelow::at(double x, double y, double z) const {
  const PeriodicWaves::Cells cells = waves_->cells_about(x, y);
  const std::array<double, 4> slope_x = window_slopes(x), slope_y = window_slopes(y);
  const PeriodicWaves::Shares shares = waves_->shares_at(z), slopes = waves_->slopes_at(z);
  Sample sample;
  for (std::size_t l = 0; l < layers_.size(); ++l) {
    std::complex<double> value = 0, by_x = 0, by_y = 0;
    for (int i = 0; i < 4; ++i) {
      std::complex<double> along = 0, across = 0;
      for (int j = 0; j < 4; ++j) {
        const std::complex<double> cell(layers_[l](cells.row[j], cells.column[i]));
        along += cells.along_y[j] * cell;
        across += slope_y[j] * cell;
      }
      value += cells.along_x[i] * along;
      by_x += slope_x[i] * along;
      by_y += cells.along_x[i] * across;
    }
    sample.value += shares[l] * value;
    sample.slope += Eigen::Vector3cd(shares[l] * by_x / waves_->square_.cell,
                                     shares[l] * by_y / waves_->square_.cell, slopes[l] * value);
  }
  return sample;
}

void PeriodicWaves::damp(const MatrixXf& factor) {
  const Index n = square_.cells;
  find_raise_and_potential(field_);
  transform_.inverse(field_, other_);
  field_.array() *= factor.array();
  transform_.forward(field_, other_);
  for (Index column = 0; column < n; ++column)
    for (Index row = 0; row < n; ++row) {
      const std::complex<double> d(field_(row, column));
      const std::complex<double> e(std::conj(field_(-row & (n - 1), -column & (n - 1))));
      zeta_(row, column) = 0.5 * (d + e + omega_(row, column) / square_.gravity * (d - e));
    }
}

MatrixXf PeriodicWaves::elevation(double later) const {
  MatrixXcf field =
      later == 0
          ? MatrixXcf(zeta_.cast<std::complex<float>>())
          : MatrixXcf(
                (zeta_.array() * turn_in(later).array()).matrix().cast<std::complex<float>>());
  MatrixXcf other;
  transform_.inverse(field, other);
  return field.real();
}

double PeriodicWaves::energy() const {
  const double n2 = static_cast<double>(zeta_.size());
  return square_.gravity / 2 * square_.side() * square_.side() * zeta_.squaredNorm() / (n2 * n2);
}

}  // namespace hydro

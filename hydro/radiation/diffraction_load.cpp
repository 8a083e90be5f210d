#include "hydro/radiation/diffraction_load.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hydro/airy_waves.h"

namespace hydro {
namespace {

using Complex = std::complex<double>;

/// Harmonics whose loads stay below this part of the largest are left out [-]; moments count by
/// their product with the wave number. Panels know the load to some 1e-3.
constexpr double kLeastHarmonic = 1e-6;

constexpr double kHeadingRoundOff = 1e-6;  ///< [rad]

/// Real and imaginary part of a load, one above the other, for each of 1, cos ψ, sin ψ, cos 2ψ …
using HeadingTable = Eigen::Matrix<double, 12, Eigen::Dynamic>;

/// Real and imaginary part of a load, one above the other.
using Part = Eigen::Matrix<double, 12, 1>;

/// 1, cos ψ, sin ψ, cos 2ψ … and their derivatives by ψ.
using Harmonics = Eigen::Matrix<double, Eigen::Dynamic, 2>;

Part times_i(const Part& X) {
  Part product;
  product << -X.tail<6>(), X.head<6>();
  return product;
}

/// @param count   Odd.
Harmonics harmonics_of(double heading, Eigen::Index count) {
  Harmonics harmonics(count, 2);
  harmonics.row(0) << 1, 0;
  const Complex turn = std::polar(1.0, heading);
  Complex power = 1;
  for (Eigen::Index i = 1; i < count; i += 2) {
    power *= turn;
    const auto m = static_cast<double>((i + 1) / 2);
    harmonics.row(i) << power.real(), -m * power.imag();
    harmonics.row(i + 1) << power.imag(), m * power.real();
  }
  return harmonics;
}

void check_diffraction(const RadiationData& data) {
  const std::size_t n = data.headings.size();
  for (std::size_t j = 0; j < n; ++j) {
    const double expected = 2 * M_PI * static_cast<double>(j) / static_cast<double>(n);
    if (!(std::abs(data.headings[j] - expected) <= kHeadingRoundOff))
      throw std::invalid_argument(
          "the headings of the diffraction must divide the whole circle evenly from 0");
  }
  if (n == 0) return;
  if (data.frequencies.empty() || data.diffraction.size() != data.frequencies.size())
    throw std::invalid_argument("the diffraction must have one load for each frequency");
  for (const Loads6cd& loads : data.diffraction)
    if (loads.cols() != static_cast<Eigen::Index>(n))
      throw std::invalid_argument("the diffraction must have one load for each heading");
}

/// Returns the trigonometric series through loads at even headings from 0. With an even number of
/// them the last harmonic is shared by +M and −M.
Loads6cd fourier_series(const Loads6cd& loads) {
  const Eigen::Index n = loads.cols(), most = n / 2;
  Loads6cd series = Loads6cd::Zero(6, 2 * most + 1);
  for (Eigen::Index m = -most; m <= most; ++m) {
    const double weight = 2 * std::abs(m) == n ? 0.5 : 1;
    for (Eigen::Index j = 0; j < n; ++j) {
      // The product is taken modulo n, so that the angle is exact.
      const double angle = -2 * M_PI * static_cast<double>(m * j % n) / static_cast<double>(n);
      series.col(m + most) +=
          weight / static_cast<double>(n) * std::polar(1.0, angle) * loads.col(j);
    }
  }
  return series;
}

/// Slopes at points x of the parabolas through three neighbours each; those at the ends are of the
/// parabola through the last three.
std::vector<Loads6cd> parabolic_slopes(const std::vector<double>& x,
                                       const std::vector<Loads6cd>& y) {
  const std::size_t n = x.size();
  std::vector<Loads6cd> slopes(n, Loads6cd::Zero(6, y.empty() ? 0 : y.front().cols()));
  if (n < 2) return slopes;
  const auto chord = [&](std::size_t i) -> Loads6cd {
    return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  };
  if (n == 2) {
    slopes[0] = slopes[1] = chord(0);
    return slopes;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
    slopes[i] = (right * chord(i - 1) + left * chord(i)) / (left + right);
  }
  slopes[0] = 2 * chord(0) - slopes[1];
  slopes[n - 1] = 2 * chord(n - 2) - slopes[n - 2];
  return slopes;
}

/// Returns X(β − ψ) as a table over ψ, without the last harmonics that do not count.
/// @param k   Weight of the moments [rad/m].
HeadingTable heading_table(const Loads6cd& series, double heading, double k) {
  const Eigen::Index middle = series.cols() / 2;
  Vector6d weight;
  weight << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(k);
  const Eigen::MatrixXd size = weight.asDiagonal() * series.cwiseAbs();
  const double least = kLeastHarmonic * size.maxCoeff();
  Eigen::Index most = middle;
  while (most > 0 && size.col(middle - most).maxCoeff() <= least &&
         size.col(middle + most).maxCoeff() <= least)
    --most;
  HeadingTable table(12, 2 * most + 1);
  const auto set = [&](Eigen::Index column, const Vector6cd& load) {
    table.col(column) << load.real(), load.imag();
  };
  set(0, series.col(middle));
  for (Eigen::Index m = 1; m <= most; ++m) {
    const Complex turn = std::polar(1.0, static_cast<double>(m) * heading);
    const Vector6cd plus = turn * series.col(middle + m);
    const Vector6cd minus = std::conj(turn) * series.col(middle - m);
    set(2 * m - 1, plus + minus);
    set(2 * m, Complex(0, -1) * (plus - minus));
  }
  return table;
}

}  // namespace

/// The coefficients of one sea, in a list.
struct DiffractionLoad::Waves {
  std::vector<Eigen::Vector2d> wave_vectors;  ///< Wave vectors of all components [rad/m].
  std::vector<double> frequencies;            ///< σ of all components; 0 without a wave [rad/s].
  double depth, gravity;
  std::vector<HeadingTable> tables;  ///< X_D of the components; without columns where it is zero.
  Eigen::Index columns = 1;          ///< Columns of the largest table.
  std::unique_ptr<const Waves> next;

  bool are_of(const Sea& sea, const std::vector<WaveComponent>& components) const {
    if (depth != sea.depth || gravity != sea.gravity || wave_vectors.size() != components.size())
      return false;
    for (std::size_t i = 0; i < components.size(); ++i)
      if (wave_vectors[i].x() != components[i].kx || wave_vectors[i].y() != components[i].ky)
        return false;
    return true;
  }
};

DiffractionLoad::DiffractionLoad(const RadiationData& data) : water_(data.water) {
  check_diffraction(data);
  if (data.headings.empty()) return;
  frequencies_ = data.frequencies;
  for (std::size_t i = 0; i < frequencies_.size(); ++i) {
    const double k = wave_number(frequencies_[i], water_.depth, water_.gravity).value();
    over_k_.push_back(fourier_series(data.diffraction[i]) / k);
  }
  slopes_ = parabolic_slopes(frequencies_, over_k_);
}

DiffractionLoad::~DiffractionLoad() { delete known_.load(); }

DiffractionLoad::Series DiffractionLoad::below_lowest(double k) const {
  if (frequencies_.size() < 2) return over_k_[0];
  const auto k_of = [&](std::size_t i) {
    return wave_number(frequencies_[i], water_.depth, water_.gravity).value();
  };
  return over_k_[0] + (k - k_of(0)) / (k_of(1) - k_of(0)) * (over_k_[1] - over_k_[0]);
}

DiffractionLoad::Series DiffractionLoad::series_at(double frequency, double k) const {
  const auto above = std::upper_bound(frequencies_.begin(), frequencies_.end(), frequency);
  if (above == frequencies_.begin()) return k * below_lowest(k);
  if (above == frequencies_.end()) {
    const double last = wave_number(frequencies_.back(), water_.depth, water_.gravity).value();
    return last * std::pow(last / k, 2) * over_k_.back();
  }
  const auto i = static_cast<std::size_t>(above - frequencies_.begin()) - 1;
  const double h = frequencies_[i + 1] - frequencies_[i];
  const double t = (frequency - frequencies_[i]) / h, s = 1 - t;
  return k * (s * s * (1 + 2 * t) * over_k_[i] + t * t * (1 + 2 * s) * over_k_[i + 1] +
              h * s * t * (s * slopes_[i] - t * slopes_[i + 1]));
}

Vector6cd DiffractionLoad::coefficients(double frequency, double heading) const {
  Vector6cd load = Vector6cd::Zero();
  if (frequencies_.empty()) return load;
  const double k = wave_number(frequency, water_.depth, water_.gravity).value();
  const Series series = series_at(frequency, k);
  const Eigen::Index most = series.cols() / 2;
  for (Eigen::Index m = -most; m <= most; ++m)
    load += std::polar(1.0, static_cast<double>(m) * heading) * series.col(m + most);
  return load;
}

const DiffractionLoad::Waves& DiffractionLoad::waves_of(const Sea& sea) const {
  const auto& components = std::get<WaveSurface>(sea.surface).components;
  const auto known = [&]() -> const Waves* {
    for (const Waves* w = known_.load(std::memory_order_acquire); w; w = w->next.get())
      if (w->are_of(sea, components)) return w;
    return nullptr;
  };
  if (const Waves* w = known()) return *w;
  const std::lock_guard lock(making_);
  if (const Waves* w = known()) return *w;  // Another thread has made them meanwhile.
  auto waves = std::make_unique<Waves>();
  waves->depth = sea.depth;
  waves->gravity = sea.gravity;
  for (const WaveComponent& c : components) {
    const double k = std::hypot(c.kx, c.ky);
    waves->wave_vectors.emplace_back(c.kx, c.ky);
    waves->tables.emplace_back(12, 0);
    waves->frequencies.push_back(0);
    if (k == 0) continue;
    const double sigma = intrinsic_frequency(k, sea.depth, sea.gravity);
    waves->frequencies.back() = sigma;
    waves->tables.back() = heading_table(series_at(sigma, k), std::atan2(c.ky, c.kx), k);
    waves->columns = std::max(waves->columns, waves->tables.back().cols());
  }
  waves->next.reset(known_.load(std::memory_order_relaxed));
  known_.store(waves.get(), std::memory_order_release);
  return *waves.release();
}

Wrench DiffractionLoad::at(const Eigen::Vector3d& position, const Twist& motion,
                           const WaveFrame& frame, const Sea& sea, double time) const {
  const Eigen::Vector3d v = motion.at(frame.origin);
  return sum(position, frame, sea, time,
             [&](const WaveComponent& w, double sigma, const Part& X, const Part& slope) {
               const double met = (w.omega - w.kx * v.x() - w.ky * v.y()) / sigma;
               return Part(met * X + motion.angular.z() / sigma * times_i(slope));
             });
}

Wrench DiffractionLoad::momentum(const Eigen::Vector3d& position, const WaveFrame& frame,
                                 const Sea& sea, double time) const {
  return sum(position, frame, sea, time,
             [](const WaveComponent&, double sigma, const Part& X, const Part&) {
               return Part(-1 / sigma * times_i(X));
             });
}

template <typename Coefficient>
Wrench DiffractionLoad::sum(const Eigen::Vector3d& position, const WaveFrame& frame, const Sea& sea,
                            double time, const Coefficient& coefficient) const {
  if (frequencies_.empty() || !has_airy_waves(sea)) return {};
  const auto& surface = std::get<WaveSurface>(sea.surface);
  const Waves& waves = waves_of(sea);
  const Eigen::Vector3d origin = position + frame.origin;
  const Harmonics harmonics = harmonics_of(frame.heading(), waves.columns);
  Vector6d load = Vector6d::Zero();
  for (std::size_t i = 0; i < surface.components.size(); ++i) {
    const WaveComponent& w = surface.components[i];
    const HeadingTable& table = waves.tables[i];
    if (w.amplitude == 0 || table.cols() == 0) continue;
    const double theta =
        w.kx * origin.x() + w.ky * origin.y() + std::remainder(w.phase - w.omega * time, 2 * M_PI);
    const Eigen::Matrix<double, 12, 2> X = table.lazyProduct(harmonics.topRows(table.cols()));
    const Part c = coefficient(w, waves.frequencies[i], X.col(0), X.col(1));
    load += w.amplitude * (std::cos(theta) * c.head<6>() - std::sin(theta) * c.tail<6>());
  }
  load *= sea.density * amplitude_factor(surface, time);
  const Vector6d load_W = frame.load_out(load);
  return {load_W.head<3>(), load_W.tail<3>()};
}

ScatteredWaves scattered_waves(const RadiationData& data, const Sea& sea) {
  if (!has_airy_waves(sea)) return {};
  const auto waves = std::make_shared<const DiffractionLoad>(data);
  return {
      .load =
          [waves](const BodyState& state, const WaveFrame& frame, const Sea& water, double time) {
            return waves->at(state.position, {state.linear_velocity, state.angular_velocity}, frame,
                             water, time);
          },
      .momentum = [waves](
                      const BodyState& state, const WaveFrame& frame, const Sea& water,
                      double time) { return waves->momentum(state.position, frame, water, time); }};
}

}  // namespace hydro

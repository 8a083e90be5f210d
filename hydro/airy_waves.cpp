#include "hydro/airy_waves.h"

#include <algorithm>
#include <cmath>

#include "hydro/wave_sums.h"

namespace hydro {
namespace {

/// Newton steps that a wave number may take: three are enough without a current, and some ten for a
/// wave that the current almost stops.
constexpr int kMostNewtonSteps = 60;

/// Waves feel no bottom at this kh: 1 − tanh kh is below round-off.
constexpr double kDeep = 20;

struct Dispersion {
  double sigma;           ///< [rad/s]
  double group_velocity;  ///< dσ/dk [m/s].
};

Dispersion dispersion(double k, double depth, double gravity) {
  const double kh = k * depth;
  if (!(kh < kDeep)) {
    const double sigma = std::sqrt(gravity * k);
    return {sigma, sigma / (2 * k)};
  }
  const double t = std::tanh(kh);
  const double sigma = std::sqrt(gravity * k * t);
  return {sigma, gravity * (t + kh * (1 - t * t)) / (2 * sigma)};
}

/// A wave number near that of (1) without current, from below 1 % [G02].
///
/// [G02] Guo. Simple and explicit solution of wave dispersion equation. Coastal Eng. 45 (2002)
///       71-74.
double near_wave_number(double frequency, double depth, double gravity) {
  const double deep = frequency * frequency / gravity;
  const double alpha = deep * depth;
  if (!(alpha < kDeep)) return deep;
  return alpha / depth * std::pow(-std::expm1(-std::pow(alpha, 1.25)), -0.4);
}

/// Depth at which the functions of depth are taken, by Wheeler's stretching.
/// @param elevation   Elevation of the surface that is s above the place [m].
double stretched(double depth, double elevation, double s) {
  const double below = std::max(s, 0.0);
  if (!(depth < AiryWaves::kDeepest)) return below;
  return std::min(depth, below * depth / std::max(depth + elevation, 1e-300));
}

bool has_many_waves(const Sea& sea) {
  return has_airy_waves(sea) &&
         std::get<WaveSurface>(sea.surface).components.size() >= kFewestWavesInLanes;
}

}  // namespace

double intrinsic_frequency(double wave_number, double depth, double gravity) {
  return dispersion(wave_number, depth, gravity).sigma;
}

std::optional<double> wave_number(double frequency, double depth, double gravity, double along) {
  // σ(k) is concave: Newton's method comes from below after its first step, and stays there.
  double k = near_wave_number(frequency, depth, gravity);
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    const Dispersion d = dispersion(k, depth, gravity);
    const double slope = d.group_velocity + along;
    const double step = (frequency - d.sigma - k * along) / slope;
    if (!(slope > 0) || !std::isfinite(step)) break;
    k += step;
    if (std::abs(step) <= 4e-16 * k) return k;
  }
  const bool near =
      std::abs(intrinsic_frequency(k, depth, gravity) + k * along - frequency) <= 1e-12 * frequency;
  return near ? std::optional(k) : std::nullopt;
}

WaveComponent linear_wave(const Sea& sea, double amplitude, double wave_number, double heading,
                          double phase) {
  const double kx = wave_number * std::cos(heading), ky = wave_number * std::sin(heading);
  return {.amplitude = amplitude,
          .kx = kx,
          .ky = ky,
          .omega = intrinsic_frequency(wave_number, sea.depth, sea.gravity) + kx * sea.current.x() +
                   ky * sea.current.y(),
          .phase = phase};
}

WaveComponent deep_water_wave(double amplitude, double wavelength, double heading, double phase,
                              double gravity) {
  return linear_wave({.gravity = gravity}, amplitude, 2 * M_PI / wavelength, heading, phase);
}

bool has_airy_waves(const Sea& sea) {
  const auto* waves = std::get_if<WaveSurface>(&sea.surface);
  return waves && waves->kinematics == Kinematics::airy;
}

AiryWaves::AiryWaves(const Sea& sea, double time)
    : depth_(sea.depth),
      gravity_(sea.gravity),
      level_(sea.level),
      current_(sea.current),
      profile_(sea.profile) {
  if (!has_airy_waves(sea)) return;
  const auto& surface = std::get<WaveSurface>(sea.surface);
  const double factor = amplitude_factor(surface, time);
  for (const WaveComponent& w : surface.components) {
    const double k = wave_number(w);
    if (w.amplitude == 0 || k == 0) continue;
    waves_.push_back({.amplitude = factor * w.amplitude,
                      .k = k,
                      .kx = w.kx,
                      .ky = w.ky,
                      .phase = std::remainder(w.phase - w.omega * time, 2 * M_PI),
                      .velocity_scale = sea.gravity / intrinsic_frequency(k, depth_, sea.gravity),
                      .weight = deep() ? 1 : 1 / (1 + std::exp(-2 * k * depth_))});
  }
}

Eigen::Vector3d AiryWaves::current(double z) const {
  if (profile_.empty()) return current_;
  const Eigen::Vector2d velocity = velocity_at(profile_, level_ - z);
  return {velocity.x(), velocity.y(), 0};
}

void AiryWaves::add(const Wave& w, const Eigen::Vector3d& p_W, double down, double factor,
                    WaterMotion& water) const {
  const double theta = w.kx * p_W.x() + w.ky * p_W.y() + w.phase;
  const double sine = std::sin(theta), cosine = std::cos(theta);
  const double falls = std::exp(-w.k * down);
  const double rises = deep() ? 0 : std::exp(w.k * (down - 2 * depth_));
  const double C = w.weight * (falls + rises), S = w.weight * (falls - rises);
  const Eigen::Vector3d along(w.kx * C, w.ky * C, 0);
  const Eigen::Vector3d up(0, 0, w.k * S);
  const double a = factor * w.amplitude;
  water.head -= a * (1 - C) * cosine;
  water.velocity += a * w.velocity_scale * (cosine * along + sine * up);
  water.acceleration += a * gravity_ * (sine * along - cosine * up);
}

WaterMotion AiryWaves::at(const Eigen::Vector3d& p_W, double s) const {
  WaterMotion water{.head = s, .velocity = current(p_W.z())};
  const double down = stretched(depth_, s + (p_W.z() - level_), s);
  for (const Wave& w : waves_) add(w, p_W, down, 1, water);
  return water;
}

Eigen::Vector3d AiryWaves::mean_velocity(const Eigen::Vector3d& p_W, double s,
                                         const Eigen::Matrix3d& half_sides) const {
  WaterMotion water{.velocity = current(p_W.z())};
  const double down = stretched(depth_, s + (p_W.z() - level_), s);
  for (const Wave& w : waves_) {
    double mean = 1;  // Mean of cos(k·δ) over the box.
    for (int i = 0; i < 3; ++i) {
      const double turn = w.kx * half_sides(0, i) + w.ky * half_sides(1, i);
      if (turn != 0) mean *= std::sin(turn) / turn;
    }
    add(w, p_W, down, mean, water);
  }
  return water.velocity;
}

WaterMotion water_at(const Sea& sea, const Eigen::Vector3d& p_W, double time) {
  const double rise = surface_elevation(sea, p_W.x(), p_W.y(), time);
  const double s = rise + (sea.level - p_W.z());
  if (!has_many_waves(sea)) return AiryWaves(sea, time).at(p_W, s);
  const double down = stretched(sea.depth, rise, s);
  WaterMotion water = airy_waves_in_lanes(sea, p_W, down, nullptr, time);
  water.head += s;
  water.velocity += current_at(sea, p_W.z());
  return water;
}

Eigen::Vector3d mean_velocity(const Sea& sea, const Eigen::Vector3d& p_W, double s,
                              const Eigen::Matrix3d& half_sides, double time) {
  if (!has_many_waves(sea)) return AiryWaves(sea, time).mean_velocity(p_W, s, half_sides);
  const double down = stretched(sea.depth, s + (p_W.z() - sea.level), s);
  return current_at(sea, p_W.z()) + airy_waves_in_lanes(sea, p_W, down, &half_sides, time).velocity;
}

}  // namespace hydro

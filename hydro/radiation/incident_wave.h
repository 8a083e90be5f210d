#pragma once

#include <cmath>

#include "hydro/airy_waves.h"
#include "hydro/radiation/radiation_data.h"

/// @file
/// The regular wave that excites a body in linear theory.

namespace hydro {

/// A wave of the amplitude 1 m in water at rest.
struct IncidentWave {
  double omega;    ///< ω [rad/s]
  double k;        ///< [rad/m]
  double gravity;  ///< [m/s^2]
  double depth;    ///< [m]

  /// @param frequency   ω, > 0 [rad/s].
  IncidentWave(double frequency, const LinearWater& water)
      : omega(frequency), gravity(water.gravity), depth(water.depth) {
    k = std::isfinite(depth) ? wave_number(omega, depth, gravity).value() : deep_wave_number();
  }

  double deep_wave_number() const { return omega * omega / gravity; }
  /// C(z) of airy_waves.h at a depth below the surface [-].
  double head(double down) const {
    return std::exp(-k * down) * (1 + of_bottom(down)) / (1 + of_bottom(0));
  }
  /// S/C: the largest vertical velocity over the largest horizontal one there [-].
  double rise(double down) const { return (1 - of_bottom(down)) / (1 + of_bottom(down)); }
  /// Group velocity in deep water over that here [-].
  double deep_group_velocity() const {
    const double kh = k * depth;
    return std::isfinite(depth) ? 1 / (std::tanh(kh) + kh / std::pow(std::cosh(kh), 2)) : 1;
  }

 private:
  double of_bottom(double down) const { return std::exp(-2 * k * (depth - down)); }
};

}  // namespace hydro

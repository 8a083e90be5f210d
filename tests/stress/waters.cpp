#include "tests/stress/waters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hydro/wave_spectrum.h"
#include "tests/support/random_pose.h"

namespace stress {
namespace {

using hydro::Sea;

/// Adds a wave of given length and steepness kA; waves break above 0.44.
void add_wave(Sea& sea, double length, double steepness) {
  const double amplitude = steepness * length / (2 * std::numbers::pi);
  sea.surface =
      hydro::WaveSurface{{hydro::deep_water_wave(amplitude, length, 0.4, 1.0, sea.gravity)}};
}

void add_jonswap(Sea& sea, double size) {
  const double length = 10 * size;
  const hydro::JonswapSpectrum spectrum{
      .significant_height = length / 20,
      .peak_period = std::sqrt(2 * std::numbers::pi * length / sea.gravity),
      .spreading = 10};
  sea.surface = hydro::jonswap_sea(spectrum, sea);
}

void add_bumps(Sea& sea, double size) {
  support::Random random(3);
  Eigen::MatrixXd heights(21, 21);
  for (double& height : heights.reshaped()) height = random.uniform(-0.3, 0.3) * size;
  sea.surface = hydro::make_height_field(heights, size, {-10 * size, -10 * size});
}

/// Makes a surface that rises by the body's size within a tenth of it.
void add_cliff(Sea& sea, double size) {
  Eigen::MatrixXd heights = Eigen::MatrixXd::Zero(1, 2);
  heights(0, 1) = size;
  sea.surface = hydro::make_height_field(heights, 0.1 * size, {0.2 * size, 0});
}

}  // namespace

Sea make_water(const std::string& name, double size) {
  Sea sea;
  if (name == "current")
    sea.current = {3, 1, 0};
  else if (name == "swell")
    add_wave(sea, 20 * size, 0.06);
  else if (name == "steep")
    add_wave(sea, 10 * size, 0.4);
  else if (name == "breaking")
    add_wave(sea, 5 * size, 0.9);
  else if (name == "short")
    add_wave(sea, 0.4 * size, 0.3);
  else if (name == "jonswap")
    add_jonswap(sea, size);
  else if (name == "bumps")
    add_bumps(sea, size);
  else if (name == "cliff")
    add_cliff(sea, size);
  else if (name != "flat")
    throw std::invalid_argument(fmt::format("'{}' is no water", name));
  return sea;
}

double fastest(const Sea& sea) {
  double speed = sea.current.norm();
  if (const auto* waves = std::get_if<hydro::WaveSurface>(&sea.surface))
    for (const hydro::WaveComponent& wave : waves->components)
      speed = std::max(speed, wave.omega / std::hypot(wave.kx, wave.ky));
  return speed;
}

}  // namespace stress

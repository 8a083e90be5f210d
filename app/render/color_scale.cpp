#include "app/render/color_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace render {
namespace {

using Polynomial = std::array<double, 6>;

constexpr Polynomial kRed = {0.13572138,   4.61539260,    -42.66032258,
                             132.13108234, -152.94239396, 59.28637943};
constexpr Polynomial kGreen = {0.09140261,   2.19418839, 4.84296658,
                               -14.18503333, 4.27729857, 2.82956604};
constexpr Polynomial kBlue = {0.10667330,   12.64194608,  -60.58204836,
                              110.36276771, -89.90310912, 27.34824973};

constexpr double kTurboFirst = 0.09;
constexpr double kTurboLast = 0.92;

std::uint8_t channel(const Polynomial& coefficients, double x) {
  double value = 0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) value = value * x + *c;
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

std::array<Rgb, kScaleColors> make_colors() {
  std::array<Rgb, kScaleColors> colors;
  for (int i = 0; i < kScaleColors; ++i) {
    const double x = kTurboFirst + (kTurboLast - kTurboFirst) * i / (kScaleColors - 1);
    colors[static_cast<std::size_t>(i)] = {channel(kRed, x), channel(kGreen, x), channel(kBlue, x)};
  }
  return colors;
}

/// The largest of 1, 2, 5 times a power of ten that divides `range` in at least three.
double round_step(double range) {
  const double power = std::pow(10.0, std::floor(std::log10(range / 3)));
  for (const double factor : {5.0, 2.0})
    if (range / (factor * power) >= 3 - 1e-9) return factor * power;
  return power;
}

}  // namespace

const std::array<Rgb, kScaleColors>& scale_colors() {
  static const std::array<Rgb, kScaleColors> colors = make_colors();
  return colors;
}

Rgb scale_color(const PressureScale& scale, double pressure) {
  const double place = std::clamp((pressure - scale.min) / (scale.max - scale.min), 0.0, 1.0);
  return scale_colors()[static_cast<std::size_t>(std::lround(place * (kScaleColors - 1)))];
}

std::vector<Tick> round_ticks(const PressureScale& scale) {
  const double low = scale.min / 1000, range = (scale.max - scale.min) / 1000;
  const double step = round_step(range);
  // Half a thousandth of a step lets an end that is itself round keep its tick.
  const double slack = 5e-4;
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::vector<Tick> ticks;
  for (double i = std::ceil(low / step - slack); i * step <= low + range + slack * step; ++i) {
    const double value = i == 0 ? 0 : i * step;
    ticks.push_back({.place = std::clamp((value - low) / range, 0.0, 1.0),
                     .label = fmt::format("{:.{}f}", value, decimals)});
  }
  return ticks;
}

}  // namespace render

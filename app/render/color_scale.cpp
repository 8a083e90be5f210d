#include "app/render/color_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace render {
namespace {

using Colors = std::array<Rgb, kScaleColors>;
using Polynomial = std::array<double, 6>;

constexpr Polynomial kRed = {0.13572138,   4.61539260,    -42.66032258,
                             132.13108234, -152.94239396, 59.28637943};
constexpr Polynomial kGreen = {0.09140261,   2.19418839, 4.84296658,
                               -14.18503333, 4.27729857, 2.82956604};
constexpr Polynomial kBlue = {0.10667330,   12.64194608,  -60.58204836,
                              110.36276771, -89.90310912, 27.34824973};

constexpr double kTurboFirst = 0.09;
constexpr double kTurboLast = 0.92;

// Colours at equal intervals, 0xRRGGBB.
constexpr std::array kViridis = {
    0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453781, 0x424086, 0x3e4989, 0x3b528b,
    0x375b8d, 0x33638d, 0x2f6b8e, 0x2c728e, 0x297a8e, 0x26828e, 0x23898e, 0x21918c, 0x1f988b,
    0x1fa088, 0x22a785, 0x28ae80, 0x32b67a, 0x3fbc73, 0x4ec36b, 0x5ec962, 0x70cf57, 0x84d44b,
    0x98d83e, 0xaddc30, 0xc2df23, 0xd8e219, 0xece51b, 0xfde725};
constexpr std::array kCividis = {
    0x00224e, 0x00285b, 0x002e6a, 0x053371, 0x1a386f, 0x273e6e, 0x32436d, 0x3b496c, 0x434e6c,
    0x4b546c, 0x535a6d, 0x5a5f6e, 0x61656f, 0x686a71, 0x6f7073, 0x767676, 0x7d7c78, 0x848279,
    0x8c8878, 0x938e78, 0x9b9476, 0xa39a74, 0xaba072, 0xb4a76f, 0xbcae6c, 0xc4b468, 0xcdbb63,
    0xd5c25e, 0xdec958, 0xe7d150, 0xf0d846, 0xf9e03a, 0xfee838};
constexpr std::array kCoolwarm = {
    0x3b4cc0, 0x445acc, 0x4e68d8, 0x5875e1, 0x6282ea, 0x6c8ff1, 0x779af7, 0x82a6fb, 0x8db0fe,
    0x98b9ff, 0xa3c2fe, 0xaec9fc, 0xb9d0f9, 0xc3d5f4, 0xccd9ed, 0xd5dbe5, 0xdddcdc, 0xe5d8d1,
    0xecd3c5, 0xf1ccb8, 0xf5c4ac, 0xf7ba9f, 0xf7b093, 0xf6a586, 0xf4987a, 0xf08b6e, 0xeb7d62,
    0xe46e56, 0xdd5f4b, 0xd44e41, 0xca3b37, 0xbe242e, 0xb40426};
constexpr std::array kThesis = {0x0000ff, 0x00ffff, 0x00ff00, 0xffff00, 0xff0000};
constexpr std::array kGray = {0x303030, 0xf5f5f5};

std::uint8_t channel(const Polynomial& coefficients, double x) {
  double value = 0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) value = value * x + *c;
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

Colors turbo() {
  Colors colors;
  for (int i = 0; i < kScaleColors; ++i) {
    const double x = kTurboFirst + (kTurboLast - kTurboFirst) * i / (kScaleColors - 1);
    colors[static_cast<std::size_t>(i)] = {channel(kRed, x), channel(kGreen, x), channel(kBlue, x)};
  }
  return colors;
}

Colors through(std::span<const int> stations) {
  Colors colors;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double place = static_cast<double>(i * (stations.size() - 1)) / (kScaleColors - 1);
    const auto first = std::min(static_cast<std::size_t>(place), stations.size() - 2);
    const double part = place - static_cast<double>(first);
    const auto channel = [&](int shift) {
      const int from = stations[first] >> shift & 255, to = stations[first + 1] >> shift & 255;
      return static_cast<std::uint8_t>(std::lround(from + part * (to - from)));
    };
    colors[i] = {channel(16), channel(8), channel(0)};
  }
  return colors;
}

/// Returns the largest of 1, 2, 5 times a power of ten that fits into `range` at least three times.
double round_step(double range) {
  const double power = std::pow(10.0, std::floor(std::log10(range / 3)));
  for (const double factor : {5.0, 2.0})
    if (range / (factor * power) >= 3 - 1e-9) return factor * power;
  return power;
}

}  // namespace

const std::vector<std::pair<std::string, ColorMap>>& color_maps() {
  static const std::vector<std::pair<std::string, ColorMap>> names = {
      {"turbo", ColorMap::turbo},     {"viridis", ColorMap::viridis},
      {"cividis", ColorMap::cividis}, {"coolwarm", ColorMap::coolwarm},
      {"gray", ColorMap::gray},       {"thesis", ColorMap::thesis}};
  return names;
}

const std::array<Rgb, kScaleColors>& scale_colors(ColorMap map) {
  // The maps are in the order of ColorMap.
  static const std::array<Colors, 6> all = {turbo(),           through(kViridis),
                                            through(kCividis), through(kCoolwarm),
                                            through(kGray),    through(kThesis)};
  return all[static_cast<std::size_t>(map)];
}

Rgb scale_color(const PressureScale& scale, double pressure) {
  const double place = std::clamp((pressure - scale.min) / (scale.max - scale.min), 0.0, 1.0);
  return scale_colors(
      scale.colors)[static_cast<std::size_t>(std::lround(place * (kScaleColors - 1)))];
}

std::string scale_name(Pressure shows) {
  switch (shows) {
    case Pressure::hydrostatic:
      return "hydrostatic pressure on the wetted surface";
    case Pressure::dynamic:
      return "dynamic pressure on the wetted surface";
    case Pressure::total:
      break;
  }
  return "pressure on the wetted surface";
}

std::vector<Tick> round_ticks(const PressureScale& scale) {
  const double low = scale.min / 1000, range = (scale.max - scale.min) / 1000;
  const double step = round_step(range);
  // A tolerance of 1/2000 of a step keeps the tick of a round end despite rounding.
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

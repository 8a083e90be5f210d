#pragma once

#include <algorithm>
#include <cmath>

/// @file
/// The curve of sRGB (IEC 61966-2-1), between light and the values that a screen displays.

namespace render {

/// Returns the value as displayed of a linear share of light; shares beyond 0 … 1 are clamped.
inline float displayed(float light) {
  const float share = std::clamp(light, 0.0F, 1.0F);
  return share <= 0.0031308F ? 12.92F * share : 1.055F * std::pow(share, 1 / 2.4F) - 0.055F;
}

/// Returns the linear share of light of a displayed value.
inline double light_of(double shown) {
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

}  // namespace render

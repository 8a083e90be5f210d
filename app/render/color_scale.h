#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/render/image.h"

namespace render {

/// The ends of the colour scale [Pa].
struct PressureScale {
  double min = 0;
  double max = 1;
};

/// Number of colours that the scale is made of.
inline constexpr int kScaleColors = 256;

/// The colours from the low to the high end: blue, cyan, green, yellow, red. It is the part from
/// 0.09 to 0.92 of Turbo [M19], whose hue runs one way and whose lightness has no false edges; its
/// near-black ends are cut, since they would not show shape.
///
/// [M19] A. Mikhailov, Turbo, an improved rainbow colormap for visualization, Google 2019; the
///       polynomial by R. Bruna.
const std::array<Rgb, kScaleColors>& scale_colors();

/// The colour of a pressure [Pa]; beyond the ends the ends' colours hold.
Rgb scale_color(const PressureScale& scale, double pressure);

/// A mark on the scale.
struct Tick {
  double place = 0;   ///< 0 at the low end, 1 at the high end.
  std::string label;  ///< In kPa, without the unit.
};

/// Ticks at round values of kPa (1, 2 or 5 times a power of ten apart), between three and eight.
std::vector<Tick> round_ticks(const PressureScale& scale);

}  // namespace render

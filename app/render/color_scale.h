#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "app/render/image.h"

namespace render {

/// Colour maps, from low to high values.
///
/// - `turbo`: blue, cyan, green, yellow, red; the part from 0.09 to 0.92 of Turbo [M19], whose hue
///   runs one way and whose lightness has no false edges. Its near-black ends are cut, since they
///   would not show shape.
/// - `viridis`, `cividis`: even in lightness, also for colour-blind eyes [vdW15, N18].
/// - `coolwarm`: blue to red over a pale middle [M09], for values of both signs.
/// - `gray`: dark to light.
/// - `thesis`: blue, cyan, green, yellow, red, fully saturated, as the gradient that the project's
///   method was first shown with.
///
/// [M19]   A. Mikhailov, Turbo, an improved rainbow colormap for visualization, Google 2019; the
///         polynomial by R. Bruna.
/// [vdW15] S. van der Walt, N. Smith, A better default colormap for Matplotlib, SciPy 2015.
/// [N18]   J. Nunez, C. Anderton, R. Renslow, Optimizing colormaps with consideration for color
///         vision deficiency, PLoS ONE 13 (2018).
/// [M09]   K. Moreland, Diverging color maps for scientific visualization, ISVC 2009.
enum class ColorMap { turbo, viridis, cividis, coolwarm, gray, thesis };

/// Returns all colour maps with their names.
const std::vector<std::pair<std::string, ColorMap>>& color_maps();

/// Part of the gauge pressure on a wetted surface that is shown: ρ g h, ½ ρ C_p v_n |v_n|, or their
/// sum.
enum class Pressure { total, hydrostatic, dynamic };

/// A pressure scale and its ends [Pa].
struct PressureScale {
  double min = 0;
  double max = 1;
  ColorMap colors = ColorMap::turbo;
  Pressure shows = Pressure::total;
  bool below = false, above = false;  ///< True: pictures have pressures beyond that end.
};

/// Returns the name of the pressure that a scale shows, without the unit.
std::string scale_name(Pressure shows);

/// Number of colours in a scale.
inline constexpr int kScaleColors = 256;

const std::array<Rgb, kScaleColors>& scale_colors(ColorMap map = ColorMap::turbo);

/// Returns the colour of a pressure [Pa], which is clamped to the ends of the scale.
Rgb scale_color(const PressureScale& scale, double pressure);

/// Period of the stripes that mark pressures beyond the ends of a scale, in pictures of up to 720
/// lines [px]. The colour of the end alternates with white above the scale and with black below.
inline constexpr double kStripe = 10;

/// A mark on the scale.
struct Tick {
  double place = 0;   ///< 0 at the low end, 1 at the high end.
  std::string label;  ///< Value in kPa, without the unit.
};

/// Returns three to eight ticks at round values in kPa, 1, 2 or 5 times a power of ten apart.
std::vector<Tick> round_ticks(const PressureScale& scale);

}  // namespace render

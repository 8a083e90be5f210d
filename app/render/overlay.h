#pragma once

#include <optional>

#include "app/render/color_scale.h"
#include "app/render/image.h"

namespace render {

/// Puts the time [s] and the distance of the grid's lines [m], upper left, and the labelled
/// pressure scale, lower right, on a picture. Text grows with the picture. Without a scale (a dry
/// scene), or a grid, none of it. A picture of less than 120
/// pixels either way is left as it is.
void add_overlay(Image& image, const std::optional<PressureScale>& scale, double time,
                 double grid = 0);

/// The pressure scale lying, for a figure: bar, ticks and name, on white.
Image lying_scale(const PressureScale& scale, int width, int text_size);

/// The time as pictures show it: `t = 0.30 s`.
std::string time_label(double time);

}  // namespace render

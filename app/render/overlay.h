#pragma once

#include <optional>

#include "app/render/color_scale.h"
#include "app/render/image.h"

namespace render {

/// Puts the time [s], the distance of the grid's lines [m] and more lines, upper left, and the
/// labelled pressure scale, lower right, on a picture. Text grows with the picture. Without a scale
/// (a dry scene), or a grid, none of it. A picture that is too small for text is left as it is.
void add_overlay(Image& image, const std::optional<PressureScale>& scale, double time,
                 double grid = 0, const std::vector<std::string>& more = {});

/// Puts lines of text, upper right.
void add_lines_right(Image& image, const std::vector<std::string>& lines);

/// The pressure scale lying, for a figure: bar, ticks and name, on white.
Image lying_scale(const PressureScale& scale, int width, int text_size);

/// The time as pictures show it: `t = 0.30 s`.
std::string time_label(double time);

}  // namespace render

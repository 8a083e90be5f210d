#pragma once

#include <optional>

#include "app/render/color_scale.h"
#include "app/render/image.h"

namespace render {

/// Writes the time [s], the spacing of the grid lines [m] and more lines at the upper left of a
/// picture, and draws the labelled pressure scale at the lower right. The text size follows the
/// picture's. A missing scale (a dry scene) or grid is left out. A picture that is too small for
/// text stays unchanged.
void add_overlay(Image& image, const std::optional<PressureScale>& scale, double time,
                 double grid = 0, const std::vector<std::string>& more = {});

/// Writes lines of text at the upper right.
void add_lines_right(Image& image, const std::vector<std::string>& lines);

/// Returns a horizontal pressure scale for a figure: bar, ticks and name on white.
Image lying_scale(const PressureScale& scale, int width, int text_size);

/// Returns the time as pictures show it: `t = 0.30 s`.
std::string time_label(double time);

}  // namespace render

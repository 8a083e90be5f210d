#pragma once

#include <cmath>
#include <string>
#include <vector>

/// @file
/// Plots of lines in panels side by side, as SVG.

namespace app {

// Size of a panel [px].
inline constexpr double kPanelWidth = 300, kPanelHeight = 180;

/// A place in the picture and the ranges of its axes.
struct PlotPanel {
  double left = 0, top = 0;  ///< [px]
  double least_x = 0, most_x = 1, least_y = 0, most_y = 1;

  double x(double value) const {
    return left + kPanelWidth * (value - least_x) / (most_x - least_x);
  }
  double y(double value) const {
    return top + kPanelHeight * (most_y - value) / (most_y - least_y);
  }
};

/// The place of a panel, both counted from 0.
PlotPanel panel_at(int column, int row);

/// A text with its anchor `start`, `middle` or `end` at a place.
/// @param more   Further attributes, each after a space.
std::string svg_text(double x, double y, const char* anchor, const std::string& text,
                     const std::string& more = "");

/// The border of a panel with its title, and the marks and label of its x axis.
std::string panel_frame(const PlotPanel& panel, const std::string& title,
                        const std::string& x_label);

/// A quantity over that of the x axis.
struct PlotLine {
  std::string name;
  std::vector<double> x, y;
  double limit = std::nan("");  ///< Its limit for large x, drawn dashed.
};

/// A panel of lines, each with a colour of its own. The y axis has the range of the lines.
/// @param panel       With the range of its x axis.
/// @param from_zero   The y axis begins at zero if no value is negative.
std::string line_panel(PlotPanel panel, const std::string& title, const std::string& x_label,
                       const std::vector<PlotLine>& lines, bool from_zero = true);

/// A picture of so many columns and rows of panels under a title. @param title   Without markup.
/// @param scale   Size of the picture over that of its panels.
std::string panel_picture(int columns, int rows, const std::string& title,
                          const std::string& panels, double scale = 1);

}  // namespace app

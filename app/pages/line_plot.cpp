#include "app/pages/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "app/base/quoting.h"

namespace app {
namespace {

/// Colours of lines that colour-blind eyes tell apart (Okabe and Ito).
constexpr const char* kLineColors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                       "#e69f00", "#56b4e9", "#555555"};

// Lengths of the picture [px].
constexpr double kLeft = 80, kTop = 70;
constexpr double kColumn = kPanelWidth + 90, kRow = kPanelHeight + 75;
constexpr double kLetter = 8;  ///< Mean width of a letter.
constexpr int kTicks = 5;

/// A step of 1, 2 or 5 times a power of ten that divides a range in some five.
double step_of(double range) {
  const double rough = range / kTicks, power = std::pow(10, std::floor(std::log10(rough)));
  const double digits = rough / power;
  return power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
}

/// Part of a range by which a mark may lie beyond its ends, for round-off [-].
constexpr double kMarkRoundOff = 1e-9;

/// The multiples of a step in a range.
std::vector<double> marks_of(double least, double most) {
  const double step = step_of(most - least), beyond = kMarkRoundOff * (most - least);
  std::vector<double> marks;
  for (double i = std::ceil((least - beyond) / step); i * step <= most + beyond; ++i)
    marks.push_back(i * step + 0.0);  // no -0
  return marks;
}

std::string y_axis(const PlotPanel& p) {
  std::string svg;
  for (const double mark : marks_of(p.least_y, p.most_y)) {
    const double y = p.y(mark);
    svg += fmt::format(
        "<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", p.left,
        p.left + kPanelWidth, y, y, mark == 0 ? "#888" : "#ddd");
    svg += svg_text(p.left - 6, y + 4, "end", fmt::format("{:.4g}", mark));
  }
  return svg;
}

std::string polyline(const PlotPanel& p, const PlotLine& line, const char* color) {
  std::string points;
  for (std::size_t i = 0; i < line.x.size(); ++i)
    points += fmt::format("{:.1f},{:.1f} ", p.x(line.x[i]), p.y(line.y[i]));
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n",
                     points, color);
}

/// Sets the range of the y axis to that of the lines, with some room.
void set_y_range(const std::vector<PlotLine>& lines, bool from_zero, PlotPanel& p) {
  double least = from_zero ? 0 : std::numeric_limits<double>::infinity(), most = -least;
  for (const PlotLine& line : lines) {
    for (const double value : line.y) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
    if (std::isfinite(line.limit)) most = std::max(most, line.limit);
  }
  const double size = std::max(std::abs(least), std::abs(most));
  // A line that is level but for round-off lies in the middle.
  const bool level = !(most - least > 1e-9 * size);
  const double room = level ? (size > 0 ? 0.5 * size : 1) : 0.05 * (most - least);
  p.most_y = most + room;
  p.least_y = from_zero && least == 0 ? 0 : least - room;
}

}  // namespace

PlotPanel panel_at(int column, int row) {
  return {.left = kLeft + column * kColumn, .top = kTop + row * kRow};
}

std::string svg_text(double x, double y, const char* anchor, const std::string& text,
                     const std::string& more) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, more, text);
}

std::string panel_frame(const PlotPanel& p, const std::string& title, const std::string& x_label) {
  std::string svg = fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
      "stroke=\"#555\"/>\n",
      p.left, p.top, kPanelWidth, kPanelHeight);
  svg += svg_text(p.left, p.top - 8, "start", title, " font-weight=\"bold\"");
  for (const double mark : marks_of(p.least_x, p.most_x))
    svg += svg_text(p.x(mark), p.top + kPanelHeight + 15, "middle", fmt::format("{:.4g}", mark));
  return svg + svg_text(p.left + kPanelWidth / 2, p.top + kPanelHeight + 31, "middle", x_label);
}

std::string line_panel(PlotPanel p, const std::string& title, const std::string& x_label,
                       const std::vector<PlotLine>& lines, bool from_zero) {
  set_y_range(lines, from_zero, p);
  std::string svg = y_axis(p) + panel_frame(p, title, x_label);
  double right = p.left + kPanelWidth;
  for (std::size_t i = lines.size(); i-- > 0;) {
    const PlotLine& line = lines[i];
    const char* const color = kLineColors[i % std::size(kLineColors)];
    svg += polyline(p, line, color);
    if (std::isfinite(line.limit))
      svg += fmt::format(
          "<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
          "stroke-dasharray=\"5 4\"/>\n",
          p.left, p.left + kPanelWidth, p.y(line.limit), p.y(line.limit), color);
    if (line.name.empty()) continue;
    svg +=
        svg_text(right, p.top - 8, "end", xml_text(line.name), fmt::format(" fill=\"{}\"", color));
    right -= kLetter * static_cast<double>(line.name.size() + 1);
  }
  return svg;
}

std::string panel_picture(int columns, int rows, const std::string& title,
                          const std::string& panels, double scale) {
  const double width = kLeft + columns * kColumn - 60, height = kTop + rows * kRow;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{2:g}\" height=\"{3:g}\" "
             "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"DejaVu Sans, sans-serif\" "
             "font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
             width, height, scale * width, scale * height) +
         svg_text(kLeft, 28, "start", xml_text(title), " font-size=\"16\"") + panels + "</svg>\n";
}

}  // namespace app

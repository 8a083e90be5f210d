#include "app/commands/radiation_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/base/quoting.h"
#include "app/render/color_scale.h"

namespace app {
namespace {

using Eigen::Index;
using std::numbers::pi;

constexpr const char* kNames[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
/// Colours of three lines that colour-blind eyes tell apart (Okabe and Ito).
constexpr const char* kLines[] = {"#0072b2", "#d55e00", "#009e73"};

// Lengths of the picture [px].
constexpr double kPanelWidth = 300, kPanelHeight = 180, kLeft = 80, kTop = 70;
constexpr double kColumn = kPanelWidth + 90, kRow = kPanelHeight + 75;
constexpr int kTicks = 5;

/// A quantity over the frequency.
struct Line {
  std::string name;
  std::vector<double> values;
  double limit = std::nan("");  ///< For high frequency, drawn dashed.
};

/// A place of a panel and its axes.
struct Panel {
  double left, top;
  double most_x, least_y, most_y;

  double x(double value) const { return left + kPanelWidth * value / most_x; }
  double y(double value) const {
    return top + kPanelHeight * (most_y - value) / (most_y - least_y);
  }
};

Panel panel_at(int column, int row, double most_x) {
  return {kLeft + column * kColumn, kTop + row * kRow, most_x, 0, 1};
}

/// A step of 1, 2 or 5 times a power of ten that divides a range in some five.
double step_of(double range) {
  const double rough = range / kTicks, power = std::pow(10, std::floor(std::log10(rough)));
  const double digits = rough / power;
  return power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
}

std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, more, text);
}

std::string frame(const Panel& p, const std::string& title) {
  std::string svg = fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
      "stroke=\"#555\"/>\n",
      p.left, p.top, kPanelWidth, kPanelHeight);
  svg += text_at(p.left, p.top - 8, "start", title, " font-weight=\"bold\"");
  const double step = step_of(p.most_x);
  for (double x = 0; x <= p.most_x; x += step)
    svg += text_at(p.x(x), p.top + kPanelHeight + 15, "middle", fmt::format("{:g}", x));
  return svg + text_at(p.left + kPanelWidth / 2, p.top + kPanelHeight + 31, "middle", "ω [rad/s]");
}

std::string y_axis(const Panel& p) {
  std::string svg;
  const double step = step_of(p.most_y - p.least_y);
  for (double i = std::ceil(p.least_y / step); i * step <= p.most_y; ++i) {
    const double y = p.y(i * step);
    svg += fmt::format(
        "<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#ddd\"/>\n", p.left,
        p.left + kPanelWidth, y, y);
    svg += text_at(p.left - 6, y + 4, "end", fmt::format("{:.3g}", i * step));
  }
  return svg;
}

std::string polyline(const Panel& p, const std::vector<double>& x, const std::vector<double>& y,
                     const char* color) {
  std::string points;
  for (std::size_t i = 0; i < x.size(); ++i)
    points += fmt::format("{:.1f},{:.1f} ", p.x(x[i]), p.y(y[i]));
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n",
                     points, color);
}

std::string line_panel(Panel p, const std::string& title, const std::vector<double>& frequencies,
                       const std::array<Line, 3>& lines) {
  double least = 0, most = 0;
  for (const Line& line : lines) {
    for (const double value : line.values) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
    if (std::isfinite(line.limit)) most = std::max(most, line.limit);
  }
  const double room = 0.05 * (most > least ? most - least : 1);
  p.most_y = most + room;
  p.least_y = least < 0 ? least - room : 0;
  std::string svg = y_axis(p) + frame(p, title);
  for (std::size_t i = 0; i < 3; ++i) {
    svg += polyline(p, frequencies, lines[i].values, kLines[i]);
    if (std::isfinite(lines[i].limit))
      svg += fmt::format(
          "<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
          "stroke-dasharray=\"5 4\"/>\n",
          p.left, p.left + kPanelWidth, p.y(lines[i].limit), p.y(lines[i].limit), kLines[i]);
    svg += text_at(p.left + kPanelWidth - 45 * static_cast<double>(2 - i), p.top - 8, "end",
                   lines[i].name, fmt::format(" fill=\"{}\"", kLines[i]).c_str());
  }
  return svg;
}

/// |X| of a motion: a row a frequency, a column a heading.
Eigen::MatrixXd magnitudes(const hydro::RadiationData& data, Index motion, double density) {
  Eigen::MatrixXd all(static_cast<Index>(data.frequencies.size()),
                      static_cast<Index>(data.headings.size()));
  for (Index f = 0; f < all.rows(); ++f) {
    const auto i = static_cast<std::size_t>(f);
    all.row(f) =
        density * (data.froude_krylov[i].row(motion) + data.diffraction[i].row(motion)).cwiseAbs();
  }
  return all;
}

/// Ends of the cells about points: their middles, and the first and the last point.
std::vector<double> cell_ends(const std::vector<double>& points) {
  std::vector<double> ends = {points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) ends.push_back((points[i - 1] + points[i]) / 2);
  ends.push_back(points.back());
  return ends;
}

std::string heading_panel(Panel p, const std::string& title, const hydro::RadiationData& data,
                          const Eigen::MatrixXd& X) {
  p.least_y = 0;
  p.most_y = 360;
  const double most = X.maxCoeff();
  const auto& colors = render::scale_colors(render::ColorMap::viridis);
  const std::vector<double> ends = cell_ends(data.frequencies);
  const double height = kPanelHeight / static_cast<double>(X.cols());
  std::string svg;
  for (Index f = 0; f < X.rows(); ++f)
    for (Index h = 0; h < X.cols(); ++h) {
      const auto i = static_cast<std::size_t>(f);
      const double part = most > 0 ? X(f, h) / most : 0;
      const render::Rgb& c =
          colors[static_cast<std::size_t>(std::lround(part * (render::kScaleColors - 1)))];
      const auto add_cell = [&](double middle) {
        const double top = std::max(p.y(middle) - height / 2, p.top);
        const double bottom = std::min(p.y(middle) + height / 2, p.top + kPanelHeight);
        svg += fmt::format(
            "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
            "fill=\"#{:02x}{:02x}{:02x}\"/>\n",
            p.x(ends[i]), top, p.x(ends[i + 1]) - p.x(ends[i]) + 0.3, bottom - top + 0.3, c.r, c.g,
            c.b);
      };
      const double heading = data.headings[static_cast<std::size_t>(h)] * 180 / pi;
      add_cell(heading);
      if (heading == 0) add_cell(360);
    }
  svg += frame(p, fmt::format("{}, up to {:.3g}", title, most));
  for (int degrees = 0; degrees <= 360; degrees += 90)
    svg += text_at(p.left - 6, p.y(degrees) + 4, "end", fmt::format("{}°", degrees));
  return svg;
}

Line diagonal(const std::vector<hydro::Matrix6d>& matrices, Index motion, double density) {
  Line line{.name = kNames[motion], .values = {}};
  for (const hydro::Matrix6d& matrix : matrices)
    line.values.push_back(density * matrix(motion, motion));
  return line;
}

std::array<Line, 3> three(Index first, const auto& line_of) {
  return {line_of(first), line_of(first + 1), line_of(first + 2)};
}

}  // namespace

std::string radiation_svg(const std::string& body, const hydro::RadiationData& data,
                          double density) {
  const bool waves = !data.headings.empty();
  const double most = data.frequencies.back();
  std::string panels;
  for (int row = 0; row < 2; ++row) {
    const Index first = 3 * row;
    const auto added_mass = [&](Index motion) {
      Line line = diagonal(data.added_mass, motion, density);
      line.limit = density * data.infinite_added_mass(motion, motion);
      return line;
    };
    const auto damping = [&](Index motion) { return diagonal(data.damping, motion, density); };
    const auto load = [&](Index motion) {
      const Eigen::VectorXd largest = magnitudes(data, motion, density).rowwise().maxCoeff();
      return Line{.name = kNames[motion], .values = {largest.begin(), largest.end()}};
    };
    const bool forces = row == 0;
    panels +=
        line_panel(panel_at(0, row, most), forces ? "added mass A [kg]" : "added mass A [kg m²]",
                   data.frequencies, three(first, added_mass));
    panels +=
        line_panel(panel_at(1, row, most), forces ? "damping B [kg/s]" : "damping B [kg m²/s]",
                   data.frequencies, three(first, damping));
    if (!waves) continue;
    panels +=
        line_panel(panel_at(2, row, most), forces ? "largest |X| [N/m]" : "largest |X| [N m/m]",
                   data.frequencies, three(first, load));
    for (int column = 0; column < 3; ++column)
      panels += heading_panel(panel_at(column, 2 + row, most),
                              fmt::format("|X| over heading, {}", kNames[first + column]), data,
                              magnitudes(data, first + column, density));
  }
  const double width = kLeft + (waves ? 3 : 2) * kColumn - 60,
               height = kTop + (waves ? 4 : 2) * kRow;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" "
             "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"DejaVu Sans, sans-serif\" "
             "font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
             width, height) +
         text_at(kLeft, 28, "start",
                 fmt::format("{}: radiation and diffraction, {:g} kg/m³; dashed: the limit of high "
                             "frequency",
                             xml_text(body), density),
                 " font-size=\"16\"") +
         panels + "</svg>\n";
}

}  // namespace app

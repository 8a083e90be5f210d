#include "app/commands/radiation_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/pages/line_plot.h"
#include "app/render/color_scale.h"

namespace app {
namespace {

using Eigen::Index;
using std::numbers::pi;

constexpr const char* kNames[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
constexpr const char* kFrequencyAxis = "ω [rad/s]";

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

std::string heading_panel(PlotPanel p, const std::string& title, const hydro::RadiationData& data,
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
  svg += panel_frame(p, fmt::format("{}, up to {:.3g}", title, most), kFrequencyAxis);
  for (int degrees = 0; degrees <= 360; degrees += 90)
    svg += svg_text(p.left - 6, p.y(degrees) + 4, "end", fmt::format("{}°", degrees));
  return svg;
}

PlotLine diagonal(const hydro::RadiationData& data, const std::vector<hydro::Matrix6d>& matrices,
                  Index motion, double density) {
  PlotLine line{.name = kNames[motion], .x = data.frequencies, .y = {}};
  for (const hydro::Matrix6d& matrix : matrices) line.y.push_back(density * matrix(motion, motion));
  return line;
}

std::vector<PlotLine> three(Index first, const auto& line_of) {
  return {line_of(first), line_of(first + 1), line_of(first + 2)};
}

}  // namespace

std::string radiation_svg(const std::string& body, const hydro::RadiationData& data,
                          double density) {
  const bool waves = !data.headings.empty();
  std::string panels;
  const auto at = [&](int column, int row) {
    PlotPanel panel = panel_at(column, row);
    panel.most_x = data.frequencies.back();
    return panel;
  };
  for (int row = 0; row < 2; ++row) {
    const Index first = 3 * row;
    const auto added_mass = [&](Index motion) {
      PlotLine line = diagonal(data, data.added_mass, motion, density);
      line.limit = density * data.infinite_added_mass(motion, motion);
      return line;
    };
    const auto damping = [&](Index motion) {
      return diagonal(data, data.damping, motion, density);
    };
    const auto load = [&](Index motion) {
      const Eigen::VectorXd largest = magnitudes(data, motion, density).rowwise().maxCoeff();
      return PlotLine{
          .name = kNames[motion], .x = data.frequencies, .y = {largest.begin(), largest.end()}};
    };
    const bool forces = row == 0;
    panels += line_panel(at(0, row), forces ? "added mass A [kg]" : "added mass A [kg m²]",
                         kFrequencyAxis, three(first, added_mass));
    panels += line_panel(at(1, row), forces ? "damping B [kg/s]" : "damping B [kg m²/s]",
                         kFrequencyAxis, three(first, damping));
    if (!waves) continue;
    panels += line_panel(at(2, row), forces ? "largest |X| [N/m]" : "largest |X| [N m/m]",
                         kFrequencyAxis, three(first, load));
    for (int column = 0; column < 3; ++column)
      panels += heading_panel(at(column, 2 + row),
                              fmt::format("|X| over heading, {}", kNames[first + column]), data,
                              magnitudes(data, first + column, density));
  }
  return panel_picture(
      waves ? 3 : 2, waves ? 4 : 2,
      fmt::format("{}: radiation and diffraction, {:g} kg/m³; dashed: the limit of high frequency",
                  body, density),
      panels);
}

}  // namespace app
